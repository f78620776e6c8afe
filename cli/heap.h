// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// How the programs hold their memory: what is freed is kept, in large pages where small ones are dear.
#pragma once

namespace meniscus::cli {

/// Sets up the heap; for the beginning of main(), before other threads. Elsewhere than on Linux with glibc it does
/// nothing.
///
/// The stages take and give back arrays of many megabytes. By default each comes fresh from the kernel, which clears it
/// page by page; kept on the heap, the next stage gets the same pages. And where it takes the kernel long to hand out a
/// page, as in virtual machines whose page tables are kept by software, pages are asked for by 512
/// (docs/design/performance.md). Takes a tenth of a millisecond, there half of one.
void prepare_heap();

/// Starts the threads that will be used, while the first one reads.
///
/// Each prepares its own heap as it begins. Where pages are not dear, one of the threads touches, as long as this
/// lives, what the heap will hand out next; the first touch of a page takes longer than to fill it.
class WarmStart {
public:
    WarmStart();
    ~WarmStart();
    WarmStart(const WarmStart&) = delete;
    WarmStart& operator=(const WarmStart&) = delete;
};

}  // namespace meniscus::cli
