# SPDX-FileCopyrightText: 2026 The Meniscus authors
# SPDX-License-Identifier: Apache-2.0
"""Chromium on pages that use the npm package, served from this machine: for tests and the benchmark of bench/web."""
import functools
import http.server
import pathlib
import shutil
import sys
import tempfile
import threading
import time
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent / "page"))
import browser_test  # noqa: E402  how a browser is started

VIEWERS = {"molstar": "build/viewer/molstar.js", "3dmol": "build/3Dmol-min.js", "ngl": "dist/ngl.js"}


def missing(package, viewers):
    """What is not there, in words; None if all is. `viewers` is a folder with node_modules."""
    if not (package / "dist" / "index.js").is_file():
        return f"the built npm package ({package})"
    for name, script in VIEWERS.items():
        if not (viewers / "node_modules" / name / script).is_file():
            return f"the npm package {name} ({viewers})"
    return browser_test.missing()


class Handler(http.server.SimpleHTTPRequestHandler):
    """Folders under names; what tests lay out anew must not come from a cache."""

    def __init__(self, *arguments, places, **more):
        self.places = places
        super().__init__(*arguments, **more)

    def translate_path(self, path):
        path = path.split("?")[0].split("#")[0]
        start, folder = next((start, folder) for start, folder in self.places if path.startswith(start))
        return str(folder / path[len(start):])

    def end_headers(self):
        self.send_header("Cache-Control", "no-store")
        super().end_headers()

    def log_message(self, *_):
        pass


class Browser:
    """Package and viewers where npm would put them, below node_modules/; `folder` as made/; the repository for the rest."""

    def __init__(self, root, package, viewers, folder):
        places = (("/node_modules/meniscus-surface/", package), ("/node_modules/", viewers / "node_modules"),
                  ("/made/", folder), ("/", root))
        self.server = http.server.ThreadingHTTPServer(("127.0.0.1", 0), functools.partial(Handler, places=places))
        threading.Thread(target=self.server.serve_forever, daemon=True).start()
        self.driver = browser_test.start_browser(folder / "profile", "--window-size=800,600")
        self.driver.set_script_timeout(120)

    def close(self):
        self.driver.quit()
        self.server.shutdown()
        self.server.server_close()

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.close()

    def open(self, path):
        self.driver.get_log("browser")
        self.driver.get(f"http://127.0.0.1:{self.server.server_port}/{path}")

    def js(self, text, *arguments):
        return self.driver.execute_script(text, *arguments)

    def wait(self, condition, seconds=90):
        """Until a function, or an expression of the page, gives what is true; returns that."""
        end = time.monotonic() + seconds
        while not (value := condition() if callable(condition) else self.js(f"return {condition}")):
            if time.monotonic() > end:
                page = self.js("return document.body.innerText")
                raise AssertionError(f"never came true: {condition}; {page}; {self.driver.get_log('browser')}")
            time.sleep(0.1)
        return value

    def errors(self):
        return [entry for entry in self.driver.get_log("browser") if entry["level"] == "SEVERE"]


class BrowserTest(unittest.TestCase):
    """One browser for all tests of a class; each loads its page afresh."""

    @classmethod
    def setUpClass(cls):
        cls.folder = pathlib.Path(tempfile.mkdtemp(prefix="meniscus-web-"))
        cls.addClassCleanup(shutil.rmtree, cls.folder, ignore_errors=True)
        cls.browser = Browser(cls.root, cls.package, cls.viewers, cls.folder)
        cls.addClassCleanup(cls.browser.close)
        cls.open, cls.js, cls.wait = cls.browser.open, cls.browser.js, cls.browser.wait


def main(lacking=None):
    """The tests of the module that is run, with MENISCUS ROOT PACKAGE VIEWERS; `lacking` is what it itself misses."""
    BrowserTest.program, BrowserTest.root, BrowserTest.package, BrowserTest.viewers = (
        pathlib.Path(word).resolve() for word in sys.argv[1:5])
    lacking = lacking or missing(BrowserTest.package, BrowserTest.viewers)
    if lacking:
        print(f"SKIPPED: the npm package is not tested in a browser: {lacking} is missing (./test --full installs it)")
        sys.exit(browser_test.SKIPPED)
    unittest.main(argv=sys.argv[:1], verbosity=2)
