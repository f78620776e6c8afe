// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "output_plan.h"

#include <fmt/core.h>
#include <unistd.h>

#include <CLI/StringTools.hpp>
#include <algorithm>
#include <array>
#include <cctype>
#include <filesystem>
#include <map>
#include <set>
#include <span>
#include <utility>

#include "meniscus/errors.h"
#include "meniscus/page.h"
#include "platform/files/atomic_file.h"

namespace meniscus::cli {

namespace fs = std::filesystem;

namespace {

struct Suffix {
    const char* text;
    OutputKind kind;
};

constexpr std::array kSuffixes{
    Suffix{".ply", OutputKind::Mesh},      Suffix{".obj", OutputKind::Mesh},    Suffix{".stl", OutputKind::Mesh},
    Suffix{".off", OutputKind::Mesh},      Suffix{".glb", OutputKind::Mesh},    Suffix{".vtp", OutputKind::Mesh},
    Suffix{".vert", OutputKind::Mesh},     Suffix{".npz", OutputKind::Mesh},    Suffix{".xyzr", OutputKind::Spheres},
    Suffix{".xyzrn", OutputKind::Spheres}, Suffix{".dx", OutputKind::Volume},   Suffix{".mrc", OutputKind::Volume},
    Suffix{".vdb", OutputKind::Volume},    Suffix{".png", OutputKind::Picture}, Suffix{".html", OutputKind::Page},
};

bool is_pair(const std::string& suffix) { return suffix == ".vert"; }

constexpr std::array kMeasureSuffixes{
    Suffix{".csv", OutputKind::Table},
    Suffix{".json", OutputKind::Table},
    Suffix{".pdb", OutputKind::StructureCopy},
    Suffix{".cif", OutputKind::StructureCopy},
};

constexpr std::array kPocketsSuffixes{
    Suffix{".csv", OutputKind::Table},         Suffix{".json", OutputKind::Table},
    Suffix{".pdb", OutputKind::StructureCopy}, Suffix{".cif", OutputKind::StructureCopy},
    Suffix{".dx", OutputKind::Volume},         Suffix{".mrc", OutputKind::Volume},
    Suffix{".vdb", OutputKind::Volume},        Suffix{".ply", OutputKind::Mesh},
    Suffix{".glb", OutputKind::Mesh},          Suffix{".png", OutputKind::Picture},
    Suffix{".html", OutputKind::Page},
};

constexpr std::array kHistorySuffixes{
    Suffix{".csv", OutputKind::History},
    Suffix{".json", OutputKind::History},
};

/// The formats of standard output are called by their suffixes without the point.
[[noreturn]] void refuse_format(std::span<const Suffix> suffixes, const std::string& suffix) {
    std::string known;
    for (const Suffix& s : suffixes)
        if (!is_pair(s.text)) known.append(known.empty() ? "" : " ").append(s.text + 1);
    throw UsageError(
        fmt::format("--format {}: unknown format; choose one of {}", suffix.empty() ? "" : suffix.substr(1), known));
}

OutputKind find_kind(std::span<const Suffix> suffixes, const std::string& path, const char* option = "-o") {
    const std::string suffix = suffix_of(path);
    const auto found =
        std::find_if(suffixes.begin(), suffixes.end(), [&](const Suffix& s) { return suffix == s.text; });
    if (found != suffixes.end()) return found->kind;
    if (is_standard_output(path)) refuse_format(suffixes, suffix);
    std::string known;
    for (const Suffix& s : suffixes) known.append(known.empty() ? "" : " ").append(s.text);
    throw UsageError(fmt::format("{} {}: unknown suffix; choose one of {}", option, path, known));
}

/// "dir/a.b.ply" with "_m01" -> "dir/a.b_m01.ply".
std::string with_mark(const fs::path& path, const std::string& mark) {
    return (path.parent_path() / (path.stem().string() + mark + path.extension().string())).string();
}

std::string atom_table_beside(const fs::path& path) {
    return (path.parent_path() / (path.stem().string() + ".atoms.csv")).string();
}

/// The same text for every spelling of one file.
std::string identity(const std::string& path) {
    std::error_code error;
    const fs::path canonical = fs::weakly_canonical(fs::absolute(path, error), error);
    return error ? fs::path(path).lexically_normal().string() : canonical.string();
}

void check_writable(const std::string& path) {
    std::error_code error;
    if (fs::is_directory(path, error)) throw OutputError(path + ": is a folder; name a file");
    if (const std::string text = missing_folder(path); !text.empty()) throw OutputError(text);
    const fs::path parent = fs::path(path).parent_path();
    const std::string folder = parent.empty() ? "." : parent.string();
    if (access(folder.c_str(), W_OK | X_OK) != 0)
        throw OutputError(fmt::format("{}: the folder '{}' is not writable", path, folder));
}

}  // namespace

OutputKind kind_of(const std::string& path) { return find_kind(kSuffixes, path); }

OutputKind measure_kind_of(const std::string& path) { return find_kind(kMeasureSuffixes, path); }

std::string suffix_of(const std::string& path) { return CLI::detail::to_lower(fs::path(path).extension().string()); }

bool holds_structure(const std::string& path) { return suffix_of(path) == ".npz"; }

std::vector<Output> plan_outputs(const std::vector<std::string>& asked, const std::string& name,
                                 const std::string& mark) {
    std::vector<Output> plan;
    plan.reserve(2 * asked.size() + 3);
    for (const std::string& path : asked) plan.push_back({with_mark(path, mark), kind_of(path)});
    if (asked.empty()) plan.push_back({name + ".ply", OutputKind::Mesh});
    if (asked.empty() && pages_supported()) plan.push_back({name + ".html", OutputKind::Page});
    const std::size_t count = plan.size();
    for (std::size_t i = 0; i < count; ++i) {
        const std::string& path = plan[i].path;
        if (plan[i].kind != OutputKind::Mesh || holds_structure(path) || is_standard_output(path)) continue;
        const Output table{atom_table_beside(plan[i].path), OutputKind::AtomTable};
        if (std::find(plan.begin(), plan.end(), table) == plan.end()) plan.push_back(table);
    }
    return plan;
}

std::vector<Output> plan_measure_outputs(const std::vector<std::string>& asked, const std::string& mark) {
    std::vector<Output> plan;
    plan.reserve(asked.size());
    for (const std::string& path : asked) plan.push_back({with_mark(path, mark), measure_kind_of(path)});
    return plan;
}

std::vector<Output> plan_pockets_outputs(const std::vector<std::string>& asked, const std::string& mark) {
    std::vector<Output> plan;
    plan.reserve(asked.size());
    for (const std::string& path : asked) plan.push_back({with_mark(path, mark), find_kind(kPocketsSuffixes, path)});
    return plan;
}

Output plan_history(const std::string& asked, const std::string& mark) {
    return {with_mark(asked, mark), find_kind(kHistorySuffixes, asked, "--history")};
}

Output plan_table(const char* option, const std::string& asked, const std::string& mark) {
    find_kind(kHistorySuffixes, asked, option);
    return {with_mark(asked, mark), OutputKind::Table};
}

std::string snapshot_path(const std::string& mesh, int step) {
    return with_mark(mesh, fmt::format("_step{:03}", step));
}

std::string cavity_path(const std::string& mesh, std::size_t number) {
    return with_mark(mesh, fmt::format("_cavity{}", number));
}

std::string mark_of_chain(const std::string& chain) {
    std::string mark = "_chain";
    for (const char c : chain) {
        const auto byte = static_cast<unsigned char>(c);
        const bool plain = byte < 128 && (std::isalnum(byte) != 0 || c == '-' || c == '+');
        mark += plain ? std::string(1, c) : fmt::format("%{:02X}", byte);
    }
    return mark;
}

std::vector<std::string> files_of(const std::string& path) {
    std::vector<std::string> files{path};
    if (is_pair(suffix_of(path))) files.push_back(fs::path(path).replace_extension(".face").string());
    return files;
}

void check_paths(const std::vector<std::string>& paths, const std::vector<ReadFile>& read) {
    std::set<std::string> seen;
    std::map<std::string, std::string> sources;
    for (const ReadFile& file : read)
        if (file.path != "-") sources.emplace(identity(file.path), file.what);
    std::vector<std::string> files;
    for (const std::string& path : paths)
        for (std::string& file : files_of(path)) files.push_back(std::move(file));
    for (const std::string& path : files) {
        if (path == "-" || is_standard_output(path) || is_special_file(path)) continue;
        check_writable(path);
        const std::string file = identity(path);
        if (const auto source = sources.find(file); source != sources.end())
            throw UsageError(fmt::format("{}: would overwrite {}; choose another name", path, source->second));
        if (!seen.insert(file).second) throw UsageError(path + ": two outputs go to this file; choose another name");
    }
}

bool is_special_file(const std::string& path) {
    std::error_code error;
    const fs::file_status status = fs::status(path, error);
    return fs::exists(status) && !fs::is_regular_file(status) && !fs::is_directory(status);
}

}  // namespace meniscus::cli
