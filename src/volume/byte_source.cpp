// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "volume/byte_source.h"

#include <algorithm>
#include <cstring>

#include "meniscus/errors.h"

namespace meniscus {

std::size_t ByteSource::read(char* data, std::size_t size) {
    std::size_t done = 0;
    while (done < size && (next_ < end_ || fill())) {
        const std::size_t part = std::min(size - done, end_ - next_);
        std::memcpy(data + done, buffer_.get() + next_, part);
        next_ += part;
        done += part;
    }
    return done;
}

void ByteSource::fail(const std::string& what) const { throw InputError(path_ + ": " + what); }

}  // namespace meniscus
