#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The Meniscus authors
# SPDX-License-Identifier: Apache-2.0
"""What docs/howto/web-viewers.md shows, run in Chromium.

usage: howto_test.py MENISCUS ROOT PACKAGE VIEWERS    as adapters_test.py
"""
import shutil
import sys
import pathlib

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent / "docs"))
import markdown  # noqa: E402

import web_browser

PAGE = """<!DOCTYPE html>
<link rel="icon" href="data:,">
<script src="node_modules/{name}/{script}"></script>
{map}<div id="view" style="position: relative; width: 400px; height: 300px"></div>
<script type="module">
{code}
globalThis.vertices = shown.surface.positions.length / 3;
</script>
"""


class HowTo(web_browser.BrowserTest):
    def test_what_is_shown_runs(self):
        shutil.copy(self.root / "examples" / "1ubq.pdb", self.folder)
        installed = self.folder / "node_modules"
        installed.mkdir()
        for name, folder in (("meniscus-surface", self.package), *((name, self.viewers / "node_modules" / name)
                                                                   for name in web_browser.VIEWERS)):
            (installed / name).symlink_to(folder)
        every = markdown.read(self.root / "docs" / "howto" / "web-viewers.md")[0]
        import_map, = (block.text for block in every if block.kind == "html")
        blocks = [block for block in every if block.kind == "js"]
        for_all = "".join(block.text for block in blocks if block.info == ["js"])
        self.assertEqual([block.info[1] for block in blocks if len(block.info) > 1], list(web_browser.VIEWERS))
        for name, script in web_browser.VIEWERS.items():
            with self.subTest(name):
                code = next(block.text for block in blocks if block.info == ["js", name]) + for_all
                page = PAGE.format(name=name, script=script, map=import_map, code=code)
                (self.folder / f"{name}.html").write_text(page, encoding="utf-8")
                self.open(f"made/{name}.html")
                self.assertGreater(self.wait("globalThis.vertices"), 10000)
                self.assertEqual(self.browser.errors(), [])


if __name__ == "__main__":
    web_browser.main()
