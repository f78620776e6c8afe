// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// What the targets share: a file that holds the fuzzer's bytes, and what a reader may say about it.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

#include "meniscus/errors.h"

namespace meniscus::fuzz {

/// Bytes from the fuzzer.
inline std::string_view text_of(const std::uint8_t* data, std::size_t size) {
    return {reinterpret_cast<const char*>(data), size};  // libFuzzer's form of bytes
}

/// Stops with the reason where the fuzzer sees it as a crash, if `holds` is false.
void require(bool holds, std::string_view what);

/// A file of this process with some name, removed at its end.
class FuzzedFile {
public:
    /// name     with the suffix that tells the format; may begin with folders, which are made
    explicit FuzzedFile(const std::string& name);
    FuzzedFile(const std::string& name, std::string_view bytes) : FuzzedFile(name) { write(bytes); }
    ~FuzzedFile();
    FuzzedFile(const FuzzedFile&) = delete;
    FuzzedFile& operator=(const FuzzedFile&) = delete;

    const std::string& path() const { return path_; }
    void write(std::string_view bytes) const;

private:
    std::string path_;
};

/// That a message is one clear line: not empty, not too long, no control characters, valid UTF-8.
void require_clear(std::string_view message);

/// Reads; the file may be refused, but only by the errors that readers are documented to throw, in one clear line that
/// begins with the file's name.
///
/// named    path, or its beginning
/// returns  true if the file was read
template <class Read>
bool read_or_refuse(const std::string& named, const Read& read) {
    try {
        read();
        return true;
    } catch (const InputError& error) {
        require_clear(error.what());
        require(std::string_view(error.what()).starts_with(named), error.what());
    } catch (const LimitError& error) {
        require_clear(error.what());
    }
    return false;
}

/// Does what may be refused as wrong usage, too, in one clear line.
template <class Use>
void use_or_refuse(const Use& use) {
    try {
        use();
    } catch (const UsageError& error) {
        require_clear(error.what());
    }
}

}  // namespace meniscus::fuzz
