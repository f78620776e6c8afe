// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "structure/input_file.h"

#include <algorithm>
#include <array>
#include <optional>

#include "core/lower_case.h"
#include "meniscus/errors.h"
#include "meniscus/structure.h"
#include "reading/gunzip.h"
#include "reading/numbers.h"
#include "reading/read_bytes.h"
#include "reading/text.h"
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
    {".cif", Format::Cif},
    {".mmcif", Format::Cif},
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

std::optional<Suffix> suffix_of(const std::string& path) {
    const std::string name = lower_case(base_name(path));
    const auto* found =
        std::find_if(kSuffixes.begin(), kSuffixes.end(), [&](const Suffix& s) { return name.ends_with(s.text); });
    return found == kSuffixes.end() ? std::nullopt : std::optional(*found);
}

bool is_pdb_record(std::string_view line) {
    constexpr auto kRecords = std::to_array<std::string_view>({
        "HEADER", "OBSLTE", "TITLE ", "COMPND", "SOURCE", "KEYWDS", "EXPDTA", "AUTHOR", "REVDAT", "JRNL  ", "REMARK",
        "DBREF",  "SEQRES", "SEQADV", "MODRES", "HET   ", "HETNAM", "FORMUL", "HELIX ", "SHEET ", "SSBOND", "LINK  ",
        "CISPEP", "SITE  ", "CRYST1", "ORIGX",  "SCALE",  "MTRIX",  "MODEL",  "ATOM ",  "HETATM", "ANISOU", "TER",
        "ENDMDL", "CONECT", "MASTER", "NUMMDL", "SPLIT",  "CAVEAT", "USER",   "END",    "HETSYN", "SPRSDE",
    });
    return std::any_of(kRecords.begin(), kRecords.end(), [&](std::string_view r) { return line.starts_with(r); });
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
    const std::string_view line = first_line(text);
    if (is_cif_start(line)) return Format::Cif;
    if (is_pdb_record(line)) return Format::Pdb;
    if (finite_number(Words(line).next())) return Format::Xyzr;
    return std::nullopt;
}

// Refuses what has a right name but is something else altogether.
void check_content(const InputFile& file) {
    const std::string_view line = first_line(file.text);
    const std::string start = lower_case(std::string(line.substr(0, 200)));
    if (start.starts_with("<!doctype html") || start.find("<html") != std::string::npos) {
        throw InputError(file.path + ": is an HTML page, not a structure; download the file itself");
    }
    if (start.starts_with('<'))
        throw InputError(file.path + ": is XML, not a structure; download the PDB or mmCIF file");
    if (start.starts_with('{'))
        throw InputError(file.path + ": is JSON, not a structure; download the PDB or mmCIF file");
    if (file.format == Format::Pdb && is_cif_start(line) && !is_pdb_record(line)) {
        throw InputError(file.path + ": contains mmCIF but is named as a PDB file; rename it to .cif");
    }
    if (file.format == Format::Cif && !line.empty() && is_pdb_record(line)) {
        throw InputError(file.path + ": contains PDB records but is named as an mmCIF file; rename it to .pdb");
    }
    const std::size_t zero = file.text.find('\0');
    if (zero == std::string::npos) return;
    const auto line_number = std::count(file.text.begin(), file.text.begin() + static_cast<std::ptrdiff_t>(zero), '\n');
    throw InputError(file.path + ":" + std::to_string(line_number + 1) +
                     ": a zero byte; this is not a text file, or it is damaged");
}

void choose_format(InputFile& file) {
    std::optional<Format> format;
    if (file.path == "-") {
        format = format_by_content(file.text);
        if (!format && first_line(file.text).empty()) {
            throw InputError("-: nothing came on standard input; pipe a PDB, mmCIF or xyzr file into it");
        }
    } else if (const auto suffix = suffix_of(file.path)) {
        format = suffix->format;
    }
    file.format = format.value_or(Format::Pdb);
    if (format) return;
    check_content(file);
    const char* problem = file.path == "-" ? ": neither PDB nor mmCIF nor xyzr; " : ": unknown suffix; ";
    throw InputError(file.path + problem +
                     "supported formats are .pdb .ent .cif .mmcif .pqr .xyzr .xyzrn, each also .gz");
}

}  // namespace

std::string stem_of(const std::string& path) {
    if (path == "-") return "stdin";
    std::string name = base_name(path);
    if (const auto suffix = suffix_of(path)) name.resize(name.size() - suffix->text.size());
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
        if (!named_gzip && path != "-") file.notes.push_back("gzip data in a file not named .gz: decompressed");
    } else if (named_gzip) {
        throw InputError(path + ": is named .gz but contains no gzip data; remove .gz from its name");
    } else {
        file.text = std::move(bytes);
    }
    normalise_line_ends(file.text);
    choose_format(file);
    check_content(file);
    return file;
}

InputFile load_input(const std::string& path, Checksum checksum) {
    if (const std::string hint = explain_identifier(path); !hint.empty()) throw InputError(hint);
    return load_bytes(read_bytes(path, "structure file"), path, checksum);
}

}  // namespace meniscus::reading
