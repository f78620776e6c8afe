#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The Meniscus authors
# SPDX-License-Identifier: Apache-2.0
"""clang-format on every source file and header; says what it would change."""
import sys

from sources import run, sources

result = run(["clang-format", "--dry-run", "--Werror", *map(str, sources(".h", ".cpp"))])
print(result.stdout, end="")
sys.exit(result.returncode)
