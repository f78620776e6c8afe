// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "structure/input_file.h"

#include <algorithm>
#include <array>
#include <optional>

#include "meniscus/errors.h"
#include "meniscus/structure.h"
#include "reading/gunzip.h"
#include "reading/lower_case.h"
#include "reading/numbers.h"
#include "reading/read_bytes.h"
#include "reading/text.h"
#include "structure/bcif_tables.h"
#include "structure/gro_reader.h"
#include "structure/odd_lines.h"
#include "structure/pdb_columns.h"
#include "structure/pdb_records.h"
#include "structure/pdbqt_reader.h"
#include "structure/pqr_content.h"
#include "structure/sha256.h"

namespace meniscus::reading {
namespace {

struct Suffix {
    std::string_view text;
    Format format;
};

constexpr auto kSuffixes = std::to_array<Suffix>({
    {".pdb", Format::Pdb},
    {".ent", Format::Pdb},
    {".pdbqt", Format::Pdbqt},
    {".cif", Format::Cif},
    {".mmcif", Format::Cif},
    {".bcif", Format::Bcif},
    {".gro", Format::Gro},
    {".pqr", Format::Pqr},
    {".xyzr", Format::Xyzr},
    {".xyzrn", Format::Xyzrn},
});

// The file name without folders, and without .gz if it ends so.
std::string base_name(const std::string& path) {
    std::string name = path.substr(path.find_last_of('/') + 1);
    if (lower_case(name).ends_with(".gz")) name.resize(name.size() - 3);
    return name;
}

// In the names of biological assemblies .pdb has a number behind it: 1abc.pdb1, 1abc.pdb12.
std::size_t digits_of_assembly(std::string_view name) {
    const std::size_t digits = name.size() - (name.find_last_not_of("0123456789") + 1);
    name.remove_suffix(digits);
    return digits <= 2 && name.ends_with(".pdb") ? digits : 0;
}

struct FoundSuffix {
    std::size_t length;
    Format format;
};

std::optional<FoundSuffix> suffix_of(const std::string& path) {
    std::string name = lower_case(base_name(path));
    const std::size_t digits = digits_of_assembly(name);
    name.resize(name.size() - digits);
    const auto* found =
        std::find_if(kSuffixes.begin(), kSuffixes.end(), [&](const Suffix& s) { return name.ends_with(s.text); });
    if (found == kSuffixes.end()) return std::nullopt;
    return FoundSuffix{found->text.size() + digits, found->format};
}

// The first line that says something: neither blank nor a comment.
std::string_view first_line(std::string_view text) {
    Lines lines(text);
    while (lines.next()) {
        const std::string_view line = trimmed(lines.line());
        if (!line.empty() && line[0] != '#') return line;
    }
    return {};
}

bool is_cif_start(std::string_view line) {
    return lower_case(std::string(line.substr(0, 5))) == "data_" || line.starts_with("loop_") || line.starts_with("_");
}

std::optional<Format> format_by_content(std::string_view text) {
    if (is_bcif(text)) return Format::Bcif;
    if (is_gro(text)) return Format::Gro;
    const std::string_view line = first_line(text);
    if (is_cif_start(line)) return Format::Cif;
    if (is_pdb_record(line)) return is_surely_pqr(text) ? Format::Pqr : Format::Pdb;
    if (finite_number(Words(line).next())) return Format::Xyzr;
    return std::nullopt;
}

std::string column_of(std::string_view text, std::size_t place) {
    return std::to_string(place - (text.substr(0, place).find_last_of('\n') + 1) + 1);
}

std::string line_of(std::string_view text, std::size_t place) {
    return std::to_string(1 + std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(place), '\n'));
}

// The bytes of BinaryCIF are no text, under whatever name.
void check_binary_content(const InputFile& file) {
    if (file.format == Format::Bcif) return;
    throw InputError(file.path + ": contains BinaryCIF but is named as another format; rename it to .bcif");
}

// A title may begin like any record.
bool has_atom_records(std::string_view text) {
    Lines lines(text);
    while (lines.next())
        if (is_atom_record(lines.line())) return true;
    return false;
}

// Formats that begin with free text are told by what they lack, too.
void check_gro(const InputFile& file, std::string_view line) {
    if (file.format != Format::Gro && is_gro(file.text))
        throw InputError(file.path +
                         ": contains GROMACS coordinates but is named as another format; rename it to .gro");
    if (file.format != Format::Gro || is_gro(file.text)) return;
    if (is_cif_start(line)) throw InputError(file.path + ": contains mmCIF but is named .gro; rename it to .cif");
    if (has_atom_records(file.text))
        throw InputError(file.path + ": contains PDB records but is named .gro; rename it to .pdb");
}

void check_bcif(const InputFile& file, std::string_view line) {
    if (file.format != Format::Bcif) return;
    if (is_cif_start(line)) throw InputError(file.path + ": contains mmCIF text but is named .bcif; rename it to .cif");
    throw InputError(file.path + ": is not BinaryCIF, or its beginning is damaged; fetch the file again");
}

// Refuses what has a right name but is something else altogether.
void check_content(const InputFile& file) {
    if (is_bcif(file.text)) return check_binary_content(file);
    const std::string_view line = first_line(file.text);
    const std::string start = lower_case(std::string(line.substr(0, 200)));
    if (start.starts_with("<!doctype html") || start.find("<html") != std::string::npos) {
        throw InputError(file.path + ": is an HTML page, not a structure; download the file itself");
    }
    if (start.starts_with('<'))
        throw InputError(file.path + ": is XML, not a structure; download the PDB or mmCIF file");
    if (start.starts_with('{'))
        throw InputError(file.path + ": is JSON, not a structure; download the PDB or mmCIF file");
    check_bcif(file, line);
    check_gro(file, line);
    if (file.format == Format::Pdb && is_cif_start(line) && !is_pdb_record(line)) {
        throw InputError(file.path + ": contains mmCIF but is named as a PDB file; rename it to .cif");
    }
    if (file.format == Format::Cif && !line.empty() && is_pdb_record(line)) {
        throw InputError(file.path + ": contains PDB records but is named as an mmCIF file; rename it to .pdb");
    }
    const std::size_t zero = file.text.find('\0');
    if (zero == std::string::npos) return;
    throw InputError(file.path + ":" + line_of(file.text, zero) + ":" + column_of(file.text, zero) +
                     ": a zero byte; this is not a text file, or it is damaged: fetch or write it again");
}

// Old programs fill the last block of a file with zero bytes; so does a file system after a crash.
void remove_padding(InputFile& file) {
    const std::size_t last = file.text.find_last_not_of(std::string_view("\0 \t\n", 4));
    const std::size_t zero = last == std::string::npos ? last : file.text.find('\0', last);
    if (zero == std::string::npos) return;
    file.warnings.push_back("line " + line_of(file.text, zero) +
                            ": zero bytes behind the last record, left out; the file may have been cut off");
    file.text.resize(zero);
}

void tell_line_ends(InputFile& file) {
    const std::string& text = file.text;
    if (text.starts_with("\xEF\xBB\xBF")) file.notes.push_back("line 1: a byte-order mark, left out");
    if (text.starts_with("\xFF\xFE") || text.starts_with("\xFE\xFF"))
        throw InputError(file.path + ":1:1: text in UTF-16; save the file as UTF-8 or ASCII");
    for (std::size_t i = text.find('\r'); i != std::string::npos; i = text.find('\r', i + 1)) {
        if (i + 1 == text.size() || text[i + 1] == '\n') continue;
        file.notes.push_back("line " + line_of(text, i) +
                             ": a line ends with a carriage return alone, taken as its end");
        return;
    }
}

// AutoDock and Vina write PDBQT, which users name .pdb so that viewers open it.
void recognise_pdbqt(InputFile& file) {
    if (!has_pdbqt_atoms(file.text)) return;
    file.format = Format::Pdbqt;
    file.notes.emplace_back("read as PDBQT: charges and atom types of AutoDock in columns 67-79");
}

// Read as the other, PDB and PQR give wrong radii without any error.
void check_radii_columns(const InputFile& file) {
    if (file.format == Format::Pqr && is_surely_pdb(file.text))
        throw InputError(
            file.path +
            ": looks like a PDB file (occupancy and B factor where charge and radius belong); rename it to "
            ".pdb");
    if (file.format == Format::Pdb && is_surely_pqr(file.text))
        throw InputError(file.path +
                         ": contains PQR (charge and radius where occupancy and B factor belong) but is named as a PDB "
                         "file; rename it to .pqr");
}

// The names of records come first: without their capitals and places no atom is known as one.
void tidy_pdb(InputFile& file) {
    if (file.format != Format::Pdb && file.format != Format::Pdbqt) return;
    RecordOddities found = tidy_records(file.text, file.path);
    file.notes.insert(file.notes.end(), found.notes.begin(), found.notes.end());
    file.warnings.insert(file.warnings.end(), found.warnings.begin(), found.warnings.end());
    if (file.format == Format::Pdb) recognise_pdbqt(file);
}

// Comments of mmCIF are passed over by its grammar, whatever they hold.
void tell_atoms_in_comments(InputFile& file) {
    OddLines comments;
    const std::string_view text = file.text;
    for (std::size_t at = text.find("\n#"); at != text.npos; at = text.find("\n#", at + 1)) {
        const std::string_view line = text.substr(at + 1, text.find('\n', at + 1) - at - 1);
        const std::size_t name = line.find_first_not_of("# \t");
        if (name != line.npos && is_atom_record(line.substr(name)) && has_coordinates(line))
            comments.add(comments.count > 0 ? 0 : std::stoul(line_of(text, at + 1)), line.substr(0, 20));
    }
    comments.tell("", " is a comment, but has coordinates as an atom has; left out", file.warnings);
}

void tidy_text(InputFile& file) {
    tell_line_ends(file);
    normalise_line_ends(file.text);
    remove_padding(file);
}

bool is_named_as_mesh(const std::string& path) {
    constexpr auto kMeshes =
        std::to_array<std::string_view>({".ply", ".obj", ".stl", ".off", ".glb", ".vtp", ".vert", ".face", ".npz"});
    const std::string name = lower_case(base_name(path));
    return std::any_of(kMeshes.begin(), kMeshes.end(), [&](std::string_view end) { return name.ends_with(end); });
}

// Standard input, and bytes in memory whose name tells nothing.
bool is_nameless(const std::string& path) { return path == "-" || (path.starts_with('<') && path.ends_with('>')); }

[[noreturn]] void fail_nothing(const std::string& path) {
    if (path == "-") throw InputError("-: nothing came on standard input; pipe a PDB, mmCIF or xyzr file into it");
    throw InputError(path + ": empty; a PDB, mmCIF or xyzr file is needed");
}

void choose_format(InputFile& file) {
    std::optional<Format> format;
    if (is_nameless(file.path)) {
        format = format_by_content(file.text);
        if (!format && first_line(file.text).empty()) fail_nothing(file.path);
    } else if (const auto suffix = suffix_of(file.path)) {
        format = suffix->format;
    }
    file.format = format.value_or(Format::Pdb);
    if (format) return;
    if (is_named_as_mesh(file.path))
        throw InputError(file.path + ": is a mesh, not a structure; give the structure that it was made from");
    check_content(file);
    const char* problem =
        is_nameless(file.path) ? ": neither PDB nor mmCIF nor GROMACS nor xyzr; " : ": unknown suffix; ";
    throw InputError(file.path + problem +
                     "supported formats are .pdb .ent .cif .mmcif .bcif .gro .pdbqt .pqr .xyzr .xyzrn, each also .gz");
}

}  // namespace

