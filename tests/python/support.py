# SPDX-FileCopyrightText: 2026 The Meniscus authors
# SPDX-License-Identifier: Apache-2.0
"""What the tests of the Python package share."""
import os
import pathlib
import shutil
import tempfile
import unittest
import warnings

import meniscus

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
UBIQUITIN = str(ROOT / "examples" / "1ubq.pdb")
PROGRAM = os.environ.get("MENISCUS_PROGRAM", "")

# Two atoms that the probe can pass between and two that it cannot: contact, toroidal and reentrant patches.
CENTRES = [[0.0, 0.0, 0.0], [1.5, 0.2, 0.0], [2.4, 1.5, 0.3], [4.1, -1.0, 2.2]]
RADII = [1.7, 1.55, 1.52, 1.8]


def read(path, **options):
    """Without the warnings, which other tests look at."""
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", meniscus.ReadWarning)
        return meniscus.read(path, **options)


class InScratchFolder(unittest.TestCase):
    """Each test runs in an empty folder of its own."""

    def setUp(self):
        before = os.getcwd()
        folder = tempfile.mkdtemp(prefix="meniscus-python-")
        self.addCleanup(shutil.rmtree, folder)
        self.addCleanup(os.chdir, before)
        os.chdir(folder)
