// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// Lines of files that may be anything.
#pragma once

#include <istream>
#include <string>

#include "meniscus/errors.h"

namespace meniscus::cli {

/// Takes the next line without its end, as std::getline, but none that no text has: it could fill the memory.
///
/// path, number   of the line, for the message
/// throws         InputError
inline bool next_line(std::istream& stream, std::string& line, const std::string& path, std::size_t number) {
    constexpr std::size_t kLongest = std::size_t{1} << 20U;
    line.clear();
    if (!stream) return false;
    const auto next = [&] {
        try {
            return stream.rdbuf()->sbumpc();
        } catch (const std::ios_base::failure&) {  // such as a folder
            throw InputError(path + ": cannot be read; name a file");
        }
    };
    for (int c = next(); c != std::istream::traits_type::eof(); c = next()) {
        if (c == '\n') return true;
        line += static_cast<char>(c);
        if (line.size() > kLongest)
            throw InputError(path + ":" + std::to_string(number) +
                             ": a line of more than 1 MiB; this is not a text file");
    }
    stream.setstate(std::ios::eofbit);
    return !line.empty();
}

}  // namespace meniscus::cli
