// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// What of a path may stand in an output: results are passed on, and do not tell where their author keeps things.
#pragma once

#include <filesystem>
#include <string>

namespace meniscus {

/// The path without its folders; words that are no paths, as `-` or `bondi`, stay as they are.
inline std::string file_name(const std::string& path) { return std::filesystem::path(path).filename().string(); }

}  // namespace meniscus
