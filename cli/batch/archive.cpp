// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "batch/archive.h"

#include <archive.h>
#include <archive_entry.h>
#include <fcntl.h>
#include <fmt/core.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstring>
#include <utility>

#include "batch/libarchive.h"
#include "meniscus/errors.h"

namespace meniscus::cli::batch {

namespace {

constexpr std::size_t kBlock = 1U << 16U;

using Reader = std::unique_ptr<archive, int (*)(archive*)>;

std::string reason(archive* a) {
    const char* text = libarchive().error_string(a);
    return text != nullptr ? text : "unknown error";
}

[[noreturn]] void refuse(const std::string& path, const std::string& why) {
    throw InputError(
        fmt::format("{}: cannot be read as a tar archive: {}; decompress it first, since the members of a compressed "
                    "archive cannot be reached one by one",
                    path, why));
}

/// Reads the archive in `descriptor` from its place on. Names keep their bytes: in the locale "C" libarchive could turn
/// none but ASCII into anything else.
Reader open_reader(const std::string& path, int descriptor) {
    const Libarchive& lib = libarchive();
    Reader reader(lib.read_new(), lib.read_free);
    lib.read_support_format_tar(reader.get());
    if (lib.read_open_fd(reader.get(), descriptor, kBlock) != ARCHIVE_OK) refuse(path, reason(reader.get()));
    return reader;
}

/// The next header, or nothing at the end.
archive_entry* next_entry(const std::string& path, archive* reader) {
    archive_entry* entry = nullptr;
    const int state = libarchive().read_next_header(reader, &entry);
    if (state == ARCHIVE_EOF) return nullptr;
    if (state < ARCHIVE_WARN) refuse(path, reason(reader));
    return entry;
}

std::string name_of(const std::string& path, archive_entry* entry) {
    const char* name = libarchive().entry_pathname_utf8(entry);
    if (name == nullptr) name = libarchive().entry_pathname(entry);
    if (name == nullptr) refuse(path, "a member has a name that is not text");
    return name;
}

}  // namespace

std::vector<ArchiveMember> list_members(const std::string& path) {
    const Descriptor file(path, O_RDONLY);
    if (!file.is_open()) throw InputError(fmt::format("{}: cannot be read: {}", path, std::strerror(errno)));
    const Reader reader = open_reader(path, file.number());
    std::vector<ArchiveMember> members;
    while (archive_entry* entry = next_entry(path, reader.get())) {
        if (libarchive().entry_filetype(entry) != AE_IFREG || libarchive().entry_hardlink(entry) != nullptr) continue;
        members.push_back({name_of(path, entry), libarchive().read_header_position(reader.get()),
                           static_cast<std::uint64_t>(libarchive().entry_size(entry))});
    }
    return members;
}

void extract_member(const std::string& path, std::int64_t header, const std::string& file) {
    const Descriptor source(path, O_RDONLY);
    if (!source.is_open() || lseek(source.number(), header, SEEK_SET) != header)
        throw InputError(fmt::format("{}: cannot be read: {}", path, std::strerror(errno)));
    const Reader reader = open_reader(path, source.number());
    if (next_entry(path, reader.get()) == nullptr) refuse(path, "it has changed in the meantime");
    const Descriptor target(file, O_WRONLY | O_CREAT | O_TRUNC);
    if (!target.is_open()) throw OutputError(fmt::format("{}: cannot be written: {}", file, std::strerror(errno)));
    if (libarchive().read_data_into_fd(reader.get(), target.number()) != ARCHIVE_OK) refuse(path, reason(reader.get()));
}

ArchiveWriter::ArchiveWriter(std::string path, std::int64_t size)
    : path_(std::move(path)),
      file_(path_, O_RDWR | O_CREAT),
      archive_(libarchive().write_new(), libarchive().write_free) {
    if (!file_.is_open() || ftruncate(file_.number(), size) != 0 || lseek(file_.number(), size, SEEK_SET) != size)
        fail(std::strerror(errno));
    libarchive().write_set_format_pax_restricted(archive_.get());
    libarchive().write_set_bytes_per_block(archive_.get(), 0);  // what is written is in the file at once
    if (libarchive().write_set_options(archive_.get(), "hdrcharset=UTF-8") < ARCHIVE_WARN ||
        libarchive().write_open_fd(archive_.get(), file_.number()) != ARCHIVE_OK)
        fail(reason(archive_.get()));
}

void ArchiveWriter::add(const std::string& name, const std::string& file) {
    const Descriptor source(file, O_RDONLY);
    const off_t size = !source.is_open() ? -1 : lseek(source.number(), 0, SEEK_END);
    if (size < 0 || lseek(source.number(), 0, SEEK_SET) != 0) fail(file + ": " + std::strerror(errno));
    const std::unique_ptr<archive_entry, void (*)(archive_entry*)> entry(libarchive().entry_new(),
                                                                         libarchive().entry_free);
    libarchive().entry_set_pathname(entry.get(), name.c_str());
    libarchive().entry_set_size(entry.get(), size);
    libarchive().entry_set_filetype(entry.get(), AE_IFREG);
    libarchive().entry_set_perm(entry.get(), 0644);
    libarchive().entry_set_mtime(entry.get(), 0, 0);
    if (libarchive().write_header(archive_.get(), entry.get()) < ARCHIVE_WARN) fail(reason(archive_.get()));
    std::array<char, kBlock> block;
    for (ssize_t count; (count = read(source.number(), block.data(), block.size())) != 0;) {
        if (count < 0) fail(file + ": " + std::strerror(errno));
        if (libarchive().write_data(archive_.get(), block.data(), static_cast<std::size_t>(count)) != count)
            fail(reason(archive_.get()));
    }
    if (libarchive().write_finish_entry(archive_.get()) != ARCHIVE_OK) fail(reason(archive_.get()));
}

std::int64_t ArchiveWriter::size() const { return lseek(file_.number(), 0, SEEK_CUR); }

void ArchiveWriter::finish() {
    if (libarchive().write_close(archive_.get()) != ARCHIVE_OK) fail(reason(archive_.get()));
}

void ArchiveWriter::fail(const std::string& why) const {
    throw OutputError(fmt::format("{}: cannot be written: {}", path_, why));
}

}  // namespace meniscus::cli::batch
