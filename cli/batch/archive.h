// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// Tar archives: members read one by one where they are, files appended one by one.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "batch/descriptor.h"

struct archive;

namespace meniscus::cli::batch {

struct ArchiveMember {
    std::string name;
    std::int64_t header = 0;  ///< byte of the archive where its header begins
    std::uint64_t size = 0;   ///< bytes
};

/// The files among the members of a tar archive, in its order; contents are skipped, not read.
/// throws   InputError for what is no tar archive, or a damaged one
std::vector<ArchiveMember> list_members(const std::string& path);

/// Writes one member to a file.
/// header   of an ArchiveMember
/// throws   InputError, OutputError
void extract_member(const std::string& path, std::int64_t header, const std::string& file);

/// Appends files to an archive that grows over several runs. Members have no owner and no time, so that the same files
/// in the same order give the same bytes.
class ArchiveWriter {
public:
    /// Goes on behind the first `size` bytes, which earlier writers left; what follows them is cut off.
    /// throws   OutputError, as every function
    ArchiveWriter(std::string path, std::int64_t size);

    void add(const std::string& name, const std::string& file);

    /// Bytes written so far, with those of earlier writers.
    std::int64_t size() const;

    /// Ends the archive; nothing can be added behind it by this writer.
    void finish();

private:
    [[noreturn]] void fail(const std::string& why) const;

    std::string path_;
    Descriptor file_;
    std::unique_ptr<archive, int (*)(archive*)> archive_;  // ends what it has begun before the file is closed
};

}  // namespace meniscus::cli::batch
