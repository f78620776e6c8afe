// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "structure/gemmi/cif_file.h"

// gemmi is not written for our warnings.
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wall"
#pragma GCC diagnostic ignored "-Wextra"
#include <gemmi/cif.hpp>
#pragma GCC diagnostic pop

#include <algorithm>
#include <array>
#include <cstddef>
#include <deque>
#include <new>
#include <optional>
#include <set>
#include <string_view>
#include <utility>
#include <vector>

#include "meniscus/errors.h"
#include "reading/text.h"
#include "structure/bcif_tables.h"
#include "structure/cif_atoms.h"
#include "structure/gemmi/gemmi_shared.h"
#include "structure/residue_list.h"

namespace meniscus::reading {
namespace {

// What gemmi says behind the name of the file, with a place of lines and columns alone: ":12:5: what" for ":12:5(340):
// what" of its parser, and for ":12 in data_1ABC: what" of its checks, which know where a loop or a pair begins.
std::string tidy_message(const std::string& message) {
    const std::size_t behind_place = std::min(message.find_first_not_of(":0123456789"), message.size());
    const std::string_view rest = std::string_view(message).substr(behind_place);
    const bool has_block = gemmi::starts_with(std::string(rest), " in data_");
    const std::size_t end = rest.find(": ");
    if (end == std::string_view::npos || (!has_block && rest[0] != '(')) return message;
    return message.substr(0, behind_place) + (has_block ? ":1" : "") + std::string(rest.substr(end));
}

bool all_begin_with(const gemmi::cif::Loop& loop, const std::string& prefix) {
    return std::all_of(loop.tags.begin(), loop.tags.end(),
                       [&](const std::string& tag) { return gemmi::istarts_with(tag, prefix); });
}

// The atoms of a block. gemmi's loop holds the first row of them alone: of a large structure all of them, as strings of
// their own, take more time and memory than everything else about reading it.
struct AtomLoop {
    std::size_t block;                     // its place in the document
    std::vector<std::string_view> values;  // row after row, in the file's text
};

// What gemmi's rules fill.
struct Document : gemmi::cif::Document {
    std::vector<AtomLoop> atom_loops;  // in the order of their blocks
    bool is_of_atoms = false;          // the loop that is being read, from its first value on

    std::vector<std::string>& values() { return items_->back().loop.values; }
    std::vector<std::string_view>& atom_values() { return atom_loops.back().values; }

    // Before the first value of a loop, and perhaps before later ones.
    void begin_values() {
        const gemmi::cif::Loop& loop = items_->back().loop;
        if (is_of_atoms || !loop.values.empty()) return;
        is_of_atoms = items_ == &blocks.back().items && all_begin_with(loop, "_atom_site.");
        if (is_of_atoms) atom_loops.push_back({blocks.size() - 1, {}});
    }

