// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// Which files a run writes, decided and checked before anything is computed.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace meniscus::cli {

enum class OutputKind {
    Mesh,
    Spheres,
    Picture,
    Page,
    Volume,
    AtomTable,      ///< NAME.atoms.csv beside a mesh
    History,        ///< of a flow
    Table,          ///< of measures
    TunnelTable,    ///< radii along tunnels and pore
    StructureCopy,  ///< with measures in the B-factor column
    Arrays,         ///< of pockets
};

struct Output {
    std::string path;
    OutputKind kind;

    bool operator==(const Output&) const = default;
};

/// What a file of `surface` or of `measure` is by its suffix.
/// throws   UsageError for a suffix that names no format
OutputKind kind_of(const std::string& path);
OutputKind measure_kind_of(const std::string& path);

/// ".ply" for "a.PLY".
std::string suffix_of(const std::string& path);

/// Whether a mesh file has in itself which atoms it is of, and what they were read from.
bool holds_structure(const std::string& path);

/// All files of one structure: those of -o, or NAME.ply and NAME.html (in builds with pages), each mesh with its table
/// of atoms beside it, unless its format holds them.
///
/// name   of the structure, which for one of several models has its mark already
/// mark   goes between stem and suffix of what is asked for, e.g. "_m01" for the first of all models; may be empty
std::vector<Output> plan_outputs(const std::vector<std::string>& asked, const std::string& name,
                                 const std::string& mark);

/// All files of one structure that `measure` writes: those of -o.
std::vector<Output> plan_measure_outputs(const std::vector<std::string>& asked, const std::string& mark);

/// All files of one structure that `pockets` writes: those of -o.
std::vector<Output> plan_pockets_outputs(const std::vector<std::string>& asked, const std::string& mark);

/// Where the radii along tunnels and pore go.
/// throws   UsageError for a suffix other than .csv and .json
Output plan_tunnel_table(const std::string& asked, const std::string& mark);

/// Where the record of a flow goes.
/// throws   UsageError for a suffix other than .csv and .json
Output plan_history(const std::string& asked, const std::string& mark);

/// A table that an option of its own names.
/// throws   UsageError for a suffix other than .csv and .json
Output plan_table(const char* option, const std::string& asked, const std::string& mark);

/// The mesh of a step beside the final one: "a.ply" -> "a_step007.ply".
std::string snapshot_path(const std::string& mesh, int step);

/// The mesh of a cavity beside that of all, counted from 1: "a.ply" -> "a_cavity1.ply".
std::string cavity_path(const std::string& mesh, std::size_t number);

/// Goes between stem and suffix of the files of a chain: "_chainA". Other characters than letters and digits of ASCII,
/// - and + are written as %2F.
std::string mark_of_chain(const std::string& chain);

/// The files that are written where one of this name is asked for: itself, and "a.face" beside "a.vert".
std::vector<std::string> files_of(const std::string& path);

/// A file that a run reads.
struct ReadFile {
    std::string what;  ///< "the input", "the file of --grid"
    std::string path;  ///< or "-"
};

/// Refuses what could not be written in the end, or would overwrite something of the same run.
///
/// paths    every file of the run (files_of() of them are looked at); "-" (standard output) and devices are left alone
/// throws   OutputError for a folder that is missing or closed, or a path that is a folder; UsageError for a path
///          that appears twice or is read
void check_paths(const std::vector<std::string>& paths, const std::vector<ReadFile>& read);

/// True for a path that exists but is no regular file: a device, a pipe. It is written in place.
bool is_special_file(const std::string& path);

}  // namespace meniscus::cli
