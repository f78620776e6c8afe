// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "batch/libarchive.h"

#include <dlfcn.h>

#include "meniscus/errors.h"

namespace meniscus::cli::batch {

namespace {

template <class Function>
Function find(void* library, const char* name) {
    void* const found = library == nullptr ? nullptr : dlsym(library, name);
    if (found == nullptr)
        throw InputError("tar archives need libarchive (Debian package libarchive13); install it, or use folders");
    return reinterpret_cast<Function>(found);
}

Libarchive load() {
    void* const library = dlopen("libarchive.so.13", RTLD_NOW | RTLD_LOCAL);
    return {
        .error_string = find<decltype(&::archive_error_string)>(library, "archive_error_string"),
        .read_new = find<decltype(&::archive_read_new)>(library, "archive_read_new"),
        .read_free = find<decltype(&::archive_read_free)>(library, "archive_read_free"),
        .read_support_format_tar =
            find<decltype(&::archive_read_support_format_tar)>(library, "archive_read_support_format_tar"),
        .read_set_options = find<decltype(&::archive_read_set_options)>(library, "archive_read_set_options"),
        .read_open_fd = find<decltype(&::archive_read_open_fd)>(library, "archive_read_open_fd"),
        .read_next_header = find<decltype(&::archive_read_next_header)>(library, "archive_read_next_header"),
        .read_header_position =
            find<decltype(&::archive_read_header_position)>(library, "archive_read_header_position"),
        .read_data_into_fd = find<decltype(&::archive_read_data_into_fd)>(library, "archive_read_data_into_fd"),
        .write_new = find<decltype(&::archive_write_new)>(library, "archive_write_new"),
        .write_free = find<decltype(&::archive_write_free)>(library, "archive_write_free"),
        .write_set_format_pax_restricted = find<decltype(&::archive_write_set_format_pax_restricted)>(
            library, "archive_write_set_format_pax_restricted"),
        .write_set_bytes_per_block =
            find<decltype(&::archive_write_set_bytes_per_block)>(library, "archive_write_set_bytes_per_block"),
        .write_set_options = find<decltype(&::archive_write_set_options)>(library, "archive_write_set_options"),
        .write_open_fd = find<decltype(&::archive_write_open_fd)>(library, "archive_write_open_fd"),
        .write_header = find<decltype(&::archive_write_header)>(library, "archive_write_header"),
        .write_data = find<decltype(&::archive_write_data)>(library, "archive_write_data"),
        .write_finish_entry = find<decltype(&::archive_write_finish_entry)>(library, "archive_write_finish_entry"),
        .write_close = find<decltype(&::archive_write_close)>(library, "archive_write_close"),
        .entry_new = find<decltype(&::archive_entry_new)>(library, "archive_entry_new"),
        .entry_free = find<decltype(&::archive_entry_free)>(library, "archive_entry_free"),
        .entry_pathname = find<decltype(&::archive_entry_pathname)>(library, "archive_entry_pathname"),
        .entry_pathname_utf8 = find<decltype(&::archive_entry_pathname_utf8)>(library, "archive_entry_pathname_utf8"),
        .entry_filetype = find<decltype(&::archive_entry_filetype)>(library, "archive_entry_filetype"),
        .entry_hardlink = find<decltype(&::archive_entry_hardlink)>(library, "archive_entry_hardlink"),
        .entry_size = find<decltype(&::archive_entry_size)>(library, "archive_entry_size"),
        .entry_set_pathname = find<decltype(&::archive_entry_set_pathname)>(library, "archive_entry_set_pathname"),
        .entry_set_size = find<decltype(&::archive_entry_set_size)>(library, "archive_entry_set_size"),
        .entry_set_filetype = find<decltype(&::archive_entry_set_filetype)>(library, "archive_entry_set_filetype"),
        .entry_set_perm = find<decltype(&::archive_entry_set_perm)>(library, "archive_entry_set_perm"),
        .entry_set_mtime = find<decltype(&::archive_entry_set_mtime)>(library, "archive_entry_set_mtime"),
    };
}

}  // namespace

const Libarchive& libarchive() {
    static const Libarchive functions = load();
    return functions;
}

}  // namespace meniscus::cli::batch
