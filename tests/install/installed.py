#!/usr/bin/env python3
"""Installs Ripstop, moves the prefix and uses it from there, as somebody who has neither sources nor build:

- the headers are ripstop.h, version.h and the public doors of rooms.txt; no file names a path of this build
- the program flattens with a fabric of its own, and finds the converters that are installed beside it
- examples/ and a consumer of ripstop.h alone are configured by find_package, built and run

Usage: installed.py CMAKE SOURCE BUILD TYPE COMPILER FLAGS
"""
import json
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

CMAKE, SOURCE, BUILD, TYPE, COMPILER, FLAGS = sys.argv[1:7]
ROOT = pathlib.Path(SOURCE)
sys.path.insert(0, str(ROOT / "scripts"))
import check_rooms  # noqa: E402


def run(*command, **options):
    done = subprocess.run([str(word) for word in command], capture_output=True, text=True, **options)
    if done.returncode != 0:
        sys.exit(f"{' '.join(map(str, command))} ended with {done.returncode}:\n{done.stdout}{done.stderr}")
    return done.stdout


def require(holds, what):
    if not holds:
        sys.exit(what)


def check_files(prefix):
    rooms, _ = check_rooms.read_rooms(ROOT / "src/ripstop/rooms.txt")
    doors = {f"{room.name}/{door}" for room in rooms.values() for door in room.public} | {"ripstop.h", "version.h"}
    include = prefix / "include/ripstop"
    headers = {file.relative_to(include).as_posix() for file in include.rglob("*.h")}
    require(headers == doors, f"installed headers are not the doors of rooms.txt: {sorted(headers ^ doors)}")
    if TYPE == "Debug":
        return  # debug information names sources
    here = re.compile(b"|".join(re.escape(os.fsencode(path)) + b"/(?:apps|build|cmake|data|docs|src|CMakeFiles|generated)"
                                for path in {SOURCE, BUILD, str(pathlib.Path(BUILD).parent)}))
    for file in prefix.rglob("*"):
        if file.is_file() and "node_modules" not in file.parts:
            found = here.search(file.read_bytes())
            require(not found, f"{file} names a path of this build: {found and os.fsdecode(found[0])}")


def check_program(prefix, folder):
    ripstop = prefix / "bin/ripstop"
    run(ripstop, "design", "natural", "-o", "envelope.obj", "--gores", "12", "--panels", "4", "--volume", "30", "--edge", "0.2m",
        cwd=folder)
    run(ripstop, "flatten", "envelope.obj", "--unit", "m", "--fabric", "nylon", "-o", "cut-plan", "--quiet", cwd=folder)
    report = json.loads((folder / "cut-plan/report.json").read_text())
    require(report["fabric"]["name"] == "nylon" and len(report["tiles"]) == 48, "not the plan of 48 tiles in nylon")
    if (prefix / "share/ripstop/rhino/node_modules").exists() and (prefix / "bin/ripstop-cad").exists() and shutil.which("node"):
        run("node", ROOT / "tests/cad/nurbs.mjs", "all", folder / "nurbs.3dm", "7")
        found = json.loads(run(ripstop, "inspect", "nurbs.3dm", "--json", cwd=folder))
        require(found["surfaces"] and not found["unread"], f"surfaces of Rhino are not read: {found}")


def build_and_run(prefix, project, build):
    run(CMAKE, "-S", project, "-B", build, f"-DCMAKE_PREFIX_PATH={prefix}", f"-DCMAKE_CXX_COMPILER={COMPILER}",
        f"-DCMAKE_CXX_FLAGS={FLAGS}", "-G", "Ninja" if shutil.which("ninja") else "Unix Makefiles")
    run(CMAKE, "--build", build, "--parallel", "2")


def main(folder):
    run(CMAKE, "--install", BUILD, "--prefix", folder / "prefix-tmp")
    prefix = folder / "elsewhere" / "ripstop"
    prefix.parent.mkdir()
    (folder / "prefix-tmp").rename(prefix)
    check_files(prefix)
    check_program(prefix, folder)
    build_and_run(prefix, ROOT / "tests/install/consumer", folder / "consumer")
    run(folder / "consumer/consumer")
    examples = prefix / "share/doc/ripstop/examples"
    long = [file.name for file in examples.glob("*.cpp") if len(file.read_text().splitlines()) > 60]
    require(not long, f"longer than 60 lines: {long}")
    build_and_run(prefix, examples, folder / "examples")
    print(run(pathlib.Path(CMAKE).with_name("ctest"), "--test-dir", folder / "examples", "--verbose"))


if __name__ == "__main__":
    with tempfile.TemporaryDirectory(dir=BUILD, prefix="installed-") as scratch:
        main(pathlib.Path(scratch))
