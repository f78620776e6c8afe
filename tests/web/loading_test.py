#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The Meniscus authors
# SPDX-License-Identifier: Apache-2.0
"""The npm package where its files are missing or served as something else: one clear error, and the next call tries again.

usage: loading_test.py MENISCUS ROOT PACKAGE VIEWERS    as adapters_test.py
"""
import shutil

import web_browser

WORKER, WASM = "meniscus-worker.js", "meniscus.wasm"
CALL = """
    globalThis.engine ??= new (await import("/made/dist/index.js")).Meniscus();
    const failed = ({message, code}) => ({message, code});
    return Promise.all([1, 2].map(radius => engine.measure({positions: [0, 0, 0], radii: [radius]})
      .then(({report}) => report.exact.sas_area, failed)));"""


class Handler(web_browser.Handler):
    """A server that takes what is in `disguised` for text, and has browsers believe it."""

    disguised = set()

    def guess_type(self, path):
        return "text/plain" if path.rpartition("/")[2] in self.disguised else super().guess_type(path)

    def end_headers(self):
        self.send_header("X-Content-Type-Options", "nosniff")
        super().end_headers()


class Loading(web_browser.BrowserTest):
    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        cls.dist = cls.folder / "dist"

    def setUp(self):
        self.addCleanup(Handler.disguised.clear)
        shutil.rmtree(self.dist, ignore_errors=True)
        shutil.copytree(self.package / "dist", self.dist)
        self.open("node_modules/meniscus-surface/examples/example.css")

    def expect_failure(self, *words):
        for error in self.js(CALL):
            self.assertIsInstance(error, dict)
            for word in (*words, "lie beside index.js"):
                self.assertIn(word, error["message"])

    def expect_success(self):
        areas = self.js(CALL)
        self.assertAlmostEqual(areas[0], 72.38, 1)
        self.assertAlmostEqual(areas[1], 145.27, 1)

    def test_a_file_that_is_missing_is_named_until_it_is_there(self):
        for name, words in ((WASM, (WASM, "404")), (WORKER, (WORKER,))):
            with self.subTest(name):
                self.setUp()
                (self.dist / name).unlink()
                self.expect_failure(*words)
                shutil.copy(self.package / "dist" / name, self.dist)
                self.expect_success()

    def test_a_page_in_place_of_the_module_is_said(self):
        (self.dist / WASM).write_text("<!DOCTYPE html>", encoding="ascii")
        self.expect_failure(WASM, "magic")
        shutil.copy(self.package / "dist" / WASM, self.dist)
        self.expect_success()

    def test_the_module_may_be_served_as_any_type(self):
        Handler.disguised.add(WASM)
        self.expect_success()

    def test_a_worker_that_is_served_as_text_is_said(self):
        Handler.disguised.add(WORKER)
        self.expect_failure(WORKER)
        Handler.disguised.clear()
        self.expect_success()


if __name__ == "__main__":
    web_browser.Handler = Handler
    web_browser.main()
