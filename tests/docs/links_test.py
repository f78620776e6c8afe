#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The Meniscus authors
# SPDX-License-Identifier: Apache-2.0
"""Relative links and anchors in all Markdown files lead somewhere, and the manual's index names every page.

usage: links_test.py SOURCE_DIR
"""
import pathlib
import sys
import unittest

import markdown

SOURCE = pathlib.Path(sys.argv[1]).resolve()
LARGEST_PICTURE = 200_000  # bytes, of a picture of the manual
ALL_PICTURES = 1_500_000


def all_pages():
    return sorted([*SOURCE.glob("*.md"), *(SOURCE / "docs").rglob("*.md"), *(SOURCE / "examples").glob("*.md")])


class Links(unittest.TestCase):
    def test_every_link_leads_somewhere(self):
        count = 0
        for path in all_pages():
            for number, line in markdown.read(path)[1]:
                for target in markdown.LINK.findall(line):
                    if "://" in target or target.startswith("mailto:"):
                        continue
                    file, _, anchor = target.partition("#")
                    goal = (path.parent / file).resolve() if file else path
                    where = f"{path.relative_to(SOURCE)}:{number}: {target}"
                    self.assertTrue(goal.exists(), where)
                    if anchor:
                        self.assertIn(anchor, markdown.anchors(goal), where)
                    count += 1
        self.assertGreater(count, 50)

    def test_the_index_names_every_page(self):
        index = SOURCE / "docs" / "README.md"
        linked = {(index.parent / target.partition("#")[0]).resolve()
                  for _, line in markdown.read(index)[1] for target in markdown.LINK.findall(line)}
        for path in markdown.pages(SOURCE):
            if SOURCE / "docs" in path.parents and path != index:
                self.assertIn(path, linked, "add it to docs/README.md")

    def test_pictures_are_small_and_shown(self):
        text = "".join(path.read_text(encoding="utf-8") for path in markdown.pages(SOURCE))
        sizes = {path: path.stat().st_size for path in (SOURCE / "docs" / "images").iterdir()}
        for path, size in sizes.items():
            self.assertLess(size, LARGEST_PICTURE, path.name)
            self.assertIn(f"images/{path.name})", text, "no page shows it")
        self.assertLess(sum(sizes.values()), ALL_PICTURES)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
