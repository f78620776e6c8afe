# SPDX-FileCopyrightText: 2026 The Meniscus authors
# SPDX-License-Identifier: Apache-2.0
"""What cannot be asked of programs with sanitizers."""


def is_sanitized(program):
    """Whether a program was built with the address or the thread sanitizer. Such a program needs the whole address space,
    and takes the signals of crashes itself."""
    data = program.read_bytes()
    return b"__asan_init" in data or b"__tsan_init" in data