    // How many values the loop has that ends here.
    std::size_t end_values() {
        gemmi::cif::Loop& loop = items_->back().loop;
        if (!std::exchange(is_of_atoms, false)) return loop.values.size();
        const std::vector<std::string_view>& all = atom_values();
        loop.values.assign(all.begin(), all.begin() + static_cast<std::ptrdiff_t>(std::min(all.size(), loop.width())));
        return all.size();
    }
};

// Room is made for the rest of a long loop, where doubling would move all values again and again, and take three times
// their memory meanwhile. How many there will be is told from how many the loop has given to all the text before: too
// few behind a long header, so that the loop grows in several steps there. By its own text alone every long loop would
// reserve for all those behind it, too, which adds up to the square of their number.
template <class Value, class Input>
void add_value(std::vector<Value>& values, const char* begin, const char* end, const Input& in) {
    constexpr std::size_t kMany = 4096;
    if (values.size() == values.capacity() && values.size() >= kMany)
        values.reserve(values.size() + values.size() * in.size() / in.byte() + kMany);
    values.emplace_back(begin, static_cast<std::size_t>(end - begin));
}

bool is_ordinary(char c) { return gemmi::cif::char_table(c) == 1; }
bool is_space(char c) { return gemmi::cif::char_table(c) == 2; }

// The zero behind the text's end is not ordinary.
const char* behind_ordinary(const char* at) {
    while (is_ordinary(*at)) ++at;
    return at;
}

// Takes values of a loop that are of ordinary characters alone, as nearly all are, as long as another such follows: the
// last one may be the beginning of something else.
template <class Value, class Input>
void take_plain_values(Input& in, std::vector<Value>& values) {
    const char* told = in.current();  // behind what the input knows to be taken
    const char* value = told;
    const char* behind = behind_ordinary(value);
    while (behind != value && is_space(*behind)) {
        const char* next = behind;
        bool ends_line = false;
        do ends_line |= *next == '\n';
        while (is_space(*++next));
        const char* const behind_next = behind_ordinary(next);
        if (behind_next == next || !is_space(*behind_next)) break;
        add_value(values, value, behind, in);
        if (ends_line) {
            in.bump_in_this_line(static_cast<std::size_t>(behind - told));
            in.bump(static_cast<std::size_t>(next - behind));
            told = next;
        }
        value = next;
        behind = behind_next;
    }
    in.bump_in_this_line(static_cast<std::size_t>(value - told));
}

// As gemmi fills its document, but sooner.
template <class Rule>
struct QuickAction : gemmi::cif::Action<Rule> {};
template <>
struct QuickAction<gemmi::cif::rules::loop_value> {
    template <class Rule, tao::pegtl::apply_mode kApply, tao::pegtl::rewind_mode kRewind,
              template <class...> class Action, template <class...> class Control, class Input>
    static bool match(Input& in, Document& document) {
        document.begin_values();
        if (document.is_of_atoms)
            take_plain_values(in, document.atom_values());
        else
            take_plain_values(in, document.values());
        return tao::pegtl::match<Rule, kApply, kRewind, Action, Control>(in, document);
    }
    template <class Input>
    static void apply(const Input& in, Document& document) {
        if (document.is_of_atoms)
            add_value(document.atom_values(), in.begin(), in.end(), in.input());
        else
            add_value(document.values(), in.begin(), in.end(), in.input());
    }
};
template <>
struct QuickAction<gemmi::cif::rules::loop> {
    template <class Input>
    static void apply(const Input& in, Document& document) {
        if (document.end_values() % document.items_->back().loop.width() != 0)
            throw tao::pegtl::parse_error("Wrong number of values in the loop", in);
    }
};

Document parse_cif(const std::string& text, const std::string& file) {
    try {
        Document document;
        document.source = file;
        tao::pegtl::memory_input<> input(text.data(), text.size(), file);
        tao::pegtl::parse<gemmi::cif::rules::file, QuickAction, gemmi::cif::Errors>(input, document);
        gemmi::cif::check_for_missing_values(document);
        gemmi::cif::check_for_duplicates(document);
        return document;
    } catch (const std::bad_alloc&) {
        throw;
    } catch (const std::exception& error) {
        const std::string message = error.what();
        const std::string own = gemmi::starts_with(message, file + ":") ? message.substr(file.size()) : ": " + message;
        throw InputError(file + printable(tidy_message(own), kOfGemmi) +
                         "; this is not valid CIF, correct it or fetch the file again");
    }
}

// ---- BinaryCIF

// All that is asked of a document below.
bool is_asked_for(std::string_view tag) {
    constexpr std::array kTags{"_atom_site.", "_pdbx_struct_assembly.", "_pdbx_struct_assembly_gen.",
                               "_pdbx_struct_assembly_prop.", "_pdbx_struct_oper_list."};
    const std::string text(tag);
    return gemmi::iequal(text, "_entity.id") || gemmi::iequal(text, "_entity.type") ||
           std::any_of(kTags.begin(), kTags.end(), [&](const char* start) { return gemmi::istarts_with(text, start); });
}

std::vector<std::string_view> row_by_row(const BcifCategory& category) {
    std::vector<std::string_view> values;
    values.reserve(category.rows * category.columns.size());
    for (std::size_t row = 0; row < category.rows; ++row)
        for (const BcifColumn& column : category.columns) values.push_back(column.values[row]);
    return values;
}

void add_loop(Document& document, const BcifCategory& category) {
    document.blocks.back().items.emplace_back(gemmi::cif::LoopArg{});
    gemmi::cif::Loop& loop = document.blocks.back().items.back().loop;
    for (const BcifColumn& column : category.columns) loop.tags.push_back(column.tag);
    std::vector<std::string_view> values = row_by_row(category);
    const bool is_of_atoms = all_begin_with(loop, "_atom_site.");
    const std::size_t kept = is_of_atoms ? loop.width() : values.size();
    loop.values.assign(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(kept));
    if (is_of_atoms) document.atom_loops.push_back({document.blocks.size() - 1, std::move(values)});
}

// The document that the same file as text would be. Takes the tables apart, since they are large.
Document to_document(std::vector<BcifBlock> blocks, const std::string& file) {
    Document document;
    document.source = file;
    for (BcifBlock& block : blocks) {
        document.blocks.emplace_back(block.name);
        for (BcifCategory& category : block.categories) {
            add_loop(document, category);
            category.columns.clear();
        }
    }
    return document;
}

// The first block with coordinates; an error if none has any.
gemmi::cif::Block& coordinate_block(gemmi::cif::Document& document, const std::string& file) {
    gemmi::cif::Block* other = nullptr;
    for (gemmi::cif::Block& block : document.blocks) {
        if (block.find("_atom_site.", {"Cartn_x"}).length() > 0) return block;
        if (block.find_mmcif_category("_atom_site.").length() > 0) other = &block;
        if (block.find_values("_atom_site_fract_x").length() > 0) {
            throw InputError(file + ": a small-molecule CIF with fractional coordinates; convert it to PDB or mmCIF");
        }
    }
    if (other != nullptr) throw InputError(file + ": no column _atom_site.Cartn_x; the file has no coordinates to use");
    throw InputError(file + ": no _atom_site loop, so no atoms; take the coordinate file of the entry");
}

[[noreturn]] void refuse(const std::string& file, const gemmi::cif::Item& item, const std::string& why) {
    throw InputError(file + ":" + std::to_string(item.line_number) + ":1: " + why);
}

// Which values belong to one atom is known only where all columns stand in one loop of their own, or one atom is given
// in pairs.
void check_one_table(const gemmi::cif::Block& block, const std::string& file) {
    const std::string prefix = "_atom_site.";
    const auto is_of_atoms = [&](const std::string& tag) { return gemmi::istarts_with(tag, prefix); };
    int loops = 0;
    int pairs = 0;
    for (const gemmi::cif::Item& item : block.items) {
        if (item.type == gemmi::cif::ItemType::Loop) {
            const bool has_some = std::any_of(item.loop.tags.begin(), item.loop.tags.end(), is_of_atoms);
            if (has_some && !all_begin_with(item.loop, prefix))
                refuse(file, item, "a loop of _atom_site contains other columns; give these a loop of their own");
            loops += has_some ? 1 : 0;
        } else if (item.type == gemmi::cif::ItemType::Pair) {
            pairs += is_of_atoms(item.pair[0]) ? 1 : 0;
        }
        if (loops > 1 || (loops == 1 && pairs > 0))
            refuse(file, item, "_atom_site is given a second time; put all its columns into one loop");
    }
}

// values   of all atoms; none for an atom that is given in pairs
AtomTable to_atom_table(gemmi::cif::Table table, std::vector<std::string_view> values) {
    const gemmi::cif::Loop* const loop = table.get_loop();
    AtomTable::FirstRow first;
    first.fill(AtomTable::kNone);
    for (std::size_t c = 0; c < first.size(); ++c) {
        const std::string* const value = table[0].ptr_at(static_cast<int>(c));
        if (value == nullptr) continue;
        first[c] = loop != nullptr ? static_cast<std::size_t>(value - loop->values.data()) : values.size();
        if (loop == nullptr) values.push_back(*value);
    }
    return {std::move(values), first, loop != nullptr ? loop->width() : 0};
}

// The table of atoms; an error if it has not all that is needed.
gemmi::cif::Table checked_columns(gemmi::cif::Block& block, const std::string& file) {
    check_one_table(block, file);
    const auto needs = [&](std::initializer_list<const char*> tags) {
        const auto has_column = [&](const char* tag) { return block.find_values(tag).length() > 0; };
        if (std::any_of(tags.begin(), tags.end(), has_column)) return;
        throw InputError(file + ": no column " + *tags.begin() + "; the _atom_site loop is incomplete");
    };
    needs({"_atom_site.Cartn_y"});
    needs({"_atom_site.Cartn_z"});
    needs({"_atom_site.label_atom_id", "_atom_site.auth_atom_id"});
    needs({"_atom_site.label_comp_id", "_atom_site.auth_comp_id"});
    return block.find("_atom_site.", atom_tags());
}

// Only what assemblies are made of goes to gemmi's interpretation of a block.
std::vector<RawAssembly> read_assemblies(const gemmi::cif::Block& block) {
    gemmi::cif::Block clean(block.name);
    for (const gemmi::cif::Item& item : block.items) {
        const auto is_all = [&](const std::string& category) {
            if (item.type == gemmi::cif::ItemType::Pair) return gemmi::istarts_with(item.pair[0], category);
            return item.type == gemmi::cif::ItemType::Loop && all_begin_with(item.loop, category);
        };
        const bool wanted = is_all("_pdbx_struct_assembly.") || is_all("_pdbx_struct_assembly_gen.") ||
                            is_all("_pdbx_struct_assembly_prop.") || is_all("_pdbx_struct_oper_list.");
        if (wanted) clean.items.push_back(item);
    }
    std::vector<RawAssembly> assemblies = assemblies_of(clean);
    // gemmi reads only the first factor of a product of operators, "(1-60)(61-88)": better none than half of it.
    for (auto row : clean.find("_pdbx_struct_assembly_gen.", {"assembly_id", "oper_expression"})) {
        if (row.str(1).find(")(") == std::string::npos) continue;
        for (RawAssembly& assembly : assemblies) {
            if (assembly.name == row.str(0)) assembly.generators.assign(1, RawGenerator{});
        }
    }
    return assemblies;
}

}  // namespace

struct CifFile::Content {
    std::string file;
    const std::string* text = nullptr;  // of CIF
    std::deque<std::string> values;     // of BinaryCIF; the document has views of them
    Document document;
    gemmi::cif::Block& block;
    AtomTable atoms;
    RowModels models;
    EntityIds polymers;

