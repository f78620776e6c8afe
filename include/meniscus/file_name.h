// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// The part of a path that outputs may contain: results are passed on, and must not reveal their author's folders.
#pragma once

#include <filesystem>
#include <string>

namespace meniscus {

/// The path without its folders. Words that are not paths, such as `-` or `bondi`, stay as they are.
inline std::string file_name(const std::string& path) { return std::filesystem::path(path).filename().string(); }

}  // namespace meniscus
