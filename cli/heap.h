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
/// (docs/design/performance.md). Takes a tenth of a millisecond.
void prepare_heap();

/// The same for the heaps of the threads that will be started, this one included; 0 means all cores. To be called
/// before they are. Does nothing where pages are not dear, else it takes a tenth of a millisecond for each.
void prepare_heaps_of_threads(int threads);

}  // namespace meniscus::cli
