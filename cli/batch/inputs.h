// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// The inputs of a batch: files, folders with all below them, members of tar archives, and lists of these.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace meniscus::cli::batch {

struct Input {
    std::string name;                    ///< below the folder, archive or list it came from; '/' between folders
    std::string path;                    ///< of the file, or of the archive that it is a member of
    std::optional<std::int64_t> member;  ///< where its header begins in the archive
    std::uint64_t size = 0;              ///< bytes as stored

    bool operator==(const Input&) const = default;
};

struct FoundInputs {
    std::vector<Input> inputs;  ///< by name, each name once
    std::size_t left_out = 0;   ///< files of folders and archives whose suffix names no structure
};

/// Whether a name ends as structures do: .pdb .ent .cif .mmcif .bcif .gro .pdbqt .pqr .xyzr .xyzrn, each also .gz;
/// capitals count as well.
bool names_structure(const std::string& name);

/// A name without the suffixes of structures: "ab/1abc.cif.gz" -> "ab/1abc".
std::string without_suffix(const std::string& name);

/// Whether a name is that of an archive whose members cannot be reached one by one: .tar.gz, .tgz, .zip and others.
bool is_packed_archive(const std::string& name);

/// Where inputs are looked for.
struct Sources {
    std::vector<std::string> words;  ///< files, folders, .tar archives; "-" for a list on standard input
    std::string list;                ///< a file with one such word per line, or empty
    std::string base;                ///< a folder that holds all files and folders, or empty
    std::vector<std::string> skip;   ///< folders that are not looked into: those of the outputs
};

/// Finds what the sources name.
///
/// With a base, files are called by their paths below it. Without one, a file is called by its name, one in a folder by
/// its path below that folder, and one of a list by its path below the deepest folder that holds all files of the list.
/// A member of an archive is always called by its path in it. What is named itself is taken whatever its suffix.
///
/// Paths are compared as they are written; links are not followed. What is not there is a file of no bytes, which fails
/// when it is read, unless nothing is there of what the words name.
///
/// throws  InputError for words of which none is there, for what cannot be read, and for names that are no text
/// (UTF-8); UsageError for
///         two inputs of one name, for a base that is no folder, for what is not below it, and where there are none
FoundInputs find_inputs(const Sources& sources);

}  // namespace meniscus::cli::batch
