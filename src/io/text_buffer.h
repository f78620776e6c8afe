// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// Text that is made before the file it goes to is its turn: what several threads write of one.
#pragma once

#include <string>
#include <string_view>

#include "platform/files/digits.h"

namespace meniscus {

/// Takes what an AtomicFile takes.
class TextBuffer {
public:
    void clear() { text_.clear(); }  // keeps the memory
    void write(std::string_view text) { text_ += text; }
    void write(char c) { text_ += c; }

    /// As digits_of says.
    template <class Number>
    void number(Number value) {
        Digits digits;
        write(digits_of(value, digits));
    }

    std::string_view text() const { return text_; }

private:
    std::string text_;
};

}  // namespace meniscus
