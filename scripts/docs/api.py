"""Writes pages of the public headers from doxygen's XML: a page per room, with every declaration of its doors in order."""
import html
import pathlib
import re
import subprocess
import xml.etree.ElementTree as ElementTree

HERE = pathlib.Path(__file__).parent
CLASSES = ("struct", "class", "union")
WIDTH = 100  # of a signature on one line
MARKS = {"ndash": "–", "mdash": "—", "nonbreakablespace": " ", "hellip": "…", "zwj": ""}
TAGS = {"computeroutput": "code", "emphasis": "em", "bold": "strong", "subscript": "sub", "superscript": "sup",
        "itemizedlist": "ul", "orderedlist": "ol", "listitem": "li", "blockquote": "blockquote"}


class Room:
    def __init__(self, name, doors):
        self.name, self.doors = name, doors
        self.page = name.replace("/", "-") + ".md"
        self.floor = name.split("/")[0]


def read_rooms(library):
    """The rooms of rooms.txt that have public doors, floor by floor.

    A line is `room : what it may include | public doors | doors to its own floor`."""
    rooms = []
    for line in (library / "rooms.txt").read_text().splitlines():
        parts = line.split("|")
        if line.startswith("#") or len(parts) < 2 or not parts[1].split():
            continue
        name = parts[0].split(":")[0].strip()
        rooms.append(Room(name, [f"{name}/{door}" for door in parts[1].split()]))
    floors = list(dict.fromkeys(room.floor for room in rooms))
    return sorted(rooms, key=lambda room: (floors.index(room.floor), room.name != room.floor))


def run_doxygen(root, headers, out):
    """Writes XML of the headers to out/xml; exits with doxygen's warnings if there are any."""
    out.mkdir(parents=True, exist_ok=True)
    inputs = " ".join(f"src/ripstop/{header}" for header in headers)
    config = (HERE / "Doxyfile").read_text() + f"\nINPUT = {inputs}\nOUTPUT_DIRECTORY = {out}\n"
    done = subprocess.run(["doxygen", "-"], input=config, text=True, cwd=root, capture_output=True)
    if done.returncode or done.stderr.strip():
        raise SystemExit(f"{done.stderr}\nmake docs: doxygen has warnings; none is ignored")


class Anchors:
    """The place on the site of every doxygen entity."""

    def __init__(self):
        self.place_of = {}
        self.taken = set()
        self.named = {}

    def add(self, identity, page, name):
        anchor = re.sub(r"\W+", "-", name).strip("-")
        number = 1
        while (page, anchor if number == 1 else f"{anchor}-{number}") in self.taken:
            number += 1
        anchor = anchor if number == 1 else f"{anchor}-{number}"
        self.taken.add((page, anchor))
        self.place_of[identity] = (page, anchor)
        return anchor

    def add_name(self, name, identity):
        """Records a name that comments may mention as code; an ambiguous name becomes no link."""
        self.named[name] = identity if name not in self.named else None

    def link_name(self, name):
        return self.link(self.named.get(name.removesuffix("()")), html.escape(name, quote=False))

    def link(self, identity, words):
        if identity not in self.place_of:
            return words
        page, anchor = self.place_of[identity]
        return f'<a href="{page.replace(".md", ".html")}#{anchor}">{words}</a>'


def unescaped(text):
    """Removes the marks that the Doxyfile's filter puts before # and --."""
    return re.sub(r"\\(#|--|>)", r"\1", text)


def inline(node, anchors):
    """The content of a description's node as HTML."""
    parts = [html.escape(node.text or "", quote=False)]
    for child in node:
        parts.append(element(child, anchors))
        parts.append(html.escape(child.tail or "", quote=False))
    return "".join(parts)


