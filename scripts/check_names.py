#!/usr/bin/env python3
"""Finds constants and types in unnamed namespaces that have the name of one in a public header.

Sources are compiled in groups (CMAKE_UNITY_BUILD). There such a name silently hides the header's name in every source of
the group. The compiler itself refuses two such names that clash with each other.

Usage: check_names.py SOURCE_FOLDER
"""
import pathlib
import re
import sys

TYPE = re.compile(r"^(?:struct|class|enum class) (\w+)\s*(?::[^;]*)?\{")
CONSTANT = re.compile(r"^(?:inline )?(?:static )?const(?:expr)? [\w:<>, *&]*?(\w+)(?:\[\])?\s*(?:=|\{)")
FUNCTION = re.compile(r"^(?! )(?!using |return |template)[\w:<>,*& ]+ (\w+)\(")
UNNAMED = re.compile(r"^namespace \{\n(.*?)^\}  // namespace$", re.M | re.S)


def names(text):
    for line in text.split("\n"):
        found = TYPE.match(line) or CONSTANT.match(line)
        if found:
            yield found.group(1)


def main(folder):
    header_of = {}
    for header in sorted(folder.rglob("*.h")):
        for line in header.read_text().split("\n"):
            found = TYPE.match(line) or CONSTANT.match(line) or FUNCTION.match(line)
            if found:
                header_of.setdefault(found.group(1), header)
    faults = 0
    for source in sorted(folder.rglob("*.cpp")):
        for part in UNNAMED.findall(source.read_text()):
            for name in names(part):
                if name in header_of:
                    print(f"{source}: {name} is also a name of {header_of[name]}; call one of them otherwise")
                    faults += 1
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main(pathlib.Path(sys.argv[1])))