    Content(const std::string& content, const std::string& name) : Content(parse_cif(content, name), name, &content) {}

    Content(BcifTables tables, const std::string& name)
        : Content(to_document(std::move(tables.blocks), name), name, nullptr) {
        values = std::move(tables.texts);  // where they are
    }

    Content(Document parsed, const std::string& name, const std::string* content)
        : file(name),
          text(content),
          document(std::move(parsed)),
          block(coordinate_block(document, name)),
          atoms(to_atom_table(checked_columns(block, name), values_of(block))),
          models({file, text}, atoms) {
        for (auto row : block.find("_entity.", {"id", "type"})) {
            if (row.str(1) == "polymer") polymers.insert(row.str(0));
        }
    }

    // Of the loop of atoms in a block.
    std::vector<std::string_view> values_of(const gemmi::cif::Block& of) {
        const auto place = static_cast<std::size_t>(&of - document.blocks.data());
        const auto found = std::find_if(document.atom_loops.begin(), document.atom_loops.end(),
                                        [place](const AtomLoop& loop) { return loop.block == place; });
        return found == document.atom_loops.end() ? std::vector<std::string_view>() : std::move(found->values);
    }

    void tell_other_blocks(RawModel& model) const {
        std::vector<std::string> names;
        for (const AtomLoop& loop : document.atom_loops) {
            const gemmi::cif::Block& other = document.blocks[loop.block];
            if (&other != &block) names.push_back(shown(other.name));
        }
        if (names.empty()) return;
        model.warnings.push_back("the first data block with atoms is read; left out: " + names.front() +
                                 (names.size() > 1 ? " and " + std::to_string(names.size() - 1) + " more" : "") +
                                 "; give each block a file of its own");
    }

