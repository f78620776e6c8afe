# SPDX-FileCopyrightText: 2026 The Meniscus authors
# SPDX-License-Identifier: Apache-2.0
"""The program that a wheel brings along; ``meniscus`` on the command line starts it."""
from __future__ import annotations

import os
import pathlib
import shutil
import sys

_BROUGHT = pathlib.Path(__file__).resolve().parent / "bin" / "meniscus"


def find() -> str | None:
    """The program of this package, which has the same version; without one that on the PATH."""
    return str(_BROUGHT) if os.access(_BROUGHT, os.X_OK) else shutil.which("meniscus")


def main() -> None:
    """Becomes the program, with the same words."""
    if not os.access(_BROUGHT, os.X_OK):
        sys.exit("meniscus: error: this package was built without the program; build it with MENISCUS_CLI=ON")
    os.execv(_BROUGHT, ["meniscus", *sys.argv[1:]])
