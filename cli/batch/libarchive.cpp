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
    library->find("archive_error_string", found.error_string);
    library->find("archive_read_new", found.read_new);
    library->find("archive_read_free", found.read_free);
    library->find("archive_read_support_format_tar", found.read_support_format_tar);
    library->find("archive_read_open_fd", found.read_open_fd);
    library->find("archive_read_next_header", found.read_next_header);
    library->find("archive_read_header_position", found.read_header_position);
    library->find("archive_read_data_into_fd", found.read_data_into_fd);
    library->find("archive_write_new", found.write_new);
    library->find("archive_write_free", found.write_free);
    library->find("archive_write_set_format_pax_restricted", found.write_set_format_pax_restricted);
    library->find("archive_write_set_bytes_per_block", found.write_set_bytes_per_block);
    library->find("archive_write_set_options", found.write_set_options);
    library->find("archive_write_open_fd", found.write_open_fd);
    library->find("archive_write_header", found.write_header);
    library->find("archive_write_data", found.write_data);
    library->find("archive_write_finish_entry", found.write_finish_entry);
    library->find("archive_write_close", found.write_close);
    library->find("archive_entry_new", found.entry_new);
    library->find("archive_entry_free", found.entry_free);
    library->find("archive_entry_pathname", found.entry_pathname);
    library->find("archive_entry_pathname_utf8", found.entry_pathname_utf8);
    library->find("archive_entry_filetype", found.entry_filetype);
    library->find("archive_entry_hardlink", found.entry_hardlink);
    library->find("archive_entry_size", found.entry_size);
    library->find("archive_entry_set_pathname", found.entry_set_pathname);
    library->find("archive_entry_set_size", found.entry_set_size);
    library->find("archive_entry_set_filetype", found.entry_set_filetype);
    library->find("archive_entry_set_perm", found.entry_set_perm);
    library->find("archive_entry_set_mtime", found.entry_set_mtime);
    return found;
}

}  // namespace

const Libarchive& libarchive() {
    static const Libarchive functions = load();
    return functions;
}

}  // namespace meniscus::cli::batch
