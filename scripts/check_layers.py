#!/usr/bin/env python3
"""Holds every #include "ripstop/FLOOR/..." under src/ripstop to layers.txt, and keeps the library's house rules
that a compiler does not: no printing, no environment, no Eigen solver headers in public headers, no work left marked in
the code. Prints every breach; exits 1 if there is any."""
import pathlib
import re
import sys

root = pathlib.Path(sys.argv[1])
allowed = {}
for line in (root / "layers.txt").read_text().splitlines():
    if re.match(r"[a-z_]+:", line):
        name, below = line.split(":")
        unknown = set(below.split()) - allowed.keys()
        assert not unknown, f"layers.txt: {name} names {unknown}, which is not below it"
        allowed[name] = {name, *below.split()}

RULES = [  # pattern, suffixes it holds for, what to say
    (r"std::c(out|err)\b|\bprintf\(", {".h", ".cpp"}, "the library never prints"),
    (r"\bgetenv\(", {".h", ".cpp"}, "the library never reads the environment"),
    (r"#include <Eigen/(Sparse|Dense|SparseCholesky|Eigenvalues|CholmodSupport)>", {".h"},
     "public headers include Eigen/Core alone"),
    (r"\b(TODO|FIXME|XXX|HACK)\b", {".h", ".cpp"}, "no work left marked in the code"),
]

broken = 0
for file in sorted(root.glob("*/*.*")):
    floor = file.parent.name
    if floor not in allowed:
        print(f"{file}: {floor} is not a floor of layers.txt")
        broken += 1
        continue
    for number, line in enumerate(file.read_text().splitlines(), 1):
        match = re.match(r'\s*#include "ripstop/([a-z_]+)/', line)
        if match and match[1] not in allowed[floor]:
            print(f"{file}:{number}: {floor} may not include {match[1]}")
            broken += 1
        for pattern, suffixes, message in RULES:
            if file.suffix in suffixes and re.search(pattern, line):
                print(f"{file}:{number}: {message}")
                broken += 1
sys.exit(broken > 0)
