// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// From a path to the text of a structure file: opening, decompressing, telling the format.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace meniscus::reading {

enum class Format { Pdb, Pdbqt, Cif, Bcif, Pqr, Xyzr, Xyzrn, Gro };
enum class Checksum { LeftOut, Found };

/// A file as text: decompressed, lines ending with '\n', no byte order mark, records of PDB tidied (pdb_records.h).
/// BinaryCIF is left as its bytes are.
struct InputFile {
    std::string path;    ///< as given; "-" for standard input
    std::string name;    ///< stem for outputs
    std::string sha256;  ///< of the bytes as found, if asked for
    Format format = Format::Pdb;
    std::string text;
    std::vector<std::string> notes;     ///< see Structure::notes
    std::vector<std::string> warnings;  ///< see Structure::warnings
};

/// Reads a file, or standard input if the path is "-".
/// throws   InputError if it cannot be read or is of no known format
InputFile load_input(const std::string& path, Checksum checksum = Checksum::Found);

/// The same from bytes already in memory; the path tells name and format as if they came from there.
InputFile load_bytes(std::string bytes, const std::string& path, Checksum checksum = Checksum::Found);

/// Whether a file is named as a biological unit: 1abc.pdb1, 1abc.pdb2.gz.
bool is_biological_unit(const std::string& path);

/// "1ubq" for "dir/1ubq.pdb.gz", "stdin" for "-".
std::string stem_of(const std::string& path);

}  // namespace meniscus::reading
