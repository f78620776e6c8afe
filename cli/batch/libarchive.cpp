// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "batch/libarchive.h"

#include <optional>

#include "core/loaded_library.h"
#include "meniscus/errors.h"

namespace meniscus::cli::batch {

namespace {

Libarchive load() {
    const std::optional<LoadedLibrary> library = LoadedLibrary::load("libarchive.so.13");
    if (!library)
        throw InputError("tar archives need libarchive (Debian package libarchive13); install it, or use folders");
    return {
        .error_string = library->function<decltype(::archive_error_string)>("archive_error_string"),
        .read_new = library->function<decltype(::archive_read_new)>("archive_read_new"),
        .read_free = library->function<decltype(::archive_read_free)>("archive_read_free"),
        .read_support_format_tar =
            library->function<decltype(::archive_read_support_format_tar)>("archive_read_support_format_tar"),
        .read_set_options = library->function<decltype(::archive_read_set_options)>("archive_read_set_options"),
        .read_open_fd = library->function<decltype(::archive_read_open_fd)>("archive_read_open_fd"),
        .read_next_header = library->function<decltype(::archive_read_next_header)>("archive_read_next_header"),
        .read_header_position =
            library->function<decltype(::archive_read_header_position)>("archive_read_header_position"),
        .read_data_into_fd = library->function<decltype(::archive_read_data_into_fd)>("archive_read_data_into_fd"),
        .write_new = library->function<decltype(::archive_write_new)>("archive_write_new"),
        .write_free = library->function<decltype(::archive_write_free)>("archive_write_free"),
        .write_set_format_pax_restricted = library->function<decltype(::archive_write_set_format_pax_restricted)>(
            "archive_write_set_format_pax_restricted"),
        .write_set_bytes_per_block =
            library->function<decltype(::archive_write_set_bytes_per_block)>("archive_write_set_bytes_per_block"),
        .write_set_options = library->function<decltype(::archive_write_set_options)>("archive_write_set_options"),
        .write_open_fd = library->function<decltype(::archive_write_open_fd)>("archive_write_open_fd"),
        .write_header = library->function<decltype(::archive_write_header)>("archive_write_header"),
        .write_data = library->function<decltype(::archive_write_data)>("archive_write_data"),
        .write_finish_entry = library->function<decltype(::archive_write_finish_entry)>("archive_write_finish_entry"),
        .write_close = library->function<decltype(::archive_write_close)>("archive_write_close"),
        .entry_new = library->function<decltype(::archive_entry_new)>("archive_entry_new"),
        .entry_free = library->function<decltype(::archive_entry_free)>("archive_entry_free"),
        .entry_pathname = library->function<decltype(::archive_entry_pathname)>("archive_entry_pathname"),
        .entry_pathname_utf8 =
            library->function<decltype(::archive_entry_pathname_utf8)>("archive_entry_pathname_utf8"),
        .entry_filetype = library->function<decltype(::archive_entry_filetype)>("archive_entry_filetype"),
        .entry_hardlink = library->function<decltype(::archive_entry_hardlink)>("archive_entry_hardlink"),
        .entry_size = library->function<decltype(::archive_entry_size)>("archive_entry_size"),
        .entry_set_pathname = library->function<decltype(::archive_entry_set_pathname)>("archive_entry_set_pathname"),
        .entry_set_size = library->function<decltype(::archive_entry_set_size)>("archive_entry_set_size"),
        .entry_set_filetype = library->function<decltype(::archive_entry_set_filetype)>("archive_entry_set_filetype"),
        .entry_set_perm = library->function<decltype(::archive_entry_set_perm)>("archive_entry_set_perm"),
        .entry_set_mtime = library->function<decltype(::archive_entry_set_mtime)>("archive_entry_set_mtime"),
    };
}

}  // namespace

const Libarchive& libarchive() {
    static const Libarchive functions = load();
    return functions;
}

}  // namespace meniscus::cli::batch
