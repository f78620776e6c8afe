// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "fuzzed_file.h"

#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>

namespace meniscus::fuzz {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kLongestMessage = 2000;

// In memory, where the system has such a folder.
fs::path scratch_folder() {
    const fs::path in_memory = "/dev/shm";
    const fs::path base = fs::is_directory(in_memory) ? in_memory : fs::temp_directory_path();
    return base / ("meniscus-fuzz-" + std::to_string(::getpid()));
}

// Bytes that follow the first one of a character of UTF-8; -1 if it is none, or one of a control character.
int bytes_behind(unsigned char first) {
    if (first < 0x20 || first == 0x7f) return -1;
    if (first < 0x80) return 0;
    if (first >= 0xc2 && first < 0xe0) return 1;
    if (first >= 0xe0 && first < 0xf0) return 2;
    return first >= 0xf0 && first < 0xf5 ? 3 : -1;
}

bool is_plain_text(std::string_view text) {
    int behind = 0;
    for (const char c : text) {
        const auto byte = static_cast<unsigned char>(c);
        if (behind > 0 && (byte & 0xc0U) != 0x80) return false;
        behind = behind > 0 ? behind - 1 : bytes_behind(byte);
        if (behind < 0) return false;
    }
    return behind == 0;
}

}  // namespace

void require(bool holds, std::string_view what) {
    if (holds) return;
    std::fprintf(stderr, "does not hold: %.*s\n", static_cast<int>(what.size()), what.data());
    std::abort();
}

FuzzedFile::FuzzedFile(const std::string& name) {
    path_ = scratch_folder() / name;
    fs::create_directories(fs::path(path_).parent_path());
}

FuzzedFile::~FuzzedFile() {
    std::error_code ignored;
    fs::remove(path_, ignored);
    for (fs::path folder = fs::path(path_).parent_path(); folder != scratch_folder().parent_path();
         folder = folder.parent_path())
        fs::remove(folder, ignored);  // with its last file
}

void FuzzedFile::write(std::string_view bytes) const {
    std::ofstream file(path_, std::ios::binary | std::ios::trunc);
    file << bytes;
    file.close();
    require(static_cast<bool>(file), "the scratch file can be written");
}

void require_clear(std::string_view message) {
    require(!message.empty() && message.size() <= kLongestMessage, message);
    require(is_plain_text(message), message);
}

}  // namespace meniscus::fuzz
