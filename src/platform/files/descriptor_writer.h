// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// Bytes to an open file, past the system's cache of files where that is the slower way.
#pragma once

#include <sys/types.h>

#include <chrono>
#include <cstddef>
#include <memory>

namespace meniscus {

/// Writes to a descriptor whose file is empty so far; does not close it.
///
/// A page of the cache costs a fraction of a microsecond, but ten where a virtual machine has to get it back from its
/// host first: a gigabyte takes 2 s there and half a second to the disk. So the way is timed, and where it is slow a
/// large file goes on in the other one as long as that is quicker. The file is the same.
class DescriptorWriter {
public:
    /// Who takes the bytes.
    enum class Way {
        Cache,  ///< pages of memory, which the system writes to the disk when it likes
        Disk,   ///< the disk itself (O_DIRECT)
    };

    DescriptorWriter() = default;

    /// may_change_way   for a regular file whose description nobody shares
    /// first            Way::Disk, if the file system knows it, else Way::Cache
    DescriptorWriter(int descriptor, bool may_change_way, Way first = Way::Cache);

    /// Returns 0 or the error (errno).
    [[nodiscard]] int write(const char* data, std::size_t size);

    /// Writes what waits for the disk, which takes whole pages alone. To be called once, after the last byte.
    /// Returns 0 or the error (errno).
    [[nodiscard]] int finish();

private:
    using Seconds = std::chrono::duration<double>;

    [[nodiscard]] ssize_t give_to_cache(const char* data, std::size_t size);
    [[nodiscard]] ssize_t give_to_disk(const char* data, std::size_t size);
    bool write_waiting();
    void compare_ways();
    bool turn_to_disk();
    bool turn_to_cache();

    struct FreePages {
        void operator()(char* pages) const;
    };

    int descriptor_ = -1;
    bool may_change_way_ = false;
    Way way_ = Way::Cache;
    std::size_t written_ = 0;                          // bytes
    std::size_t compared_ = 0;                         // bytes of them, when ways were compared
    Seconds spent_{0.0};                               // since then
    Seconds by_cache_{0.0};                            // from one comparison to the next
    std::unique_ptr<char[], FreePages> for_the_disk_;  // the beginning of it waits
    std::size_t waiting_ = 0;                          // bytes
};

}  // namespace meniscus
