// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// Pieces of structure files and raw models, built in code.
#pragma once

#include <gtest/gtest.h>
#include <zlib.h>

#include <algorithm>
#include <cstdio>
#include <string>
#include <vector>

#include "meniscus/errors.h"
#include "meniscus/structure.h"
#include "structure/raw_model.h"
#include "support/scratch_folder.h"

namespace meniscus::testing {

/// An atom to be written; the defaults are those of a plain ATOM record.
struct Line {
    std::string name = " CA ";  ///< the four columns
    std::string residue = "ALA";
    int number = 1;
    double x = 0.0;
    double y = 0.0;
    double z = 0.0;
    std::string record = "ATOM";
    char chain = 'A';
    char altloc = ' ';
    char insertion_code = ' ';
    int serial = 1;
    double occupancy = 1.0;
    std::string element = {};  ///< two columns; empty: the line ends after the B factor
};

/// One ATOM or HETATM record with its line end.
inline std::string pdb_line(const Line& a) {
    char text[128];
    std::snprintf(text, sizeof text, "%-6s%5d %-4s%c%3s %c%4d%c   %8.3f%8.3f%8.3f%6.2f%6.2f", a.record.c_str(),
                  a.serial, a.name.c_str(), a.altloc, a.residue.c_str(), a.chain, a.number, a.insertion_code, a.x, a.y,
                  a.z, a.occupancy, 10.0);
    const std::string line = text;
    return line + (a.element.empty() ? "" : "          " + a.element) + "\n";
}

/// Writes a file with this content into a folder of its own and reads it.
inline Structure read_text(const std::string& content, const std::string& name, const ReadOptions& options = {}) {
    const ScratchFolder folder;
    write_file(folder / name, content);
    return read_structure(folder / name, options);
}

/// What reading says against the content, without the folder in front of the name; "" if it is read.
template <class Error = InputError>
std::string error_of(const std::string& content, const std::string& name, const ReadOptions& options = {}) {
    const ScratchFolder folder;
    write_file(folder / name, content);
    try {
        read_structure(folder / name, options);
    } catch (const Error& error) {
        std::string message = error.what();
        if (const auto at = message.find(folder / name); at != std::string::npos) {
            message.replace(at, (folder / name).size(), name);
        }
        return message;
    }
    return "";
}

inline bool has_line(const std::vector<std::string>& lines, const std::string& fragment) {
    return std::any_of(lines.begin(), lines.end(),
                       [&](const std::string& line) { return line.find(fragment) != std::string::npos; });
}

inline bool has_note(const Structure& structure, const std::string& fragment) {
    return has_line(structure.notes, fragment);
}

inline bool has_warning(const Structure& structure, const std::string& fragment) {
    return has_line(structure.warnings, fragment);
}

inline void expect_contains(const std::string& text, const std::string& fragment) {
    EXPECT_NE(text.find(fragment), std::string::npos) << '"' << text << "\" lacks \"" << fragment << '"';
}

/// The text as gzip data.
inline std::string gzipped(const std::string& text) {
    std::string out(text.size() + 1024, '\0');
    z_stream stream{};
    deflateInit2(&stream, Z_BEST_SPEED, Z_DEFLATED, 15 + 16, 8, Z_DEFAULT_STRATEGY);
    stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(text.data()));
    stream.avail_in = static_cast<uInt>(text.size());
    stream.next_out = reinterpret_cast<Bytef*>(out.data());
    stream.avail_out = static_cast<uInt>(out.size());
    deflate(&stream, Z_FINISH);
    out.resize(stream.total_out);
    deflateEnd(&stream);
    return out;
}

/// Adds a residue with these atoms (name and element alike) to a model; returns its index.
inline std::uint32_t add_residue(reading::RawModel& model, const std::string& name, int number,
                                 std::initializer_list<const char*> elements, bool hetatm = false) {
    reading::RawResidue& residue = model.residues.emplace_back();
    residue.chain = "A";
    residue.name = name;
    residue.number = number;
    const auto index = static_cast<std::uint32_t>(model.residues.size() - 1);
    for (const char* element : elements) {
        reading::RawAtom& atom = model.atoms.emplace_back();
        atom.residue = index;
        atom.name = element;
        atom.element = element;
        atom.hetatm = hetatm;
        atom.centre = {10.0 * static_cast<double>(model.atoms.size()), 0.0, 0.0};
    }
    return index;
}

/// 0, 1, 2 ... for all atoms of a model.
inline std::vector<std::uint32_t> all_atoms(const reading::RawModel& model) {
    std::vector<std::uint32_t> indices;
    for (std::uint32_t i = 0; i < model.atoms.size(); ++i) indices.push_back(i);
    return indices;
}

}  // namespace meniscus::testing
