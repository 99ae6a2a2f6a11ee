#!/usr/bin/env python3
"""Checks the sources against the plan of rooms, src/ripstop/rooms.txt:

- Every #include "ripstop/ROOM/..." of the library and the programs names a door of a room that may be included.
- A public door includes public doors only; ripstop.h includes all of them and nothing else.
- Every room has a line and at most 24 files.
- Rules that compilers do not check: no printing, no environment, no Eigen solver headers in public headers, no marks of
  unfinished work.

Prints every breach with its file, its line and the door to use; exits with 1 if there are any.

Usage: check_rooms.py [--write-face] SOURCE_FOLDER
--write-face rewrites ripstop.h from rooms.txt.
"""
import pathlib
import re
import sys

MOST_FILES = 24
INCLUDE = re.compile(r'\s*#include "ripstop/(?:([a-z_/]+)/)?([a-z0-9_]+\.h)"')
RULES = [  # pattern, suffixes it applies to, message
    (r"std::c(out|err)\b|\bprintf\(", {".h", ".cpp"}, "the library never prints"),
    (r"\bgetenv\(", {".h", ".cpp"}, "the library never reads the environment"),
    (r"#include <Eigen/(Sparse|Dense|SparseCholesky|Eigenvalues|CholmodSupport)>", {".h"},
     "public headers include Eigen/Core alone"),
    (r"\b(TODO|FIXME|XXX|HACK)\b", {".h", ".cpp"}, "no work left marked in the code"),
]


class Room:
    def __init__(self, name, uses, public, inner):
        self.name, self.uses, self.public, self.inner = name, uses, public, inner

    @property
    def floor(self):
        return self.name.split("/")[0]

    def may_use(self, other):
        return any(other == used or other.startswith(used + "/") for used in self.uses)

    def doors_for(self, floor):
        return self.public | self.inner if floor == self.floor else self.public


def read_rooms(path):
    rooms, faults = {}, []
    for number, line in enumerate(path.read_text().splitlines(), 1):
        if not line or line.startswith("#"):
            continue
        fields = line.split("|")
        if len(fields) not in (2, 3) or " :" not in fields[0]:
            faults.append(f"{path}:{number}: expected `ROOM : rooms | doors | doors to its own floor`")
            continue
        name, uses = (part.strip() for part in fields[0].split(" :"))
        room = Room(name, uses.split(), *(set(field.split()) for field in (fields + [""])[1:3]))
        floors = {other.floor for other in rooms.values()}
        for used in room.uses:
            if used not in rooms and used not in floors:
                faults.append(f"{path}:{number}: {name} may use {used}, which is no room or floor above this line")
        rooms[name] = room
    return rooms, faults


def check_plan(root, rooms):
    """Folders and doors exist, and no room is crowded."""
    faults = []
    for folder in sorted({file.parent for file in root.rglob("*.cpp")} | {file.parent for file in root.rglob("*.h")}):
        name = folder.relative_to(root).as_posix()
        if folder != root and name not in rooms:
            faults.append(f"{folder}: not a room of rooms.txt")
    for room in rooms.values():
        files = [file for file in (root / room.name).glob("*") if file.is_file()]
        if not files:
            faults.append(f"{root / room.name}: a room without files")
        if len(files) > MOST_FILES:
            faults.append(f"{root / room.name}: {len(files)} files in a room; {MOST_FILES} are the most, divide it")
        for door in sorted(room.public | room.inner):
            if not (root / room.name / door).exists():
                faults.append(f"{root / room.name / door}: a door of rooms.txt that is no file")
    return faults


def includes_of(file):
    for number, line in enumerate(file.read_text().splitlines(), 1):
        match = INCLUDE.match(line)
        if match:
            yield number, match[1] or "", match[2]


def check_includes(root, rooms):
    faults = []
    for file in sorted([*root.rglob("*.h"), *root.rglob("*.cpp")]):
        room = rooms.get(file.parent.relative_to(root).as_posix())
        if room is None:
            continue
        for number, name, header in includes_of(file):
            if not name:
                continue
            other = rooms.get(name)
            if other is None:
                faults.append(f"{file}:{number}: {name} is not a room of rooms.txt")
            elif other is room:
                if file.name in room.public and header not in room.public:
                    faults.append(f"{file}:{number}: a public door includes {name}/{header}, which is private; make that a door")
            elif not room.may_use(name):
                faults.append(f"{file}:{number}: {room.name} may not include {name}")
            elif header not in other.doors_for(room.floor):
                doors = ", ".join(sorted(other.doors_for(room.floor))) or "none"
                faults.append(f"{file}:{number}: {name}/{header} is private to its room; the doors of {name}: {doors}")
            elif file.name in room.public and header not in other.public:
                faults.append(f"{file}:{number}: a public door includes {name}/{header}, which only its own floor may; "
                              "make that a public door")
    return faults


def face(rooms):
    """The text of ripstop.h, from rooms.txt."""
    lines = ["#pragma once", "", "/// Everything public of Ripstop, lowest floor first. A program compiles faster with the headers it uses.",
             '#include "ripstop/version.h"']
    for floor in dict.fromkeys(room.floor for room in rooms.values() if room.public):
        doors = [f"{room.name}/{door}" for room in rooms.values() if room.floor == floor for door in room.public]
        lines += ["", f"// {floor}", *(f'#include "ripstop/{door}"' for door in sorted(doors))]
    return "\n".join(lines) + "\n"


def check_face(root, rooms):
    file, faults = root / "ripstop.h", []
    had, due = (text.splitlines() for text in (file.read_text() if file.exists() else "", face(rooms)))
    for line in due:
        if line.startswith("#include") and line not in had:
            faults.append(f"{file}: lacks {line}, a public door of rooms.txt")
    for number, line in enumerate(had, 1):
        if line.startswith("#include") and line not in due:
            faults.append(f"{file}:{number}: {line} is no public door of rooms.txt")
    return faults + [f"{file}: write it anew with scripts/check_rooms.py --write-face {root}"] if faults else []


def check_programs(apps, rooms):
    """The programs include public doors only, as library users do."""
    faults = []
    for file in sorted(file for kind in ("*.h", "*.cpp") for file in apps.rglob(kind) if "node_modules" not in file.parts):
        for number, name, header in includes_of(file):
            if name and (name not in rooms or header not in rooms[name].public):
                doors = ", ".join(sorted(rooms[name].public)) if name in rooms else "no such room"
                faults.append(f"{file}:{number}: {name}/{header} is private; the doors of {name}: {doors}")
    return faults


def check_rules(root):
    faults = []
    for file in sorted([*root.rglob("*.h"), *root.rglob("*.cpp")]):
        for number, line in enumerate(file.read_text().splitlines(), 1):
            for pattern, suffixes, message in RULES:
                if file.suffix in suffixes and re.search(pattern, line):
                    faults.append(f"{file}:{number}: {message}")
    return faults


def main(root, write_face):
    rooms, faults = read_rooms(root / "rooms.txt")
    if write_face:
        (root / "ripstop.h").write_text(face(rooms))
    faults += check_face(root, rooms)
    faults += check_plan(root, rooms) + check_includes(root, rooms) + check_rules(root)
    faults += check_programs(root.parent.parent / "apps", rooms)
    print("\n".join(faults), end="\n" if faults else "")
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main(pathlib.Path(sys.argv[-1]), "--write-face" in sys.argv[1:-1]))
