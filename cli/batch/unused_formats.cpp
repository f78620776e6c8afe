// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// For portable builds: libarchive's table of formats names all that it can write. Those that are never asked for here
// and need more libraries (libxml2, liblzma, bzip2) are left out by being these.
#include <archive.h>

extern "C" {
int archive_write_set_format_7zip(archive* /*unused*/) { return ARCHIVE_FATAL; }
int archive_write_set_format_xar(archive* /*unused*/) { return ARCHIVE_FATAL; }
}
