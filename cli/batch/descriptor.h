// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// An open file by its number, closed with its owner.
#pragma once

#include <fcntl.h>
#include <unistd.h>

#include <string>
#include <utility>

namespace meniscus::cli::batch {

class Descriptor {
public:
    Descriptor() = default;
    explicit Descriptor(int number) : number_(number) {}
    /// Opens a file that programs started from here do not get; is_open() and errno tell whether that went well.
    Descriptor(const std::string& path, int flags) : number_(::open(path.c_str(), flags | O_CLOEXEC, 0666)) {}
    ~Descriptor() { close(); }
    Descriptor(Descriptor&& other) noexcept : number_(std::exchange(other.number_, -1)) {}
    Descriptor& operator=(Descriptor&& other) noexcept {
        close();
        number_ = std::exchange(other.number_, -1);
        return *this;
    }

    bool is_open() const { return number_ >= 0; }
    int number() const { return number_; }
    void close() {
        if (const int number = std::exchange(number_, -1); number >= 0) ::close(number);
    }

private:
    int number_ = -1;
};

}  // namespace meniscus::cli::batch
