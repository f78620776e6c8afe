#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The Meniscus authors
# SPDX-License-Identifier: Apache-2.0
"""tools/make-web-page, with an engine that does nothing: the file hangs together, and is closed to all but its own scripts.

usage: make_page_test.py ROOT
"""
import base64
import collections
import hashlib
import html.parser
import json
import pathlib
import re
import subprocess
import sys
import tempfile
import unittest
import zlib

ROOT = pathlib.Path(sys.argv[1]).resolve()


class Reader(html.parser.HTMLParser):
    """Elements with their attributes; what scripts and styles say, as browsers cut them out of the text."""

    def __init__(self, page):
        super().__init__()
        self.elements = []
        self.text = page
        self.feed(re.sub(r"(<script[^>]*>).*?</script>", r"\1</script>", page, flags=re.DOTALL))
        self.close()

    def handle_starttag(self, tag, attributes):
        self.elements.append((tag, dict(attributes)))

    def of(self, tag):
        attributes = [attributes for name, attributes in self.elements if name == tag]
        contents = re.findall(rf"<{tag}\b[^>]*>(.*?)</{tag}>", self.text, flags=re.DOTALL)
        return list(zip(attributes, contents or len(attributes) * [""], strict=True))


class MakeWebPage(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        with tempfile.TemporaryDirectory(prefix="meniscus-") as folder:
            web = pathlib.Path(folder)
            (web / "meniscus.wasm").write_bytes(b"\0asm\1\0\0\0")
            (web / "meniscus-worker.js").write_text("onmessage = () => {};\n", encoding="utf-8")
            (web / "index.js").write_text("export class Meniscus {}\n", encoding="utf-8")
            subprocess.run([sys.executable, "-B", ROOT / "tools" / "make-web-page", web], check=True, capture_output=True)
            cls.text = (web / "meniscus.html").read_text(encoding="utf-8")
        cls.page = Reader(cls.text)
        cls.scripts = [content for attributes, content in cls.page.of("script")
                       if attributes.get("type") in (None, "module")]

    def policy(self):
        return next(a["content"] for a, _ in self.page.of("meta") if a.get("http-equiv") == "Content-Security-Policy")

    def test_the_policy_names_every_script_and_style_and_no_address(self):
        for content in [*self.scripts, *(content for _, content in self.page.of("style"))]:
            digest = base64.b64encode(hashlib.sha256(content.encode()).digest()).decode()
            self.assertIn(f"'sha256-{digest}'", self.policy())
        for word in ("default-src 'none'", "base-uri 'none'", "form-action 'none'", "worker-src blob:"):
            self.assertIn(word, self.policy())
        for word in ("connect-src", "'unsafe-inline'", "'unsafe-eval'", "http"):
            self.assertNotIn(word, self.policy())

    def test_every_id_is_there_once_and_scripts_ask_for_none_other(self):
        ids = collections.Counter(attributes["id"] for _, attributes in self.page.elements if "id" in attributes)
        self.assertEqual([name for name, count in ids.items() if count > 1], [])
        asked = set(re.findall(r"\$\(\"([\w-]+)\"\)|\bon\(\"([\w-]+)\", \"", "".join(self.scripts)))
        asked = {a or b for a, b in asked} - {"picture", "notice", "data", "atoms-", "question-"}  # of other pages; beginnings
        known = set(ids) | {"pointerdown", "pointermove", "contextmenu", "wheel", "keydown"}  # events of Controls
        self.assertEqual(asked - known, set())

    def test_labels_belong_to_fields(self):
        ids = {attributes.get("id") for _, attributes in self.page.elements}
        for attributes, _ in self.page.of("label"):
            if "for" in attributes:
                self.assertIn(attributes["for"], ids)

    def test_nothing_is_left_to_fill_in(self):
        outside = self.text.replace(next(script for script in self.scripts if "const Built" in script), "")
        self.assertEqual(re.findall(r"\{\{[\w-]+\}\}", outside), [])

    def test_a_page_saved_from_it_has_the_scripts_of_the_program_s_pages(self):
        script = next(script for script in self.scripts if "const Built" in script)
        built = json.loads(re.search(r"const Built = (.*);\n", script)[1].replace("<\\/", "</").replace("<\\!--", "<!--"))
        viewer = next(content for attributes, content in self.page.of("script") if attributes.get("id") == "viewer")
        digest = base64.b64encode(hashlib.sha256((viewer + built["begin"]).encode()).digest()).decode()
        self.assertIn(f"'sha256-{digest}'", built["page"]["policy"])
        self.assertNotIn("wasm", built["page"]["policy"])

    def test_the_example_is_in_it(self):
        packed = next(content for attributes, content in self.page.of("script") if attributes.get("id") == "example-file")
        self.assertEqual(zlib.decompress(base64.b64decode(packed)), (ROOT / "examples" / "1ubq.pdb").read_bytes())


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
