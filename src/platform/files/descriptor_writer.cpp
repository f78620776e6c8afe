// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "platform/files/descriptor_writer.h"

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <new>
#include <utility>

namespace meniscus {
namespace {

// Every call ends at a multiple of so many bytes. Linux caches a file in pieces of memory no larger than the call and
// aligned to their size, at a cost of each. Larger ones it may first have to get from the host of a virtual machine, at
// ten times the cost.
constexpr std::size_t kPerCallToCache = std::size_t{1} << 16U;

constexpr std::size_t kPerCallToDisk = std::size_t{1} << 20U;
constexpr std::align_val_t kDiskPage{4096};  // a multiple of what disks want addresses and sizes to be aligned to

constexpr std::size_t kStretch = std::size_t{1} << 24U;  // bytes from one comparison to the next
constexpr std::chrono::duration<double> kSlow{12e-3};    // for a stretch, where a fast disk takes 8 ms
static_assert(kStretch % kPerCallToCache == 0 && kStretch % kPerCallToDisk == 0, "ways change between calls");

bool set_direct([[maybe_unused]] int descriptor, [[maybe_unused]] bool direct) {
#ifdef O_DIRECT
    const int flags = ::fcntl(descriptor, F_GETFL);
    return flags >= 0 && ::fcntl(descriptor, F_SETFL, direct ? flags | O_DIRECT : flags & ~O_DIRECT) == 0;
#else
    return false;
#endif
}

ssize_t write_uninterrupted(int descriptor, const char* data, std::size_t size) {
    ssize_t written = -1;
    do written = ::write(descriptor, data, size);
    while (written < 0 && errno == EINTR);
    return written;
}

}  // namespace

void DescriptorWriter::FreePages::operator()(char* pages) const { ::operator delete[](pages, kDiskPage); }

DescriptorWriter::DescriptorWriter(int descriptor, bool may_change_way, Way first)
    : descriptor_(descriptor), may_change_way_(may_change_way) {
    if (first == Way::Disk) turn_to_disk();
}

int DescriptorWriter::write(const char* data, std::size_t size) {
    while (size > 0) {
        const auto start = std::chrono::steady_clock::now();
        const ssize_t given = way_ == Way::Cache ? give_to_cache(data, size) : give_to_disk(data, size);
        if (given < 0) return errno;
        spent_ += std::chrono::steady_clock::now() - start;
        data += given;
        size -= static_cast<std::size_t>(given);
        if (may_change_way_ && written_ - compared_ >= kStretch) compare_ways();
    }
    return 0;
}

ssize_t DescriptorWriter::give_to_cache(const char* data, std::size_t size) {
    const std::size_t to_multiple = kPerCallToCache - written_ % kPerCallToCache;
    const ssize_t given = write_uninterrupted(descriptor_, data, std::min(size, to_multiple));
    if (given > 0) written_ += static_cast<std::size_t>(given);
    return given;
}

ssize_t DescriptorWriter::give_to_disk(const char* data, std::size_t size) {
    const std::size_t given = std::min(size, kPerCallToDisk - waiting_);
    std::memcpy(for_the_disk_.get() + waiting_, data, given);
    waiting_ += given;
    if (waiting_ == kPerCallToDisk && !write_waiting()) return -1;
    return static_cast<ssize_t>(given);
}

// What the disk does not take, the cache is given. Whether all could be written (else: errno).
bool DescriptorWriter::write_waiting() {
    std::size_t done = 0;
    if (waiting_ == kPerCallToDisk) {
        const ssize_t written = write_uninterrupted(descriptor_, for_the_disk_.get(), waiting_);
        if (written > 0) done = static_cast<std::size_t>(written);
        written_ += done;
    }
    if (done < waiting_) {
        may_change_way_ = false;
        if (!turn_to_cache()) return false;
    }
    while (done < waiting_) {
        const ssize_t written = give_to_cache(for_the_disk_.get() + done, waiting_ - done);
        if (written < 0) return false;
        done += static_cast<std::size_t>(written);
    }
    waiting_ = 0;
    return true;
}

int DescriptorWriter::finish() { return write_waiting() ? 0 : errno; }

void DescriptorWriter::compare_ways() {
    const Seconds spent = std::exchange(spent_, Seconds(0.0));
    compared_ = written_;
    if (way_ == Way::Cache) {
        by_cache_ = spent;
        if (spent > kSlow) may_change_way_ = turn_to_disk();
    } else if (spent > by_cache_) {
        turn_to_cache();
        may_change_way_ = false;
    }
}

bool DescriptorWriter::turn_to_disk() {
    if (!for_the_disk_) for_the_disk_.reset(new (kDiskPage) char[kPerCallToDisk]);
    if (!set_direct(descriptor_, true)) return false;
    way_ = Way::Disk;
    return true;
}

bool DescriptorWriter::turn_to_cache() {
    way_ = Way::Cache;
    return set_direct(descriptor_, false);
}

}  // namespace meniscus
