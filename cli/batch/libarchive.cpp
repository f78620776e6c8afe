// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "batch/libarchive.h"

#include <optional>

#include "meniscus/errors.h"
#include "platform/files/loaded_library.h"

namespace meniscus::cli::batch {

namespace {

Libarchive load() {
    const std::optional<LoadedLibrary> library = LoadedLibrary::load("libarchive.so.13");
    if (!library)
        throw InputError("tar archives need libarchive (Debian package libarchive13); install it, or use folders");
    Libarchive found{};
    MENISCUS_FIND(library, archive_error_string, found.error_string);
    MENISCUS_FIND(library, archive_read_new, found.read_new);
    MENISCUS_FIND(library, archive_read_free, found.read_free);
    MENISCUS_FIND(library, archive_read_support_format_tar, found.read_support_format_tar);
    MENISCUS_FIND(library, archive_read_open_fd, found.read_open_fd);
    MENISCUS_FIND(library, archive_read_next_header, found.read_next_header);
    MENISCUS_FIND(library, archive_read_header_position, found.read_header_position);
    MENISCUS_FIND(library, archive_read_data_into_fd, found.read_data_into_fd);
    MENISCUS_FIND(library, archive_write_new, found.write_new);
    MENISCUS_FIND(library, archive_write_free, found.write_free);
    MENISCUS_FIND(library, archive_write_set_format_pax_restricted, found.write_set_format_pax_restricted);
    MENISCUS_FIND(library, archive_write_set_bytes_per_block, found.write_set_bytes_per_block);
    MENISCUS_FIND(library, archive_write_set_options, found.write_set_options);
    MENISCUS_FIND(library, archive_write_open_fd, found.write_open_fd);
    MENISCUS_FIND(library, archive_write_header, found.write_header);
    MENISCUS_FIND(library, archive_write_data, found.write_data);
    MENISCUS_FIND(library, archive_write_finish_entry, found.write_finish_entry);
    MENISCUS_FIND(library, archive_write_close, found.write_close);
    MENISCUS_FIND(library, archive_entry_new, found.entry_new);
    MENISCUS_FIND(library, archive_entry_free, found.entry_free);
    MENISCUS_FIND(library, archive_entry_pathname, found.entry_pathname);
    MENISCUS_FIND(library, archive_entry_pathname_utf8, found.entry_pathname_utf8);
    MENISCUS_FIND(library, archive_entry_filetype, found.entry_filetype);
    MENISCUS_FIND(library, archive_entry_hardlink, found.entry_hardlink);
    MENISCUS_FIND(library, archive_entry_size, found.entry_size);
    MENISCUS_FIND(library, archive_entry_set_pathname, found.entry_set_pathname);
    MENISCUS_FIND(library, archive_entry_set_size, found.entry_set_size);
    MENISCUS_FIND(library, archive_entry_set_filetype, found.entry_set_filetype);
    MENISCUS_FIND(library, archive_entry_set_perm, found.entry_set_perm);
    MENISCUS_FIND(library, archive_entry_set_mtime, found.entry_set_mtime);
    return found;
}

}  // namespace

const Libarchive& libarchive() {
    static const Libarchive functions = load();
    return functions;
}

}  // namespace meniscus::cli::batch
