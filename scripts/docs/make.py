#!/usr/bin/env python3
"""Builds the site in build/docs: guide, methods, formats, decisions, and the API of the public headers.

Copies the Markdown to build/docs-work, with the guide's pictures and with links from headers to the API; adds the pages
of api.py; runs mkdocs; checks every link. Exits with 1 after any warning of doxygen, mkdocs or the check.

Usage: make.py [PROGRAM]   PROGRAM takes the guide's pictures if neither `make guide` nor the tests took them
"""
import json
import pathlib
import posixpath
import re
import shutil
import subprocess
import sys

import yaml

sys.dont_write_bytecode = True
import api  # noqa: E402
import check_links  # noqa: E402
import schemas  # noqa: E402

HERE = pathlib.Path(__file__).parent
ROOT = HERE.parent.parent
WORK = ROOT / "build/docs-work"
SITE = ROOT / "build/docs"
LINK = re.compile(r"(!?)\[([^\]]*)\]\(([^)\s]+)\)")
HEADER = re.compile(r"(?<!\[)`(?:src/ripstop/)?([a-z_]+(?:/[a-z_]+)*/\w+\.h)`")
TITLE = re.compile(r"^# (.*?)(?: {2,}`.*)?$", re.M)
PAGES = {"CONTRIBUTING.md": "contributing.md", "CHANGELOG.md": "changelog.md", "README.md": "index.md"}


def pictures(program):
    """The folder with the newest pictures of the guide."""
    folders = [ROOT / "build/guide/pictures", ROOT / "build/release/guide/pictures"]  # by `make guide`, by its test
    found = [folder for folder in folders if any(folder.glob("*.png"))]
    if found:
        return max(found, key=lambda folder: max(file.stat().st_mtime for file in folder.iterdir()))
    if not program:
        sys.exit("make docs: the guide has no pictures yet; `make guide` takes them")
    done = subprocess.run(["node", str(ROOT / "scripts/guide/make.mjs"), "--check", program, str(ROOT / "build/guide")])
    if done.returncode:
        sys.exit("make docs: the pictures of the guide could not be taken")
    return ROOT / "build/guide/pictures"


class Markdown:
    """Converts a page of the project for the site. `place_of` maps files of the project to their places on the site."""

    def __init__(self, place_of):
        self.place_of = place_of

    def page(self, text, source, target):
        """`source` is its path in the project, `target` its path on the site."""
        parts = re.split(r"(^```.*?^```$)", text, flags=re.M | re.S)
        for i, part in enumerate(parts):
            parts[i] = re.sub(r"^```(\w*).*", r"```\1", part, count=1) if i % 2 else self.prose(part, source, target)
        return "".join(parts)

    def prose(self, text, source, target):
        sources = re.compile(r"^# (.*?) {2,}(`.*)$", re.M)
        text = sources.sub(r"# \1\n\n\2\n{.sources}", text, count=1)
        text = LINK.sub(lambda found: self.link(found, source, target), text)
        return HEADER.sub(lambda found: self.to(found[0], f"src/ripstop/{found[1]}", target), text)

    def link(self, found, source, target):
        mark, words, path = found.groups()
        if re.match(r"[a-z]+:|#", path):
            return found[0]
        path, _, fragment = path.partition("#")
        file = posixpath.normpath(posixpath.join(posixpath.dirname(source), path))
        return mark + self.to(title_of(file) if words.endswith(".md") else words, file, target, fragment)

    def to(self, words, file, target, fragment=""):
        """A link to a file of the project; the words alone if the site does not have it."""
        if file not in self.place_of:
            return words
        place, _, anchor = self.place_of[file].partition("#")
        anchor = fragment or anchor
        path = posixpath.relpath(place, posixpath.dirname(target) or ".")
        return f"[{words}]({path}{'#' + anchor if anchor else ''})"


def title_of(file):
    """The heading of a page, for a link whose words are the name of a file."""
    found = TITLE.search((ROOT / file).read_text())
    return found[1] if found else file


def docs_of_project():
    """The files of docs/ and the pages beside it: {path in the project: path on the site}."""
    files = [file for file in sorted((ROOT / "docs").rglob("*")) if file.is_file()]
    return {**{str(file.relative_to(ROOT)): str(file.relative_to(ROOT / "docs")) for file in files}, **PAGES}


def places(place_of_door, folder_of_pictures):
    """The places on the site of files of the project."""
    shown = {f"build/guide/pictures/{file.name}": f"pictures/{file.name}" for file in folder_of_pictures.glob("*.png")}
    doors = {f"src/ripstop/{door}": place for door, place in place_of_door.items()}
    programs = {f"examples/{file.name}": f"examples.md#{file.stem}" for file in (ROOT / "examples").glob("*.cpp")}
    return {**docs_of_project(), **shown, **doors, **programs, "examples/README.md": "examples.md"}


def copy_docs(markdown, out):
    for source, name in docs_of_project().items():
        target = out / name
        target.parent.mkdir(parents=True, exist_ok=True)
        if source == "README.md":  # docs/index.md replaces it
            continue
        if target.suffix == ".md":
            target.write_text(markdown.page((ROOT / source).read_text(), source, name))
        else:
            shutil.copy(ROOT / source, target)


