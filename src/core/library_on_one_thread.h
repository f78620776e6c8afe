// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// The thread library on one thread, for other libraries that run on it.
#pragma once

#include <memory>

namespace meniscus {

/// Limits what else runs on the thread library to one thread while it lives.
class LibraryOnOneThread {
public:
    LibraryOnOneThread();
    ~LibraryOnOneThread();
    LibraryOnOneThread(const LibraryOnOneThread&) = delete;
    LibraryOnOneThread& operator=(const LibraryOnOneThread&) = delete;

private:
    struct Control;
    std::unique_ptr<Control> control_;
};

}  // namespace meniscus