bool is_biological_unit(const std::string& path) { return digits_of_assembly(lower_case(base_name(path))) > 0; }

std::string stem_of(const std::string& path) {
    if (path == "-") return "stdin";
    if (is_nameless(path)) return "structure";
    std::string name = base_name(path);
    if (const auto suffix = suffix_of(path)) name.resize(name.size() - suffix->length);
    return name.empty() ? "structure" : name;
}

InputFile load_bytes(std::string bytes, const std::string& path, Checksum checksum) {
    InputFile file;
    file.path = path;
    file.name = stem_of(path);
    if (checksum == Checksum::Found) file.sha256 = sha256_hex(bytes);
    const bool named_gzip = lower_case(path).ends_with(".gz");
    if (is_gzip(bytes)) {
        file.text = gunzip(bytes, path);
        if (!named_gzip && !is_nameless(path)) file.notes.push_back("gzip data in a file not named .gz: decompressed");
    } else if (named_gzip) {
        throw InputError(path + ": is named .gz but contains no gzip data; remove .gz from its name");
    } else {
        file.text = std::move(bytes);
    }
    if (!is_bcif(file.text)) tidy_text(file);
    choose_format(file);
    check_content(file);
    tidy_pdb(file);
    check_radii_columns(file);
    if (file.format == Format::Cif) tell_atoms_in_comments(file);
    return file;
}

InputFile load_input(const std::string& path, Checksum checksum) {
    if (const std::string hint = explain_identifier(path); !hint.empty()) throw InputError(hint);
    return load_bytes(read_bytes(path, "structure file"), path, checksum);
}

}  // namespace meniscus::reading
