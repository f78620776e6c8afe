#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The Meniscus authors
# SPDX-License-Identifier: Apache-2.0
"""Installs a build and uses it from a program outside: with CMake, with pkg-config, and as a part of another project.

usage: package_test.py BUILD SOURCE [unittest arguments]
The compiler and its flags are those of the variables CXX and CXXFLAGS. With MENISCUS_TEST_FULL=1 the library is also
built as a part of another project, from a copy in another folder, and has to be the same file (minutes).
"""
import json
import math
import os
import pathlib
import re
import shlex
import shutil
import subprocess
import sys
import tempfile
import unittest

BUILD = pathlib.Path(sys.argv[1]).resolve()
SOURCE = pathlib.Path(sys.argv[2]).resolve()
COMPILER = os.environ.get("CXX", "c++")
FLAGS = shlex.split(os.environ.get("CXXFLAGS", ""))
FULL = os.environ.get("MENISCUS_TEST_FULL") == "1"
VERSION = re.search(r'kVersion = "([0-9.]+)"', (SOURCE / "include/meniscus/version.h").read_text())[1]
EXAMPLE = SOURCE / "examples" / "cpp"

# A project that has set nothing, and must find nothing set after it has taken in this one.
CORE = """\
cmake_minimum_required(VERSION 3.25)
project(area LANGUAGES CXX)
find_package(meniscus 0.1 REQUIRED COMPONENTS core)
if(TARGET Meniscus::files)
  message(FATAL_ERROR "more than core was looked for")
endif()
add_executable(area area.cpp)
target_link_libraries(area PRIVATE Meniscus::core)
"""
AREA = """\
#include <cstdio>
#include "meniscus/exact_surface.h"
int main() { std::printf("%.12f", meniscus::ExactSurface({{{0, 0, 0}}, {1.7}}).measures().totals.ses_area); }
"""
PARENT = """cmake_minimum_required(VERSION 3.25)
project(parent LANGUAGES CXX)
set(CMAKE_EXPORT_COMPILE_COMMANDS ON)
add_subdirectory({source} meniscus)
foreach(name IN ITEMS CMAKE_BUILD_TYPE CMAKE_CXX_STANDARD CMAKE_MODULE_PATH)
  if({name_value})
    message(FATAL_ERROR "${{name}} is set")
  endif()
endforeach()
foreach(name IN ITEMS meniscus_cli test_core)
  if(TARGET ${{name}})
    message(FATAL_ERROR "${{name}} is built")
  endif()
endforeach()
add_executable(surface_of {example}/surface_of.cpp)
target_link_libraries(surface_of PRIVATE Meniscus::meniscus)
"""


def run(*words, **options):
    """Runs a command and gives what it printed; all of that is shown if it fails."""
    done = subprocess.run([str(word) for word in words], text=True, stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
                          check=False, **options)
    if done.returncode != 0:
        raise AssertionError(f"{shlex.join(map(str, words))}\n{done.stdout}")
    return done.stdout


