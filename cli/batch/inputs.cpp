// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "batch/inputs.h"

#include <fmt/core.h>

#include <CLI/StringTools.hpp>
#include <algorithm>
#include <array>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <iterator>
#include <map>
#include <nlohmann/json.hpp>
#include <string_view>
#include <tuple>
#include <utility>

#include "batch/archive.h"
#include "meniscus/errors.h"
#include "meniscus/structure.h"
#include "next_line.h"
#include "reading/text.h"

namespace meniscus::cli::batch {

namespace fs = std::filesystem;

namespace {

constexpr std::size_t kLongestPath = 4096;  // bytes, as for the system

constexpr std::array<std::string_view, 10> kSuffixes{".pdb", ".ent",   ".cif", ".mmcif", ".bcif",
                                                     ".gro", ".pdbqt", ".pqr", ".xyzr",  ".xyzrn"};

/// In the names of biological assemblies .pdb has a number behind it: 1abc.pdb1, 1abc.pdb12.
std::size_t digits_of_assembly(std::string_view name) {
    const std::size_t digits = name.size() - (name.find_last_not_of("0123456789") + 1);
    name.remove_suffix(digits);
    return digits <= 2 && name.ends_with(".pdb") ? digits : 0;
}

/// How many characters at the end of a name are suffixes of a structure; 0 if there are none.
std::size_t suffix_length(const std::string& name) {
    const std::string small = CLI::detail::to_lower(name);
    const std::size_t packed = small.ends_with(".gz") ? 3 : 0;
    std::string_view inner = std::string_view(small).substr(0, small.size() - packed);
    const std::size_t digits = digits_of_assembly(inner);
    inner.remove_suffix(digits);
    for (const std::string_view suffix : kSuffixes)
        if (inner.ends_with(suffix) && inner.size() > suffix.size()) return suffix.size() + digits + packed;
    return 0;
}

/// A name as it can be shown, whatever its bytes are; cut short.
std::string shown(const std::string& name) {
    constexpr std::size_t kLongest = 200;
    const std::string text = name.size() > kLongest ? name.substr(0, kLongest) + "..." : name;
    return nlohmann::json(text).dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
}

bool is_text(const std::string& name) {
    try {
        return !nlohmann::json(name).dump().empty();
    } catch (const nlohmann::json::type_error&) {
        return false;
    }
}

bool is_archive(const std::string& name) { return CLI::detail::to_lower(name).ends_with(".tar"); }

[[noreturn]] void refuse(const fs::path& path, const std::error_code& error) {
    if (const std::string hint = explain_identifier(path.string()); !hint.empty()) throw InputError(hint);
    throw InputError(fmt::format("{}: cannot be read: {}", path.string(), error.message()));
}

std::uint64_t size_of(const fs::path& path) {
    std::error_code error;
    const auto size = fs::file_size(path, error);
    return error ? 0 : size;  // a pipe
}

/// A member's path without what would lead out of the folder of the outputs.
std::string inner_path(const std::string& archive, const std::string& name) {
    fs::path inner;
    for (const fs::path& part : fs::path(name).relative_path()) {
        if (part == "..")
            throw InputError(
                fmt::format("{}: the path of member {} leads out of the archive; rename it", archive, shown(name)));
        if (part != ".") inner /= part;
    }
    return inner.generic_string();
}

/// As it is written, but whole and without detours: "a/../b/" in /home -> "/home/b".
fs::path normal(const fs::path& path) {
    const fs::path whole = fs::absolute(path).lexically_normal();
    return whole.has_filename() ? whole : whole.parent_path();
}

class Search {
public:
    explicit Search(const Sources& sources) {
        std::error_code ignored;
        for (const std::string& folder : sources.skip) skip_.push_back(fs::weakly_canonical(folder, ignored));
        if (sources.base.empty()) return;
        base_ = normal(sources.base);
        if (!fs::is_directory(base_, ignored))
            throw UsageError(fmt::format("--base {}: is not a folder", sources.base));
    }

    /// What one word names; files are called by their path below the base or else `root`, or by their name.
    void add(const std::string& word, const fs::path& root = {}) {
        if (word.empty())
            throw UsageError("INPUTS: an empty name; leave it out (a variable of the shell may be empty)");
        std::error_code error;
        const fs::file_status status = fs::status(word, error);
        if (!fs::exists(status)) return add_file(word, root);  // its process tells what is wrong
        if (fs::is_directory(status)) return add_folder(word);
        if (is_archive(word)) return add_archive(word);
        if (is_packed_archive(word))
            throw InputError(word +
                             ": is a compressed archive; decompress it to .tar first, so that its members can be "
                             "reached one by one");
        add_file(word, root);
    }

    /// What is named itself, whatever its suffix.
    void add_file(const std::string& word, const fs::path& root) {
        const fs::path path(word);
        fs::path name = word == "-" ? path : normal(path).filename();
        if (!base_.empty())
            name = below_base(path);
        else if (!root.empty())
            name = normal(path).lexically_relative(root);
        found_.inputs.push_back({name.generic_string(), word, std::nullopt, size_of(path)});
    }

    void add_list(std::istream& lines, const std::string& name) {
        std::vector<std::string> words;
        std::size_t number = 0;
        for (std::string line; next_line(lines, line, name, ++number);) {
            if (line.ends_with('\r')) line.pop_back();
            if (line.size() > kLongestPath)
                throw InputError(fmt::format("{}:{}: a name of {} bytes is too long; write one name per line", name,
                                             number, line.size()));
            if (!line.empty()) words.push_back(line);
        }
        if (lines.bad()) throw InputError(name + ": cannot be read");
        const fs::path root = common_folder(words);
        for (const std::string& word : words) add(word, root);
    }

