# SPDX-FileCopyrightText: 2026 The Meniscus authors
# SPDX-License-Identifier: Apache-2.0
"""A wheel is built from the source tree, installed into a new virtual environment and used there.

usage: test_wheel.py SOURCE BUILD    BUILD: the build folder whose extension module goes into the wheel
"""
import os
import pathlib
import shutil
import subprocess
import sys
import tempfile
import zipfile

USE = """
import pathlib, sys
import meniscus
assert pathlib.Path(meniscus.__file__).is_relative_to(sys.prefix), meniscus.__file__
ball = meniscus.surface([[0, 0, 0]], [2.0])
assert abs(ball.measures.ses_area - 50.26548) < 1e-4
ball.save("ball.ply")
ball.save("ball.png", size=(64, 48))
pathlib.Path("ball.xyzr").write_text("0 0 0 2.0\\n")
(found,) = meniscus.map(["ball.xyzr"], jobs=1)
assert found["status"] == "done", found
assert abs(found["report"]["exact"]["ses_area"] - 50.26548) < 1e-4
print("meniscus", meniscus.__version__, "from a wheel")
"""


def run(*words, **options):
    result = subprocess.run([str(word) for word in words], stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True,
                            check=False, **options)
    if result.returncode != 0:
        sys.exit(f"{' '.join(map(str, words))}\n{result.stdout}")
    return result.stdout


def build_wheel(source, build, folder):
    """From a copy of what a wheel needs: pip would leave files in the source tree."""
    copy = folder / "source"
    copy.mkdir()
    for name in ("pyproject.toml", "setup.py", "LICENSE", "THIRD_PARTY_NOTICES.md"):
        shutil.copy(source / name, copy)
    shutil.copytree(source / "python", copy / "python", ignore=shutil.ignore_patterns("__pycache__"))
    (copy / "docs").mkdir()
    shutil.copy(source / "docs" / "python.md", copy / "docs")
    (copy / "include" / "meniscus").mkdir(parents=True)
    shutil.copy(source / "include" / "meniscus" / "version.h", copy / "include" / "meniscus")
    run(sys.executable, "-m", "pip", "wheel", "--no-build-isolation", "--no-deps", "--no-index", "-w", folder, copy,
        env={**os.environ, "MENISCUS_BUILD": str(build)})
    (wheel,) = folder.glob("meniscus-*.whl")
    return wheel


def main():
    source, build = (pathlib.Path(argument).resolve() for argument in sys.argv[1:])
    os.environ.pop("PYTHONPATH", None)
    with tempfile.TemporaryDirectory(prefix="meniscus-wheel-") as name:
        folder = pathlib.Path(name)
        wheel = build_wheel(source, build, folder)
        names = {pathlib.PurePath(member).name for member in zipfile.ZipFile(wheel).namelist()}
        wanted = {path.name for path in (source / "python" / "meniscus").iterdir() if path.is_file()} | {"LICENSE", "THIRD_PARTY_NOTICES.md"}
        assert wanted <= names, f"not in {wheel.name}: {sorted(wanted - names)}"
        run(sys.executable, "-m", "venv", "--system-site-packages", folder / "venv")  # for numpy
        python = folder / "venv" / "bin" / "python"
        run(python, "-m", "pip", "install", "--no-index", "--no-deps", wheel)
        # Without a program on the PATH: it must be the one of the wheel.
        alone = {**os.environ, "PATH": "/usr/bin:/bin"}
        print(run(python, "-c", USE, cwd=folder, env=alone), end="")
        version = run(folder / "venv" / "bin" / "meniscus", "--version", cwd=folder, env=alone).strip()
        assert version.split()[-1] == wheel.name.split("-")[1], version


main()