class PackageTest(unittest.TestCase):
    """All tests share one installed tree, which was moved after it had been installed."""

    @classmethod
    def setUpClass(cls):
        cls.folder = pathlib.Path(tempfile.mkdtemp(prefix="meniscus-"))
        cls.addClassCleanup(shutil.rmtree, cls.folder)
        run("cmake", "--install", BUILD, "--prefix", cls.folder / "first")
        cls.prefix = (cls.folder / "first").rename(cls.folder / "moved")
        (cls.folder / "spheres.xyzr").write_text("0 0 0 1.7\n20 0 0 1.7\n")

    def one(self, pattern):
        """The only installed file that fits."""
        found = list(self.prefix.rglob(pattern))
        self.assertEqual(len(found), 1, f"{pattern}: {found}")
        return found[0]

    def environment(self):
        folder = self.one("meniscus.pc").parent
        return {**os.environ, "PKG_CONFIG_PATH": str(folder), "LD_LIBRARY_PATH": str(folder.parent)}

    def expect_works(self, program):
        picture = self.folder / f"{program.parent.name}.png"
        printed = run(program, self.folder / "spheres.xyzr", picture, env=self.environment())
        count, area = re.fullmatch(r"(\d+) atoms, ([\d.]+) square angstroms\n", printed).groups()
        self.assertEqual(count, "2")
        exact = 2 * 4 * math.pi * 1.7**2
        self.assertAlmostEqual(float(area), exact, delta=0.03 * exact)
        self.assertEqual(picture.read_bytes()[:4], b"\x89PNG")

    def configure(self, source, name, *options):
        run("cmake", "-G", "Ninja", "-S", source, "-B", self.folder / name, *options)
        return self.folder / name

    def test_a_cmake_project_finds_the_moved_tree_and_links_one_target(self):
        build = self.configure(EXAMPLE, "found", f"-DCMAKE_PREFIX_PATH={self.prefix}")
        self.assertIn(f"meniscus_DIR:PATH={self.prefix}", (build / "CMakeCache.txt").read_text())
        run("cmake", "--build", build)
        self.expect_works(build / "surface_of")

    def test_another_minor_version_is_not_taken(self):
        project = self.folder / "future"
        project.mkdir()
        major, minor, _ = VERSION.split(".")
        (project / "CMakeLists.txt").write_text((EXAMPLE / "CMakeLists.txt").read_text().replace(
            "meniscus 0.1 REQUIRED", f"meniscus {major}.{int(minor) + 1} REQUIRED"))
        (project / "surface_of.cpp").touch()
        with self.assertRaisesRegex(AssertionError, "(?s)compatible.*version"):
            self.configure(project, "refused", f"-DCMAKE_PREFIX_PATH={self.prefix}")

    def test_pkg_config_tells_a_compiler_all_it_needs(self):
        words = run("pkg-config", "--cflags", "--libs", "meniscus", env=self.environment()).split()
        program = self.folder / "plain" / "surface_of"
        program.parent.mkdir()
        run(COMPILER, "-std=c++20", *FLAGS, EXAMPLE / "surface_of.cpp", "-o", program, *words)
        self.expect_works(program)

    def test_core_alone_needs_nothing_but_a_thread_library(self):
        project = self.folder / "core"
        project.mkdir()
        (project / "CMakeLists.txt").write_text(CORE)
        (project / "area.cpp").write_text(AREA)
        build = self.configure(project, "core-build", f"-DCMAKE_PREFIX_PATH={self.prefix}")
        run("cmake", "--build", build)
        self.assertAlmostEqual(float(run(build / "area")), 4 * math.pi * 1.7**2, places=6)
        needed = re.findall(r"NEEDED.*\[(\S+?)\.so", run("readelf", "-d", build / "area"))
        self.assertLessEqual(set(needed), {"libtbb", "libstdc++", "libc++", "libc++abi", "libm", "libgcc_s", "libc", "libasan",
                                           "libubsan", "ld-linux-x86-64", "libmeniscus-core"}, needed)
        words = run("pkg-config", "--cflags", "--libs", "meniscus-core", env=self.environment()).split()
        run(COMPILER, "-std=c++20", *FLAGS, project / "area.cpp", "-o", self.folder / "core" / "area", *words)

    def test_another_project_takes_this_one_in_and_keeps_its_own_settings(self):
        parent = self.folder / "parent"
        parent.mkdir()
        source = SOURCE
        if FULL:
            source = self.folder / "copy"
            shutil.copytree(SOURCE, source, ignore=shutil.ignore_patterns(".git", "build", "build-*", "docs", "tests"))
        (parent / "CMakeLists.txt").write_text(PARENT.format(source=source, example=EXAMPLE, name_value="${name}"))
        build = self.configure(parent, "part")
        commands = {pathlib.Path(entry["file"]).name: entry["command"]
                    for entry in json.loads((build / "compile_commands.json").read_text())}
        self.assertNotRegex(commands["surface_of.cpp"], r" -W| -f(?!sanitize)| -O| -D|/src")
        self.assertIn("-ffp-contract=off", commands["gemmi_reader.cpp"])
        if FULL:
            run("cmake", "--build", build)
            self.expect_works(build / "surface_of")
            for name in ("libmeniscus-core.a", "libmeniscus-files.a", "libmeniscus-view.a"):
                self.assertTrue(self.one(name).read_bytes() == (build / "meniscus/src" / name).read_bytes(),
                                f"the same {name} built in another folder differs")

    def test_installed_headers_include_no_others_of_the_project(self):
        headers = {path.relative_to(self.prefix / "include").as_posix()
                   for path in (self.prefix / "include").rglob("*.h")}
        self.assertGreater(len(headers), 20)
        for header in headers:
            included = re.findall(r'#include "(.+)"', (self.prefix / "include" / header).read_text())
            self.assertLessEqual(set(included), headers, header)

    def test_installed_files_name_no_folder_of_the_build(self):
        for path in self.prefix.rglob("*"):
            if path.suffix in (".cmake", ".pc"):
                text = path.read_text()
                for folder in (SOURCE, BUILD, self.folder):
                    self.assertFalse(str(folder) in text, f"{path}: {folder}")
                self.assertNotRegex(text, r"/usr/\S+\.(so|a)\b", path)

    def test_everything_says_the_version_of_the_header(self):
        self.assertEqual(run(self.prefix / "bin/meniscus", "--version"), f"meniscus {VERSION}\n")
        self.assertIn(f"\nVersion: {VERSION}\n", self.one("meniscus.pc").read_text())
        self.assertIn(f'PACKAGE_VERSION "{VERSION}"', self.one("meniscus-config-version.cmake").read_text())
        self.assertIn(f"\nversion: {VERSION}\n", self.one("CITATION.cff").read_text())

    def test_programs_that_stand_in_for_others_have_links_under_their_names(self):
        folder = self.prefix / "lib/meniscus/dropins"
        for name in ("msms", "NanoShaper", "pdb_to_xyzr", "pdb_to_xyzrn"):
            self.assertEqual((folder / name).resolve().parent, self.prefix.resolve() / "bin", name)
        printed = run("msms", "-if", self.folder / "spheres.xyzr", "-of", self.folder / "spheres",
                      env={**os.environ, "PATH": f"{folder}:{os.environ['PATH']}"})
        self.assertIn("MSMS terminated normally", printed)
        self.assertTrue((self.folder / "spheres.vert").is_file())

    def test_the_pages_come_along(self):
        for name in ("LICENSE", "THIRD_PARTY_NOTICES.md", "CHANGELOG.md", "examples/1ubq.pdb", "docs/conventions.md",
                     "tools/slurm/meniscus-array.sh"):
            self.assertTrue((self.prefix / "share/doc/meniscus" / name).is_file(), name)


if __name__ == "__main__":
    unittest.main(argv=[sys.argv[0], *sys.argv[3:]])
