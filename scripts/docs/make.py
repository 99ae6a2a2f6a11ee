#!/usr/bin/env python3
"""Builds the site in build/docs: guide, methods, formats, decisions, and the API of the public headers.

Copies the Markdown to build/docs-work, with the pictures of the guide and with links from headers to the API; adds the
pages of api.py; runs mkdocs; checks every link. Any warning of doxygen, of mkdocs or of the check ends it with 1.

Usage: make.py [PROGRAM]   PROGRAM takes the pictures of the guide where neither `make guide` nor the tests took them
"""
import json
import pathlib
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
LINK = re.compile(r"\]\((?:docs/)?([\w/.-]+\.md)")
LINK_CALLED_AS_FILE = re.compile(r"\[([\w/.-]*\.md)\](?=\(([\w/.-]+\.md))")
LINK_TO_HEADER = re.compile(r"\[([^\]]*)\]\((?:\.\./)*src/ripstop/([^)]+)\)")
HEADER = re.compile(r"(?<!\[)`(?:src/ripstop/)?([a-z_]+(?:/[a-z_]+)*/\w+\.h)`")


def pictures(program):
    """The folder with the newest pictures of the guide."""
    folders = [ROOT / "build/guide/pictures", ROOT / "build/release/guide/pictures"]  # of `make guide`, of its test
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
    """Turns a page of the sources into one of the site."""

    def __init__(self, place_of_door):
        self.place_of_door = place_of_door

    def page(self, text, depth):
        up = "../" * depth
        parts = re.split(r"(^```.*?^```$)", text, flags=re.M | re.S)
        for i, part in enumerate(parts):
            parts[i] = re.sub(r"^```(\w*).*", r"```\1", part, count=1) if i % 2 else self.prose(part, up)
        return "".join(parts)

    def prose(self, text, up):
        text = re.sub(r"^# (.*?) {2,}(`.*)$", r"# \1\n\n\2\n{.sources}", text, count=1, flags=re.M)
        text = text.replace("../build/guide/pictures/", "pictures/")
        text = LINK_TO_HEADER.sub(lambda found: self.to_header(found[1], found[2], up), text)
        text = HEADER.sub(lambda found: self.to_header(found[0], found[1], up), text)
        text = LINK.sub(lambda found: f"]({self.renamed(found[1])}", text)
        return LINK_CALLED_AS_FILE.sub(lambda found: f"[{self.title_of(found[2]) or found[1]}]", text)

    @staticmethod
    def title_of(path):
        """The heading of a page, for a link whose words are a file's name."""
        file = next((ROOT / "docs").rglob(pathlib.PurePath(path).name), None)
        found = re.match(r"# (.*?)(?: {2,}`.*)?$", file.read_text(), re.M) if file else None
        return found and found[1]

    def to_header(self, words, header, up):
        place = self.place_of_door.get(header)
        return f"[{words}]({up}{place})" if place else words

    @staticmethod
    def renamed(path):
        return {"../CONTRIBUTING.md": "contributing.md", "../CHANGELOG.md": "changelog.md"}.get(path, path)


def copy_docs(markdown, out):
    sources = {file.relative_to(ROOT / "docs"): file for file in sorted((ROOT / "docs").rglob("*")) if file.is_file()}
    sources[pathlib.Path("contributing.md")] = ROOT / "CONTRIBUTING.md"
    sources[pathlib.Path("changelog.md")] = ROOT / "CHANGELOG.md"
    for name, file in sources.items():
        target = out / name
        target.parent.mkdir(parents=True, exist_ok=True)
        if file.suffix == ".md":
            target.write_text(markdown.page(file.read_text(), len(name.parts) - 1))
        else:
            shutil.copy(file, target)


def references():
    """docs/references.bib as a page: an entry a line, its key as the headers cite it."""
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
    listed = [{"All headers": "api/index.md"}, *({room.name: f"api/{room.page}"} for room in rooms)]
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
    done = subprocess.run(["mkdocs", "build", "--strict", "--clean", "--quiet", "-f", str(WORK / "mkdocs.yml")],
                          capture_output=True, text=True)
    told = done.stdout + done.stderr
    if done.returncode or "WARNING" in told:
        sys.exit(f"{told}\nmake docs: mkdocs has warnings; none is ignored")


def keep_search():
    """The index as a script, since a page that is opened from a folder may not fetch a file."""
    index = json.loads((SITE / "search/search_index.json").read_text())
    title_of = {doc["location"]: doc["title"] for doc in index["docs"] if "#" not in doc["location"]}
    docs = []
    for doc in index["docs"]:
        page, _, part = doc["location"].partition("#")
        if part:  # an entry without repeats the text of its whole page
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
    copy_docs(Markdown(place_of_door), pages)
    (pages / "references.md").write_text(references())
    shutil.copytree(pictures(program), pages / "pictures")
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
