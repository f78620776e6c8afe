#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The Meniscus authors
# SPDX-License-Identifier: Apache-2.0
"""./run and ./test install what is missing, and ask for no network where nothing is.

usage: setup_test.py SOURCE_DIR
"""
import os
import pathlib
import shutil
import subprocess
import sys
import tempfile
import unittest
from shlex import quote

SOURCE = pathlib.Path(sys.argv[1]).resolve()
# Stand-ins for the system's programs: what is installed is a line in `installed`, what is called one in `called`.
DPKG_QUERY = "#!/bin/sh\nsed 's/.*/installed &, ,/' installed; echo 'installed nodesource, npm (= 1), yarn,'\n"
APT_GET = "#!/bin/sh\necho \"$@\" >>called\n"
SUDO = "#!/bin/sh\nexec \"$@\"\n"


class SetupTest(unittest.TestCase):
    def setUp(self):
        self.folder = pathlib.Path(tempfile.mkdtemp(prefix="meniscus-"))
        self.addCleanup(shutil.rmtree, self.folder)
        for name, text in {"dpkg-query": DPKG_QUERY, "apt-get": APT_GET, "sudo": SUDO}.items():
            (self.folder / name).write_text(text, encoding="ascii")
            (self.folder / name).chmod(0o755)

    def packages(self, *sections):
        return self.bash(f"packages_of {' '.join(sections)}").split()

    def bash(self, words):
        done = subprocess.run(["bash", "-euc", f"root={quote(str(SOURCE))}; . {quote(str(SOURCE))}/tools/setup.sh; {words}"], cwd=self.folder,
                              env={**os.environ, "PATH": f"{self.folder}:{os.environ['PATH']}"}, capture_output=True,
                              text=True, check=False)
        self.assertEqual(done.returncode, 0, done.stderr)
        return done.stdout

    def install(self, *sections, installed):
        """What apt-get is called with."""
        (self.folder / "installed").write_text("\n".join(installed) + "\n", encoding="ascii")
        self.bash(f"install_packages {' '.join(sections)}")
        called = self.folder / "called"
        return called.read_text(encoding="ascii").splitlines() if called.exists() else []

    def test_nothing_is_asked_for_where_everything_is_there(self):
        everything = self.packages("run", "test", "full")
        self.assertGreater(len(everything), 30)
        self.assertEqual(self.install("run", "test", "full", installed=everything), [])

    def test_what_is_missing_is_installed(self):
        run = self.packages("run")
        self.assertEqual(self.install("run", installed=run[1:]),
                         ["update", f"install -y --no-install-recommends {run[0]}"])

    def test_a_build_that_is_watched_shows_how_far_it_is(self):
        lines = "[1/40 2.0] first\\n[10/40 60.5] tenth\\nan error\\n[39/40 120.0] last\\n"
        shown = self.bash(f"printf '{lines}' | show_progress 2>&1").replace("\r", "\n").replace("\033[K", "").splitlines()
        self.assertEqual(shown, ["", "building: 1 of 40 files", "building: 10 of 40 files, about 3 minutes left",
                                 "building: 39 of 40 files, less than a minute left"])

    def test_the_build_is_no_line_in_a_log(self):
        for name in ("cmake", "ninja"):
            (self.folder / name).write_text("#!/bin/sh\necho '[1/2 3.0] x'\n", encoding="ascii")
            (self.folder / name).chmod(0o755)
        self.assertEqual(self.bash("run_ninja folder target 2>&1"), "")
        self.assertEqual((self.folder / "folder.log").read_text(encoding="ascii"), "[1/2 3.0] x\n")

    def test_what_another_package_provides_is_not_missing(self):
        rest = [name for name in self.packages("full") if name != "npm"]
        self.assertEqual(self.install("full", installed=rest), [])

    def test_each_package_says_what_it_is_for(self):
        for line in (SOURCE / "packages.txt").read_text(encoding="utf-8").splitlines():
            if line and not line.startswith(("#", "[")):
                self.assertRegex(line, r"^[a-z0-9.+-]+ +# \S")

    def test_each_package_is_named_once(self):
        names = self.packages("run", "test", "full")
        self.assertEqual(len(names), len(set(names)))


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