def references():
    """docs/references.bib as a page: one entry per line, with its key as cited in the headers."""
    entries = []
    for key, fields in re.findall(r"^@\w+\{([^,]+), (.*)\}$", (ROOT / "docs/references.bib").read_text(), re.M):
        field = dict(re.findall(r"(\w+) = \{?((?:[^{},]|\{[^}]*\}|,(?! \w+ = ))*)\}?", fields))
        field = {name: value.replace("{", "").replace("}", "") for name, value in field.items()}
        author = field.get("author", "").replace(" and ", ", ")
        rest = [field[name] for name in ("journal", "booktitle", "publisher", "note", "year") if field.get(name)]
        title = f"*{field['title']}*" if "title" in field else ""
        entries.append(f"| **[{key}]** | {', '.join(part for part in (author, title, *rest) if part)} |")
    head = "# References\n\nThe keys are those that headers and pages cite.\n\n| key | |\n|---|---|\n"
    return head + "\n".join(sorted(entries, key=str.lower)) + "\n"


def examples():
    """examples/README.md, followed by each program: what it shows, the headers it includes, and its text."""
    parts = [(ROOT / "examples/README.md").read_text().strip()]
    for file in sorted((ROOT / "examples").glob("*.cpp")):
        lines = file.read_text().splitlines()
        said = [line.lstrip("/ ") for line in lines if line.startswith("///")]
        code = "\n".join(line for line in lines if not line.startswith("///"))
        headers = re.findall(r'^#include "ripstop/(.*)"', code, re.M)
        parts += [f"## {file.name} {{#{file.stem}}}", " ".join(said)]
        parts += ["Headers: " + ", ".join(f"`{header}`" for header in headers), f"```cpp\n{code.strip()}\n```"]
    return "\n\n".join(parts) + "\n"


def pages_in(nav):
    for entry in nav:
        if isinstance(entry, str):
            yield entry
            continue
        for value in entry.values():
            yield from [value] if isinstance(value, str) else pages_in(value)


def configuration(rooms, of_schemas):
    config = yaml.safe_load((HERE / "mkdocs.yml").read_text())
    next(entry["Formats"] for entry in config["nav"] if "Formats" in entry).extend(of_schemas)
    of_rooms = [{room.name: f"api/{room.page}"} for room in rooms]
    listed = [{"All headers": "api/index.md"}, {"Examples": "examples.md"}, *of_rooms]
    config["nav"].append({"API": listed})
    config["docs_dir"], config["site_dir"] = str(WORK / "pages"), str(SITE)
    config["theme"]["custom_dir"] = str(HERE / "theme")
    return config


def check_nav(config):
    written = {str(file.relative_to(WORK / "pages")) for file in (WORK / "pages").rglob("*.md")}
    absent = sorted(written - set(pages_in(config["nav"])))
    if absent:
        sys.exit("".join(f"docs/{page}: not in the navigation of scripts/docs/mkdocs.yml\n" for page in absent).strip())


def run_mkdocs(config):
    (WORK / "mkdocs.yml").write_text(yaml.safe_dump(config, sort_keys=False))
    command = ["mkdocs", "build", "--strict", "--clean", "-f", str(WORK / "mkdocs.yml")]
    done = subprocess.run(command, capture_output=True, text=True)
    told = done.stdout + done.stderr
    if done.returncode or "WARNING" in told:
        told = "\n".join(line for line in told.splitlines() if not line.startswith("INFO"))
        sys.exit(f"{told}\nmake docs: mkdocs has warnings; none is ignored")


def keep_search():
    """The index as a script, because a page opened from a folder may not fetch files."""
    index = json.loads((SITE / "search/search_index.json").read_text())
    title_of = {doc["location"]: doc["title"] for doc in index["docs"] if "#" not in doc["location"]}
    docs = []
    for doc in index["docs"]:
        page, _, part = doc["location"].partition("#")
        if part:  # an entry without it repeats the text of its whole page
            docs.append({"at": doc["location"], "page": title_of[page], "title": doc["title"], "text": doc["text"]})
    shutil.rmtree(SITE / "search")
    (SITE / "search_index.js").write_text("window.searchIndex = " + json.dumps(docs, ensure_ascii=False) + ";\n")
    (SITE / "sitemap.xml.gz").unlink(missing_ok=True)
    (SITE / "sitemap.xml").unlink(missing_ok=True)


def main(program):
    shutil.rmtree(WORK, ignore_errors=True)
    pages = WORK / "pages"
    pages.mkdir(parents=True)
    rooms, place_of_door = api.write_pages(ROOT, pages, WORK / "doxygen")
    taken = pictures(program)
    markdown = Markdown(places(place_of_door, taken))
    copy_docs(markdown, pages)
    index = pages / "api/index.md"
    index.write_text(markdown.page(index.read_text(), "scripts/docs/api.md", "api/index.md"))
    (pages / "references.md").write_text(references())
    (pages / "examples.md").write_text(markdown.page(examples(), "examples/README.md", "examples.md"))
    shutil.copytree(taken, pages / "pictures")
    config = configuration(rooms, schemas.write_pages(ROOT / "docs", pages))
    check_nav(config)
    run_mkdocs(config)
    keep_search()
    faults = check_links.check_sources(ROOT) + check_links.check_site(SITE)
    if faults:
        sys.exit("\n".join(faults))
    print(SITE / "index.html")


if __name__ == "__main__":
    main(sys.argv[1] if len(sys.argv) > 1 else None)
