// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// The functions of libarchive that are used here, under their names without "archive_".
//
// The library is loaded when an archive is first named: Debian's brings eight others along, tens of megabytes, which no
// other run needs and the self-contained archive need not carry.
#pragma once

#include <archive.h>
#include <archive_entry.h>

namespace meniscus::cli::batch {

struct Libarchive {
    decltype(&::archive_error_string) error_string;
    decltype(&::archive_read_new) read_new;
    decltype(&::archive_read_free) read_free;
    decltype(&::archive_read_support_format_tar) read_support_format_tar;
    decltype(&::archive_read_open_fd) read_open_fd;
    decltype(&::archive_read_next_header) read_next_header;
    decltype(&::archive_read_header_position) read_header_position;
    decltype(&::archive_read_data_into_fd) read_data_into_fd;
    decltype(&::archive_write_new) write_new;
    decltype(&::archive_write_free) write_free;
    decltype(&::archive_write_set_format_pax_restricted) write_set_format_pax_restricted;
    decltype(&::archive_write_set_bytes_per_block) write_set_bytes_per_block;
    decltype(&::archive_write_set_options) write_set_options;
    decltype(&::archive_write_open_fd) write_open_fd;
    decltype(&::archive_write_header) write_header;
    decltype(&::archive_write_data) write_data;
    decltype(&::archive_write_finish_entry) write_finish_entry;
    decltype(&::archive_write_close) write_close;
    decltype(&::archive_entry_new) entry_new;
    decltype(&::archive_entry_free) entry_free;
    decltype(&::archive_entry_pathname) entry_pathname;
    decltype(&::archive_entry_pathname_utf8) entry_pathname_utf8;
    decltype(&::archive_entry_filetype) entry_filetype;
    decltype(&::archive_entry_hardlink) entry_hardlink;
    decltype(&::archive_entry_size) entry_size;
    decltype(&::archive_entry_set_pathname) entry_set_pathname;
    decltype(&::archive_entry_set_size) entry_set_size;
    decltype(&::archive_entry_set_filetype) entry_set_filetype;
    decltype(&::archive_entry_set_perm) entry_set_perm;
    decltype(&::archive_entry_set_mtime) entry_set_mtime;
};

/// throws   InputError where the library is not installed, and as LoadedLibrary
const Libarchive& libarchive();

}  // namespace meniscus::cli::batch