def element(node, anchors):
    if node.tag == "ref":
        return anchors.link(node.get("refid"), inline(node, anchors))
    if node.tag in MARKS:
        return MARKS[node.tag]
    if node.tag == "computeroutput" and len(node) == 0:
        return f"<code>{anchors.link_name(unescaped(node.text or ''))}</code>"
    if node.tag in ("verbatim", "preformatted"):
        return f"<pre>{html.escape(unescaped(node.text or '').rstrip(), quote=False)}</pre>"
    if node.tag == "programlisting":
        lines = ["".join(" " if part.tag == "sp" else part.text or "" for part in line.iter()) for line in node]
        text = "\n".join(lines)
        return f"<pre>{html.escape(text, quote=False)}</pre>"
    if node.tag == "ulink":
        return f'<a href="{html.escape(node.get("url"))}">{inline(node, anchors)}</a>'
    if node.tag == "para":
        return f"<p>{inline(node, anchors)}</p>"
    if node.tag in TAGS:
        return f"<{TAGS[node.tag]}>{inline(node, anchors)}</{TAGS[node.tag]}>"
    raise SystemExit(f"make docs: scripts/docs/api.py does not know doxygen's element {node.tag}")


def description(node, anchors):
    parts = []
    for tag in ("briefdescription", "detaileddescription"):
        parts += [element(child, anchors) for child in node.find(tag)]
    text = "".join(parts)
    # A block inside a paragraph ends it.
    text = re.sub(r"\s*<(pre|ul|ol|blockquote)>", r"</p><\1>", text)
    text = re.sub(r"</(pre|ul|ol|blockquote)>(?!</li>)\s*", r"</\1><p>", text)
    return re.sub(r"<p>\s*</p>", "", text)


def tight(text):
    """Types as written in the sources."""
    text = re.sub(r"\s+([&*])", r"\1", text)
    return text.replace("&lt; ", "&lt;").replace(" &gt;", "&gt;")


def code(node, anchors):
    return tight(inline(node, anchors).strip()) if node is not None else ""


def plain(text):
    return html.unescape(re.sub(r"<[^>]+>", "", text))


def parameter(param, anchors):
    type_, name = code(param.find("type"), anchors), param.findtext("declname") or ""
    array = param.findtext("array") or ""
    value = code(param.find("defval"), anchors)
    if "(*)" in type_:
        text = type_.replace("(*)", f"(*{name})")
    else:
        text = f"{type_} {name}{array}".strip()
    return f"{text} = {value}" if value else text


def template(node, anchors):
    params = node.find("templateparamlist")
    if params is None:
        return ""
    return f"template &lt;{', '.join(parameter(param, anchors) for param in params)}&gt;\n"


def function(member, anchors):
    type_ = code(member.find("type"), anchors)
    words = [word for word, key in (("static", "static"), ("explicit", "explicit")) if member.get(key) == "yes"]
    head = " ".join([*words, type_]).strip()
    head = f"{head} {member.findtext('name')}(".strip()
    params = [parameter(param, anchors) for param in member.findall("param")]
    args = member.findtext("argsstring") or ""
    tail = re.search(r"\)([^)]*)$", args)
    tail = html.escape(tail[1]) if tail else ""
    one = f"{head}{', '.join(params)}){tail};"
    if len(plain(one)) > WIDTH and params:
        separator = ",\n" + " " * 4
        one = f"{head}\n    {separator.join(params)}){tail};"
    return template(member, anchors) + one


def variable(member, anchors):
    type_, name = code(member.find("type"), anchors), member.findtext("name")
    args = member.findtext("argsstring") or ""
    value = re.sub(r"\s+", " ", code(member.find("initializer"), anchors))
    value = value if len(plain(value)) < 60 else "= …"
    args = re.sub(r" ([&*])(?=\w)", r"\1 ", args)
    if args.startswith(")"):  # a pointer to a function
        text = f"{type_.replace('(*', ' (*')}{name}{html.escape(args)}"
    else:
        text = f"{type_} {name}{html.escape(args)}"
    return f"{text} {value}".strip() + ";"


def signature(member, anchors):
    kind = member.get("kind")
    if kind == "function":
        return function(member, anchors)
    if kind == "typedef":
        return f"{template(member, anchors)}using {member.findtext('name')} = {code(member.find('type'), anchors)};"
    if kind == "define":
        return f"#define {member.findtext('name')}"
    return variable(member, anchors)


def line_of(node):
    return int(node.find("location").get("line"))


