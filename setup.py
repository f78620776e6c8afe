# SPDX-FileCopyrightText: 2026 The Meniscus authors
# SPDX-License-Identifier: Apache-2.0
"""Builds the extension module of the Python package, and the program that it brings along, with CMake; everything else
is in pyproject.toml.

MENISCUS_BUILD     a CMake build folder of this project, configured with MENISCUS_PYTHON=ON for the same Python: what has
                   been built there is used. Without it everything is built, which takes some minutes.
MENISCUS_PLATFORM  the platform that the wheel is named for, as tools/make-wheel finds it out
"""
import os
import pathlib
import re
import subprocess
import sys
import sysconfig

from setuptools import Extension, setup
from setuptools.command.build_ext import build_ext

ROOT = pathlib.Path(__file__).resolve().parent
MODULE = "_core" + sysconfig.get_config_var("EXT_SUFFIX")


def version():
    """The one place where it is written."""
    text = (ROOT / "include" / "meniscus" / "version.h").read_text(encoding="utf-8")
    return re.search(r'kVersion = "([^"]+)"', text)[1]


class CMakeBuild(build_ext):
    def build_extension(self, extension):
        given = os.environ.get("MENISCUS_BUILD")
        build = pathlib.Path(given or self.build_temp).resolve()
        if not given:
            self.configure(build)
        subprocess.run(["cmake", "--build", str(build), "--target", "meniscus_python", "meniscus_cli"], check=True)
        built = build / "python" / "meniscus" / MODULE
        if not built.is_file():
            raise SystemExit(f"{build} was not configured for {sys.executable}: there is no {built}")
        target = pathlib.Path(self.get_ext_fullpath(extension.name))
        target.parent.mkdir(parents=True, exist_ok=True)
        self.copy_file(str(built), str(target))
        program = target.parent / "bin" / "meniscus"
        program.parent.mkdir(exist_ok=True)
        self.copy_file(str(build / "cli" / "meniscus"), str(program))
        licences = build / "licences.txt"
        if licences.is_file():
            self.copy_file(str(licences), str(target.parent / "licences.txt"))

    @staticmethod
    def configure(build):
        """FindPython and older modules are both told which Python it is: this one, whatever comes first on the PATH."""
        subprocess.run(["cmake", "-S", str(ROOT), "-B", str(build), "-G", "Ninja", "-DCMAKE_BUILD_TYPE=Release",
                        "-DMENISCUS_PYTHON=ON", "-DMENISCUS_CLI=ON", "-DMENISCUS_TESTS=OFF", "-DMENISCUS_INSTALL=OFF",
                        f"-DPython_EXECUTABLE={sys.executable}", f"-DPYTHON_EXECUTABLE={sys.executable}"], check=True)


# Dates within wheels: the earliest that they can hold, not of the build.
os.environ.setdefault("SOURCE_DATE_EPOCH", "315532800")
platform = os.environ.get("MENISCUS_PLATFORM")
options = {"bdist_wheel": {"plat_name": platform}} if platform else {}
setup(version=version(), options=options, ext_modules=[Extension("meniscus._core", sources=[])], cmdclass={"build_ext": CMakeBuild})
