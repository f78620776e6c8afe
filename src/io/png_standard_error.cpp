// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// For portable builds (cmake/portable.cmake): where their libpng writes messages that no function of ours has taken.
#include <cstdio>

extern "C" {
extern std::FILE* meniscus_standard_error;
std::FILE* meniscus_standard_error = stderr;
}
