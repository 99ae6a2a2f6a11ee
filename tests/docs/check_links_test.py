#!/usr/bin/env python3
"""Tests that check_links.py finds each kind of fault, and nothing in sound pages. Usage: check_links_test.py ROOT"""
import pathlib
import subprocess
import sys
import tempfile
import unittest

sys.dont_write_bytecode = True
ROOT = pathlib.Path(sys.argv.pop(1))
sys.path.insert(0, str(ROOT / "scripts/docs"))
import check_links  # noqa: E402


class Folder(unittest.TestCase):
    def setUp(self):
        self.held = tempfile.TemporaryDirectory()
        self.addCleanup(self.held.cleanup)
        self.root = pathlib.Path(self.held.name)

    def write(self, **files):
        for name, text in files.items():
            path = self.root / name.replace("__", "/").replace("_dot_", ".")
            path.parent.mkdir(parents=True, exist_ok=True)
            path.write_text(text)


class Site(Folder):
    def faults_of(self, body):
        self.write(a_dot_html=body, b_dot_html='<h1 id="there">B</h1>', p_dot_png="picture")
        return check_links.check_site(self.root)

    def test_takes_what_is_there(self):
        good = '<a id="own" href="b.html">b</a><a href="#own">o</a><a href="b.html#there">t</a><img src="p.png">'
        self.assertEqual(self.faults_of(good + '<a href="https://example.org/">out</a><img src="data:,x">'), [])

    def test_names_what_is_not(self):
        for body, word in [
            ('<a href="c.html">', "no such file"),
            ('<a href="b.html#here">', "no such anchor"),
            ('<a href="#own">', "no such anchor"),
            ('<img src="q.png">', "no such file"),
            ('<a href="../x">', "out of the site"),
            ('<p id="i"></p><p id="i">', "id twice"),
            ('<script src="https://example.org/x.js">', "network"),
            ('<link href="//example.org/x.css">', "network"),
        ]:
            with self.subTest(body):
                faults = self.faults_of(body)
                self.assertEqual(len(faults), 1, faults)
                self.assertIn(word, faults[0])

    def test_refuses_a_site_without_pages(self):
        self.assertEqual(len(check_links.check_site(self.root)), 1)

    def test_refuses_style_that_loads(self):
        self.write(s_dot_css="a { background: url(https://example.org/x.png) } b { background: url(data:,x) }")
        self.assertEqual(len([fault for fault in self.faults_of("") if "s.css" in fault]), 1)


class Sources(Folder):
    def faults_of(self, page):
        subprocess.run(["git", "init", "-q"], cwd=self.root, check=True)
        self.write(docs__a_dot_md=page, docs__b_dot_md="# Two words: here\n", src__ripstop__base__error_dot_h="")
        return check_links.check_sources(self.root)

    def test_takes_what_is_there(self):
        links = "[b](b.md) [c](b.md#two-words-here) [own](#a) ![made](../build/p.png) [out](https://example.org)\n"
        named = "`base/error.h` `src/ripstop/base/error.h` `src/ripstop/base/`\n"
        self.assertEqual(self.faults_of(f"# A\n{links}{named}```\n[x](none.md)\n```\n"), [])

    def test_names_what_is_not_with_its_line(self):
        links = ["[b](c.md)", "[b](b.md#two)", "[b](#b)", "![p](p.png)"]
        for page in [*links, "`base/none.h`", "`src/ripstop/none/`", "`tests/none.cpp`"]:
            with self.subTest(page):
                faults = self.faults_of(f"# A\n```\n\n```\n{page}\n")
                self.assertEqual(len(faults), 1, faults)
                self.assertTrue(faults[0].startswith("docs/a.md:5: "), faults[0])


if __name__ == "__main__":
    unittest.main()