    std::string chain(std::size_t row) const {
        const std::string_view* const author = atoms.value(AtomColumn::AuthAsym, row);
        const std::string_view* const name = author != nullptr ? author : atoms.value(AtomColumn::LabelAsym, row);
        return name != nullptr ? printable(unquoted(*name)) : "";
    }

    std::vector<std::set<std::string>> chains_of_models() const {
        std::vector<std::set<std::string>> chains(models.count());
        for (std::size_t i = 0; i < atoms.rows(); ++i) chains[models.of(i)].insert(chain(i));
        return chains;
    }

    std::string place_of_model(std::size_t index) const {
        const CifSource source{file, text};
        return source.unit() + " " + std::to_string(source.place_of(AtomColumn::X, models.first_row(index)));
    }

    RawModel model(std::size_t index) {
        RawModel model;
        model.model_count = static_cast<int>(models.count());
        ResidueList residues(model.residues);
        const CifSource source{file, text};
        model.atoms.reserve(models.atoms(index));
        std::optional<AtomRow> before;
        OddValues odd;
        for (std::size_t i = 0; i < atoms.rows(); ++i) {
            if (models.of(i) != index) continue;
            const AtomRow row(source, atoms, i);
            const bool as_before = before && row.is_of_residue_of(*before);
            const std::uint32_t residue =
                as_before ? model.atoms.back().residue : residues.index_of(residue_of_row(row, polymers));
            model.atoms.push_back(atom_of_row(row, model.residues[residue].name, odd));
            model.atoms.back().residue = residue;
            before.emplace(row);
        }
        model.assemblies = read_assemblies(block);
        odd.tell(source, model);
        tell_other_blocks(model);
        return model;
    }
};

CifFile::CifFile(const std::string& bytes, const std::string& file, CifForm form)
    : content_(with_input_errors(file, [&] {
          return form == CifForm::Text ? std::make_unique<Content>(bytes, file)
                                       : std::make_unique<Content>(read_bcif(bytes, file, is_asked_for), file);
      })) {}

CifFile::~CifFile() = default;

int CifFile::model_count() const { return static_cast<int>(content_->models.count()); }

std::vector<std::set<std::string>> CifFile::chains_of_models() const { return content_->chains_of_models(); }

std::vector<std::size_t> CifFile::atoms_of_models() const {
    std::vector<std::size_t> atoms;
    for (std::size_t i = 0; i < content_->models.count(); ++i) atoms.push_back(content_->models.atoms(i));
    return atoms;
}

std::string CifFile::place_of_model(int position) const {
    return content_->place_of_model(static_cast<std::size_t>(position) - 1);
}

RawModel CifFile::model(int position) const {
    return with_input_errors(content_->file, [&] { return content_->model(static_cast<std::size_t>(position) - 1); });
}

}  // namespace meniscus::reading