    FoundInputs finish() {
        std::vector<Input>& inputs = found_.inputs;
        std::sort(inputs.begin(), inputs.end(), [](const Input& a, const Input& b) {
            return std::tie(a.name, a.path, a.member) < std::tie(b.name, b.path, b.member);
        });
        inputs.erase(std::unique(inputs.begin(), inputs.end()), inputs.end());
        for (const Input& input : inputs)
            if (!is_text(input.name))
                throw InputError(input.member
                                     ? fmt::format("{}: the name of its member {} is not valid UTF-8; rename it",
                                                   input.path, shown(input.name))
                                     : shown(input.name) + ": its name is not valid UTF-8; rename it");
        const auto twin = std::adjacent_find(inputs.begin(), inputs.end(),
                                             [](const Input& a, const Input& b) { return a.name == b.name; });
        if (twin != inputs.end())
            throw UsageError(
                fmt::format("{} of {} and of {}: two inputs with the same name; give the folder that holds both",
                            twin->name, twin->path, std::next(twin)->path));
        if (inputs.empty())
            throw UsageError(found_.left_out == 0
                                 ? "there are no inputs"
                                 : fmt::format("there are no inputs: {} found, but none has the suffix of a structure",
                                               reading::counted(found_.left_out, "file")));
        return std::move(found_);
    }

private:
    /// throws   UsageError
    fs::path below_base(const fs::path& path) const {
        fs::path name = normal(path).lexically_relative(base_);
        if (name.empty() || *name.begin() == "..")
            throw UsageError(fmt::format("{}: is not below {}; --base must be a folder that holds all inputs",
                                         path.string(), base_.string()));
        return name;
    }

    /// The deepest folder that holds all files of a list.
    static fs::path common_folder(const std::vector<std::string>& words) {
        fs::path common;
        bool first = true;
        for (const std::string& word : words) {
            const fs::path folder = normal(word).parent_path();
            if (std::exchange(first, false)) {
                common = folder;
                continue;
            }
            const auto [end, other] = std::mismatch(common.begin(), common.end(), folder.begin(), folder.end());
            fs::path shared;
            for (auto part = common.begin(); part != end; ++part) shared /= *part;
            common = std::move(shared);
        }
        return common;
    }

    void add_folder(const fs::path& folder) {
        const fs::path root = base_.empty() ? fs::path() : below_base(folder);
        std::error_code error;
        for (fs::recursive_directory_iterator entry(folder, error), end; !error && entry != end;
             entry.increment(error)) {
            std::error_code ignored;
            if (entry->is_directory(ignored)) {
                const fs::path inner = fs::weakly_canonical(entry->path(), ignored);
                if (std::find(skip_.begin(), skip_.end(), inner) != skip_.end()) entry.disable_recursion_pending();
            } else if (const std::string name = entry->path().lexically_relative(folder).generic_string();
                       names_structure(name) && entry->is_regular_file(ignored)) {
                found_.inputs.push_back({(root / name).lexically_normal().generic_string(), entry->path().string(),
                                         std::nullopt, size_of(entry->path())});
            } else {
                ++found_.left_out;
            }
        }
        if (error) refuse(folder, error);
    }

    void add_archive(const std::string& path) {
        std::map<std::string, Input> members;  // of several with one name the last one counts, as for tar
        for (const ArchiveMember& member : list_members(path)) {
            const std::string name = inner_path(path, member.name);
            if (names_structure(name))
                members.insert_or_assign(name, Input{name, path, member.header, member.size});
            else
                ++found_.left_out;
        }
        for (auto& [name, input] : members) found_.inputs.push_back(std::move(input));
    }

    std::vector<fs::path> skip_;
    fs::path base_;
    FoundInputs found_;
};

}  // namespace

bool is_packed_archive(const std::string& name) {
    constexpr std::array kPacked{".tar.gz", ".tgz", ".tar.bz2", ".tbz2", ".tar.xz", ".txz", ".tar.zst", ".zip"};
    const std::string lower = CLI::detail::to_lower(name);
    return std::any_of(kPacked.begin(), kPacked.end(), [&](const char* suffix) { return lower.ends_with(suffix); });
}

bool names_structure(const std::string& name) { return suffix_length(name) > 0; }

std::string without_suffix(const std::string& name) { return name.substr(0, name.size() - suffix_length(name)); }

namespace {

/// Where all that was typed is wrong, an option or the folder is rather than one input.
void refuse_if_none_is_there(const std::vector<std::string>& words) {
    std::error_code error;
    const auto is_there = [&](const std::string& word) { return word == "-" || fs::exists(word, error); };
    if (words.empty() || std::any_of(words.begin(), words.end(), is_there)) return;
    refuse(words.front(), error ? error : std::make_error_code(std::errc::no_such_file_or_directory));
}

}  // namespace

FoundInputs find_inputs(const Sources& sources) {
    Search search(sources);
    if (sources.list.empty()) refuse_if_none_is_there(sources.words);
    for (const std::string& word : sources.words) {
        if (word == "-")
            search.add_list(std::cin, "standard input");
        else
            search.add(word);
    }
    if (sources.list == "-") {
        search.add_list(std::cin, "standard input");
    } else if (!sources.list.empty()) {
        std::ifstream file(sources.list);
        if (!file) throw InputError(sources.list + ": cannot be read");
        search.add_list(file, sources.list);
    }
    return search.finish();
}

}  // namespace meniscus::cli::batch
