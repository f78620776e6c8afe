#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The Meniscus authors
# SPDX-License-Identifier: Apache-2.0
"""Recipes and workflows do what they say, as far as that can be tried without conda, Docker and Nextflow.

Snakemake runs its example where it is installed. For Nextflow the script of the process runs as Nextflow would write it;
of the conda recipe everything is checked that it names; tools/try-dockerfile runs the Dockerfile's commands.

usage: recipes_test.py PROGRAM SOURCE_DIR
"""
import json
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import unittest

try:
    import jinja2
    import yaml
except ImportError:
    jinja2 = yaml = None

PROGRAM, SOURCE = (pathlib.Path(word).resolve() for word in sys.argv[1:3])
SNAKEMAKE = shutil.which("snakemake", path="/usr/bin:" + os.environ["PATH"])
WITH_PROGRAM = {**os.environ, "PATH": f"{PROGRAM.parent}:{os.environ['PATH']}"}


def text_of(path):
    return (SOURCE / path).read_text(encoding="utf-8")


def cmake_options(text):
    return set(re.findall(r"-D(MENISCUS_[A-Z_]+)", text))


class CondaTest(unittest.TestCase):
    @unittest.skipUnless(yaml, "needs python3-yaml and python3-jinja2")
    def test_the_recipe_names_what_is_there(self):
        rendered = jinja2.Template(text_of("recipe/meta.yaml")).render(compiler="{}-compiler".format)
        recipe = yaml.safe_load(rendered)
        self.assertIn(f'kVersion = "{recipe["package"]["version"]}"', text_of("include/meniscus/version.h"))
        ours, *others = recipe["source"]
        self.assertEqual((SOURCE / "recipe" / ours["path"]).resolve(), SOURCE)
        for other in others:
            self.assertRegex(other["sha256"], "^[0-9a-f]{64}$")
        self.assertIn("cxx-compiler", recipe["requirements"]["build"])
        self.assertIn("build.sh", recipe["build"]["script"])
        inside = [*recipe["about"]["license_file"], *recipe["test"]["source_files"]]
        for path in inside:
            folder, _, rest = path.partition("/")
            self.assertEqual(folder, ours["folder"])
            self.assertTrue((SOURCE / rest).is_file(), rest)

    def test_its_script_uses_options_that_exist(self):
        known = "".join(text_of(path) for path in ("CMakeLists.txt", "src/render/CMakeLists.txt", "src/page/CMakeLists.txt"))
        for option in cmake_options(text_of("recipe/build.sh")):
            self.assertIn(option, known)
        subprocess.run(["bash", "-n", str(SOURCE / "recipe/build.sh")], check=True)


class DockerTest(unittest.TestCase):
    def test_it_installs_what_a_build_takes(self):
        (script,) = re.findall(r"\$\((sed .*)\)", text_of("recipes/Dockerfile"))
        found = subprocess.run(["bash", "-c", script], cwd=SOURCE, capture_output=True, text=True, check=True)
        section = text_of("packages.txt").split("\n[run]\n")[1].split("\n[test]\n")[0]
        wanted = [line.split("#")[0].strip() for line in section.splitlines()]
        self.assertEqual(found.stdout.split(), [name for name in wanted if name])


class WorkflowTest(unittest.TestCase):
    def setUp(self):
        self.folder = pathlib.Path(tempfile.mkdtemp(prefix="meniscus-"))
        self.addCleanup(shutil.rmtree, self.folder)
        (self.folder / "structures").mkdir()
        shutil.copy(SOURCE / "examples/1ubq.pdb", self.folder / "structures")
        (self.folder / "structures/broken.pdb").write_text("nothing\n", encoding="ascii")

    def run_here(self, *words):
        result = subprocess.run(words, cwd=self.folder, env={**WITH_PROGRAM, "HOME": str(self.folder)},
                                stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, check=False)
        self.assertEqual(result.returncode, 0, result.stdout)

    def check_results(self, path):
        lines = [json.loads(line) for line in (self.folder / path).read_text(encoding="utf-8").splitlines()]
        self.assertEqual([(line["input"], line["status"]) for line in lines],
                         [("1ubq.pdb", "done"), ("broken.pdb", "failed")])

    @unittest.skipUnless(SNAKEMAKE, "needs snakemake")
    def test_snakemake(self):
        self.run_here(SNAKEMAKE, "-s", str(SOURCE / "examples/workflows/Snakefile"), "--cores", "2", "--config",
                      "structures=structures", "out=measured", "shards=2")
        self.check_results("measured/results.jsonl")

    def test_script_of_the_nextflow_process(self):
        (script,) = re.findall(r'"""\n(.*?)"""', text_of("examples/workflows/measure.nf"), re.DOTALL)
        values = {"structures": "structures/1ubq.pdb structures/broken.pdb", "task.cpus": "1", "params.options": ""}
        script = re.sub(r"(?<!\\)\$\{(.*?)\}", lambda match: values[match[1]], script).replace("\\$", "$")
        self.run_here("bash", "-ue", "-c", script)
        self.check_results("part.jsonl")


unittest.main(argv=sys.argv[:1])
