#!/usr/bin/env python3
"""Checks that headers are self-contained and that names are unique, without the minutes that a compiler takes:

- a header that names a type of another header or of the standard library includes it, itself or through what it includes;
- no class or enum of namespace ripstop is defined twice, in headers or in sources, unless in an unnamed namespace. Two
  classes of one name link silently, and the program then misbehaves if their layouts differ.

Prints every breach with file and line; exits 1 if there is any.

Usage: check_headers.py REPOSITORY
"""
import collections
import functools
import pathlib
import re
import sys

NOT_CODE = re.compile(r'//[^\n]*|/\*.*?\*/|R"(\w*)\(.*?\)\1"|"(?:\\.|[^"\\\n])*"|\'(?:\\.|[^\'\\\n])\'', re.S)
INCLUDE = re.compile(r'^\s*#include [<"]([^>"]+)[>"]', re.M)
OPENS = re.compile(r"(?:inline\s+)?namespace\b([^;{]*)$|(?:template\s*<.*>\s*)?(?:struct|class|union|enum(?:\s+class|\s+struct)?)"
                   r"\s+(?:\[\[\w+\]\]\s*)?([\w:]*\w)\s*(?:final\s*)?(?::[^:;{][^;{]*)?$", re.S)
STANDARD = {  # the headers that declare each name of std; any of them is enough
    "vector": "vector", "string": "string", "to_string": "string", "string_view": "string_view string", "array": "array",
    "optional": "optional", "nullopt": "optional", "function": "functional", "span": "span", "map": "map", "set": "set",
    "unordered_map": "unordered_map", "unordered_set": "unordered_set", "variant": "variant", "tuple": "tuple",
    "pair": "utility map vector", "move": "utility vector string map memory", "unique_ptr": "memory", "shared_ptr": "memory",
    "istream": "iosfwd istream iostream sstream fstream", "ostream": "iosfwd ostream iostream sstream fstream",
    "ifstream": "fstream", "ofstream": "fstream", "stringstream": "sstream", "numeric_limits": "limits", "deque": "deque",
    "uint8_t": "cstdint", "uint16_t": "cstdint", "uint32_t": "cstdint", "uint64_t": "cstdint", "int64_t": "cstdint",
    "size_t": "cstddef vector string array span map set memory functional utility", "ptrdiff_t": "cstddef vector string",
    "byte": "cstddef", "filesystem": "filesystem", "runtime_error": "stdexcept", "logic_error": "stdexcept",
    "exception": "exception stdexcept", "mutex": "mutex", "thread": "thread", "atomic": "atomic", "hypot": "cmath",
    "sqrt": "cmath", "abs": "cmath cstdlib", "sort": "algorithm", "numbers": "numbers", "min": "algorithm", "max": "algorithm",
    "initializer_list": "initializer_list vector string", "cmp_less": "utility", "source_location": "source_location",
    "chrono": "chrono", "list": "list", "complex": "complex", "bitset": "bitset", "any": "any", "queue": "queue",
}


def code_of(text):
    """The text without comments and literals, its lines as they were."""
    return NOT_CODE.sub(lambda found: re.sub(r"[^\n]", " ", found[0]), text)


def definitions(code):
    """(name, line) of every class and enum that a file defines, with its namespaces and classes; none of unnamed namespaces."""
    code = re.sub(r"^\s*#[^\n]*", lambda found: " " * len(found[0]), code, flags=re.M)
    scopes, start, found = [], 0, []
    for match in re.finditer(r"[{};]", code):
        head = code[start:match.start()].strip()
        start = match.end()
        if match[0] == "}":
            if scopes:
                scopes.pop()
        elif match[0] == "{":
            opens = OPENS.search(head.split("public:")[-1].strip()) if "(" not in head or head.startswith("template") else None
            name = None if opens is None else (opens[1].strip() or "(unnamed)") if opens[1] is not None else opens[2]
            scopes.append(name)
            if opens and opens[2] and None not in scopes and "(unnamed)" not in scopes:
                found.append(("::".join(scopes), code[:match.start()].count("\n") + 1))
    return found


class Headers:
    def __init__(self, root):
        self.root = root
        self.text = {file.relative_to(root.parent).as_posix(): file.read_text() for file in sorted(root.rglob("*.h"))}
        self.code = {name: code_of(text) for name, text in self.text.items()}
        self.includes = {name: INCLUDE.findall(text) for name, text in self.text.items()}
        self.home = collections.defaultdict(set)
        for name, code in self.code.items():
            for defined, _ in definitions(code):
                scope, _, last = defined.rpartition("::")
                if scope.startswith("ripstop") and scope.rpartition("::")[2][:1].islower():
                    self.home[last].add(name)
            for alias in re.findall(r"^using (\w+) =", code, re.M):
                self.home[alias].add(name)

    @functools.cache
    def reach(self, name):
        """All that a header includes, itself and through others, and itself."""
        result = {name}
        for other in self.includes.get(name, []):
            result |= self.reach(other)
        return result

    def faults(self, name):
        code, reach = self.code[name], self.reach(name)
        declared = set(re.findall(r"\b(?:struct|class|enum class|using|typename)\s+(\w+)", code))
        for token in sorted(set(re.findall(r"(?<![\w.:>])([A-Z]\w+)\b", code)) - declared):
            if token in self.home and not self.home[token] & reach:
                yield token, " or ".join(sorted(self.home[token]))
        for token in sorted(set(re.findall(r"\bstd::(\w+)", code))):
            if token in STANDARD and not set(STANDARD[token].split()) & reach:
                yield "std::" + token, STANDARD[token].split()[0]

    def check(self):
        result = []
        for name in self.text:
            for token, header in self.faults(name):
                line = next(n for n, text in enumerate(self.code[name].split("\n"), 1) if re.search(rf"\b{token}\b", text))
                result.append(f"{self.root.parent / name}:{line}: {token} is named, and {header} not included")
        return result


def check_single(folders):
    """Every class once: among the library and one program."""
    result, first = [], {}
    for folder in folders:
        for file in sorted(file for kind in ("*.h", "*.cpp", "*.mm") for file in folder.rglob(kind)):
            for name, line in definitions(code_of(file.read_text())):
                if name in first and first[name][0] != file:
                    result.append(f"{file}:{line}: {name} is defined a second time; the first is {':'.join(map(str, first[name]))}; "
                                  "call one of them otherwise, or put it into an unnamed namespace")
                first.setdefault(name, (file, line))
    return result


def main(repository):
    library = repository / "src/ripstop"
    faults = Headers(library).check()
    for program in ("apps/ripstop", "apps/cad", "tests", "fuzz", "bench"):
        faults += check_single([library, repository / program])
    faults = list(dict.fromkeys(faults))
    print("\n".join(faults), end="\n" if faults else "")
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main(pathlib.Path(sys.argv[1])))
