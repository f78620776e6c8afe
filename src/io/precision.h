// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// How many digits the coordinates of a mesh need.
#pragma once

#include <string>

#include "meniscus/mesh.h"
#include "platform/files/atomic_file.h"

namespace meniscus {

/// Single precision where it is enough, which keeps files small and suits every reader.
enum class Precision { Single, Double };

/// Double if single precision would be too coarse for the coordinates (steps above 1e-4 Å, from 1024 Å off the origin
/// on) or if it would make two corners of a triangle coincide.
///
/// shortest_edge   no side of a triangle is known to be shorter, Å
/// cost            O(n); a tenth where no side is so short that its ends could coincide
Precision precision_needed(const Mesh& mesh, double shortest_edge = 0.0);

/// For formats that know nothing else.
/// throws   LimitError "PATH: ..." where single precision has steps above 0.01 Å, from 131,072 Å off the origin on
void require_single_precision(const Mesh& mesh, const std::string& path);

/// Writes "x y z", each in as few digits as give the rounded number back.
void write_point(AtomicFile& file, const Vec3& point, Precision precision);

}  // namespace meniscus