def row(text, doc, anchor=None):
    mark = f' id="{anchor}"' if anchor else ""
    return f"<tr{mark}><td><code>{text}</code></td><td>{doc}</td></tr>"


def wide_row(text, doc, anchor):
    return f'<tr id="{anchor}"><td colspan="2" class="method"><code>{text}</code>{doc}</td></tr>'


def values_table(member, anchors):
    rows = []
    for value in member.findall("enumvalue"):
        start = value.findtext("initializer") or ""
        text = html.escape(f"{value.findtext('name')} {start}".strip())
        rows.append(row(text, description(value, anchors), anchors.place_of[value.get("id")][1]))
    return f'<div class="wide"><table class="members">{"".join(rows)}</table></div>' if rows else ""


class Api:
    """All compounds of doxygen's XML, and the pages of the rooms."""

    def __init__(self, library, xml, rooms):
        self.compounds = {}
        for file in sorted(xml.glob("*.xml")):
            for node in ElementTree.parse(file).getroot().iter("compounddef"):
                self.compounds[node.get("id")] = node
        classes = [node for node in self.compounds.values() if node.get("kind") in CLASSES]
        self.classes = {node.findtext("compoundname") for node in classes}
        self.rooms = rooms
        self.anchors = Anchors()
        self.entities = {door: self.entities_of(door) for room in rooms for door in room.doors}
        self.lines = {door: (library / door).read_text().splitlines() for door in self.entities}
        empty = [door for door, nodes in self.entities.items() if not nodes]
        if empty:
            raise SystemExit(f"make docs: doxygen finds nothing in {', '.join(empty)}")
        for room in rooms:
            for door in room.doors:
                self.anchors.add(door, room.page, pathlib.PurePath(door).name)
                for name, node in self.first_of(door).items():
                    self.anchors.add_name(name, node.get("id"))
                for node in self.entities[door]:
                    self.place(node, room.page)

    def entities_of(self, door):
        """Structs, classes, functions, enums, aliases and constants of a header, in its order."""
        found = []
        for node in self.compounds.values():
            if node.get("kind") in CLASSES and self.is_in(node, door) and node.get("prot") == "public":
                if not self.is_nested(node) and "<" not in node.findtext("compoundname"):
                    found.append(node)
            if node.get("kind") == "namespace":
                found += [member for member in node.iter("memberdef") if self.is_in(member, door)]
        return sorted(found, key=line_of)

    @staticmethod
    def is_in(node, door):
        return node.find("location").get("file") == f"ripstop/{door}"

    def is_nested(self, node):
        return node.findtext("compoundname").rsplit("::", 1)[0] in self.classes

    @staticmethod
    def name_of(node):
        name = node.findtext("compoundname") or node.findtext("qualifiedname") or node.findtext("name")
        return re.sub(r"^ripstop::", "", name)

    def first_of(self, door):
        """The entities of a header by name; the first of several overloads."""
        first = {}
        for node in self.entities[door]:
            first.setdefault(self.name_of(node), node)
        return first

    def place(self, node, page):
        name = self.name_of(node)
        self.anchors.add(node.get("id"), page, name)
        for value in node.findall("enumvalue"):
            self.anchors.add(value.get("id"), page, f"{name}-{value.findtext('name')}")
        for member in self.public_members(node):
            self.anchors.add(member.get("id"), page, f"{name}-{member.findtext('name')}")
            for value in member.findall("enumvalue"):
                self.anchors.add(value.get("id"), page, f"{name}-{value.findtext('name')}")
        for inner in self.inner_of(node):
            self.place(inner, page)

    @staticmethod
    def public_members(node):
        members = [member for section in node.findall("sectiondef") for member in section
                   if member.tag == "memberdef" and member.get("prot") == "public" and member.get("kind") != "friend"]
        return sorted(members, key=line_of)

    def inner_of(self, node):
        return [self.compounds[inner.get("refid")] for inner in node.findall("innerclass")
                if inner.get("prot") == "public" and inner.get("refid") in self.compounds]

    def member_row(self, member):
        text, doc = signature(member, self.anchors), description(member, self.anchors)
        if member.get("kind") == "enum":
            text = f"enum {'class ' if member.get('strong') == 'yes' else ''}{member.findtext('name')}"
            doc += values_table(member, self.anchors)
        as_row = wide_row if member.get("kind") == "function" else row
        return as_row(text, doc, self.anchors.place_of[member.get("id")][1])

    def is_joined(self, node, door):
        """True if a declaration without a comment directly follows another and shares its heading."""
        before = self.lines[door][line_of(node) - 2].strip()
        return not description(node, self.anchors) and before != "" and not before.startswith("namespace")

    def without_comment(self):
        return [f"{door}:{line_of(node)}: {self.name_of(node)} has no comment" for door, nodes in self.entities.items()
                for node in nodes if not description(node, self.anchors) and not self.is_joined(node, door)]

    def show(self, node, is_overload=False):
        """Markdown of one entity: a heading (overloads share the first one's), and HTML in one block."""
        name, kind = self.name_of(node), node.get("kind")
        anchor = self.anchors.place_of[node.get("id")][1]
        heading = "" if is_overload else f"### {name} {{#{anchor}}}\n\n"
        mark = f' id="{anchor}"' if is_overload else ""
        doc = description(node, self.anchors)
        if kind in CLASSES:
            bases = [f"{base.get('prot')} {code(base, self.anchors)}" for base in node.findall("basecompoundref")]
            head = template(node, self.anchors) + f"{kind} {name}" + (f" : {', '.join(bases)}" if bases else "")
            rows = "".join(self.member_row(member) for member in self.public_members(node))
            body = f'<div class="wide"><table class="members">{rows}</table></div>' if rows else ""
        elif kind == "enum":
            head = f"enum {'class ' if node.get('strong') == 'yes' else ''}{name}"
            body = values_table(node, self.anchors)
        else:
            head, body = signature(node, self.anchors), ""
        block = f'<div class="entity"{mark}><pre class="signature">{head}</pre>{doc}{body}</div>'
        inner = "".join("\n\n" + self.show(each) for each in self.inner_of(node))
        return f"{heading}{one_block(block)}{inner}"

    def page_of(self, room):
        parts = [f"# {room.name}", ""]
        for door in room.doors:
            name = pathlib.PurePath(door).name
            parts += [f"## {name} {{#{self.anchors.place_of[door][1]}}}", "",
                      f"`#include \"ripstop/{door}\"`", ""]
            previous = None
            for node in self.entities[door]:
                is_same = node.get("kind") == "function" and self.name_of(node) == previous
                parts.append(self.show(node, is_same or self.is_joined(node, door)) + "\n")
                previous = self.name_of(node)
        return "\n".join(parts)

    def index(self, intro):
        parts = [intro, ""]
        for room in self.rooms:
            rows = []
            for door in room.doors:
                names = [self.anchors.link(node.get("id"), f"<code>{name}</code>")
                         for name, node in self.first_of(door).items()]
                header = self.anchors.link(door, f"<code>{pathlib.PurePath(door).name}</code>")
                rows.append(f"<tr><td>{header}</td><td>{', '.join(names)}</td></tr>")
            table = f'<div class="wide"><table class="doors">{"".join(rows)}</table></div>'
            parts += [f"## {room.name}", "", table, ""]
        return "\n".join(parts)


def one_block(text):
    """HTML without empty lines, so that Markdown does not change it."""
    return re.sub(r"\n(?=\n)", "\n&#8203;", text)


def write_pages(root, out, work):
    """Writes the pages of the API to out/api. Returns the rooms and the place of each door: {door: page#anchor}."""
    library = root / "src/ripstop"
    rooms = read_rooms(library)
    run_doxygen(root, [door for room in rooms for door in room.doors], work)
    api = Api(library, work / "xml", rooms)
    told = api.without_comment()
    if told:
        raise SystemExit("\n".join(told))
    folder = out / "api"
    folder.mkdir(parents=True)
    for room in rooms:
        (folder / room.page).write_text(api.page_of(room))
    (folder / "index.md").write_text(api.index((HERE / "api.md").read_text()))
    return rooms, {door: "api/{}#{}".format(*api.anchors.place_of[door]) for door in api.entities}
