#!/usr/bin/env python3
"""Checks every link of the documentation; prints the broken ones and exits with 1 if there are any.

Usage: check_links.py --sources ROOT   the Markdown of the project: files, anchors, sources named in `code`
       check_links.py --site FOLDER    the built site: pages, anchors, pictures; nothing may be loaded from a network
"""
import html.parser
import pathlib
import re
import subprocess
import sys
import urllib.parse

FENCE = re.compile(r"^```.*?^```$", re.M | re.S)
LINK = re.compile(r"!?\[[^\]]*\]\(([^)\s]+)\)")
FOLDERS = "apps|bench|cmake|data|docs|examples|fuzz|scripts|src|tests"
NAMED = re.compile(rf"`((?:{FOLDERS})/[\w./*-]+|[a-z_]+(?:/[a-z_]+)*/\w+\.(?:h|cpp))`")
MADE = re.compile(r"(\.\./)*build/|docs/.*-plan/")  # by the build or by the program


def anchor(heading):
    """The anchor that GitHub and the site give a heading."""
    return re.sub(r"[^\w -]", "", heading.lower()).strip().replace(" ", "-")


def anchors_of(text):
    return {anchor(heading) for heading in re.findall(r"^#+ +(.*?)(?: {2,}`.*)?$", FENCE.sub("", text), re.M)}


def line_of(text, place):
    return text.count("\n", 0, place) + 1


def blank(found):
    """Replaces fences by empty lines, so that line numbers stay valid."""
    return "\n" * found[0].count("\n")


def pages_of(root):
    command = ["git", "ls-files", "--cached", "--others", "--exclude-standard", "*.md"]
    listed = subprocess.run(command, cwd=root, capture_output=True, text=True, check=True)
    return [root / name for name in sorted(set(listed.stdout.split())) if (root / name).exists()]


def link_fault(page, target):
    if re.match(r"[a-z]+:", target) or MADE.match(target):
        return None
    path, _, fragment = target.partition("#")
    file = (page.parent / path).resolve() if path else page
    if not file.exists():
        return f"no such file: {target}"
    if fragment and fragment not in anchors_of(file.read_text()):
        return f"no heading of {file.name} gives #{fragment}"
    return None


def is_there(root, named):
    """True if a path of the sources, perhaps with *, matches a file."""
    below = [root] if re.match(rf"(?:{FOLDERS})/", named) else [root / "src/ripstop", root / "tests", root / "apps"]
    return any(next(folder.glob(named.rstrip("/")), None) for folder in below)


def check_sources(root):
    faults = []
    for page in pages_of(root):
        text = FENCE.sub(blank, page.read_text())
        name = page.relative_to(root)
        for found in LINK.finditer(text):
            fault = link_fault(page, found[1])
            if fault:
                faults.append(f"{name}:{line_of(text, found.start())}: {fault}")
        if page.name == "CHANGELOG.md":  # names what was
            continue
        for found in NAMED.finditer(text):
            if not is_there(root, found[1]):
                faults.append(f"{name}:{line_of(text, found.start())}: no such file: {found[1]}")
    return faults


class Page(html.parser.HTMLParser):
    """Collects the ids, links and loaded files of a page of the site."""

    def __init__(self, text):
        super().__init__()
        self.ids, self.twice, self.links, self.loaded = set(), set(), [], []
        self.feed(text)

    def handle_starttag(self, tag, attributes):
        values = dict(attributes)
        if "id" in values:
            (self.twice if values["id"] in self.ids else self.ids).add(values["id"])
        if tag == "a" and values.get("href") is not None:
            self.links.append(values["href"])
        elif "href" in values or "src" in values:
            self.loaded.append(values.get("href") or values.get("src"))


def site_fault(folder, pages, page, target, is_loaded):
    if re.match(r"data:", target):
        return None
    if re.match(r"[a-z]+:|//", target):
        return f"loads {target} from a network" if is_loaded else None
    path, _, fragment = urllib.parse.unquote(target).partition("#")
    file = (page.parent / path).resolve() if path else page
    if folder not in file.parents:
        return f"leads out of the site: {target}"
    if not file.is_file():
        return f"no such file: {target}"
    if fragment and file in pages and fragment not in pages[file].ids:
        return f"no such anchor: {target}"
    return None


def check_site(folder):
    folder = folder.resolve()
    pages = {file: Page(file.read_text()) for file in sorted(folder.rglob("*.html"))}
    faults = [] if pages else [f"{folder}: no page"]
    for file, page in pages.items():
        told = [site_fault(folder, pages, file, target, False) for target in page.links]
        told += [site_fault(folder, pages, file, target, True) for target in page.loaded]
        told += [f"id twice: {each}" for each in sorted(page.twice)]
        faults += [f"{file.relative_to(folder)}: {fault}" for fault in dict.fromkeys(told) if fault]
    for sheet in folder.rglob("*.css"):
        loaded = re.findall(r"url\((?!['\"]?data:)([^)]*)", sheet.read_text())
        faults += [f"{sheet.relative_to(folder)}: loads {url}" for url in loaded]
    return faults


def main(what, folder):
    faults = check_sources(folder.resolve()) if what == "--sources" else check_site(folder)
    for fault in faults:
        print(fault)
    return 1 if faults else 0


if __name__ == "__main__":
    if len(sys.argv) != 3 or sys.argv[1] not in ("--sources", "--site"):
        sys.exit(__doc__)
    sys.exit(main(sys.argv[1], pathlib.Path(sys.argv[2])))
