"""Runs the same commands through two builds of ripstop and compares all that they print and write, byte for byte.

    compare.py ONE OTHER SOURCES SHARED_DATA

ONE and OTHER are commands, such as `build/release/ripstop` and `wine ripstop.exe`. Prints one line per difference and
ends with 1 if there is one. If SHARED_DATA is missing, its cases are left out with a message.
"""
import pathlib
import re
import shlex
import subprocess
import sys
import tempfile

# The commands of a case run one after the other in an empty folder. {sources} and {shared} are folders. The number after
# the arrow is the expected exit code; without an arrow it is 0.
CASES = {
    'designed': [
        'design natural -o envelope.obj --gores 16 --panel-height 1350mm --lobes 12 --volume 900',
        'check envelope.obj --unit m',
        'flatten envelope.obj --unit m --fabric nylon -o plan --reproducible --format dxf,svg,pdf,hpgl',
        'inflate plan --tapes meridians --reproducible',
        'nest plan --effort 2',
        'export plan --dialect gerber -o gerber',
        'validate plan/cut/envelope.dxf',
        'diff plan plan',
    ],
    'special shape': [
        'design special {sources}/docs/special.example.json -o bear.obj',
        'check bear.obj --unit m',
    ],
    'meshes of Rhino': [
        'inspect {sources}/tests/data/rhino/tiles_v8.3dm',
        'flatten {sources}/tests/data/rhino/tiles_v8.3dm -o plan --reproducible',
    ],
    'dress': [
        'flatten {shared}/dress/dress_knife_drape_3d.obj --unit cm -o plan --reproducible -> 1',
    ],
    'unusable input': [
        'flatten nothing.obj -o plan -> 3',
        'flatten {sources}/README.md -o plan -> 3',
        'check {sources}/fuzz/corpus/read_obj/bad_index.obj -> 3',
        'flatten -> 2',
        'no-such-command -> 2',
    ],
}

PROGRESS = re.compile('^ *\\d+ % done.*\n|^[A-Z][a-z]+ .* …\n'.encode(), re.MULTILINE)


def command_of(text):
    """The words of a command, with absolute paths of files, because it runs in other folders."""
    return [str(pathlib.Path(word).resolve()) if pathlib.Path(word).is_file() else word for word in shlex.split(text)]


def run(command, lines, folder, places):
    """What every command prints, and every file in the folder at the end, as name -> bytes."""
    found = {}
    for number, line in enumerate(lines, 1):
        line, _, code = line.partition(' -> ')
        arguments = [argument.format(**places) for argument in shlex.split(line)]
        done = subprocess.run([*command, *arguments], cwd=folder, capture_output=True)
        verb = f'{number} {arguments[0]}'
        if done.returncode != int(code or 0):
            said = done.stderr.decode(errors='replace')
            sys.exit(f'{shlex.join(command)} {line}: exit code {done.returncode}\n{said}')
        found[f'{verb}: stdout'] = done.stdout
        # Progress depends on the order in which threads finish their tiles, and on how long a step takes.
        found[f'{verb}: stderr'] = re.sub(PROGRESS, b'', done.stderr)
    for file in sorted(pathlib.Path(folder).rglob('*')):
        if file.is_file():
            found[file.relative_to(folder).as_posix()] = file.read_bytes()
    return found


def first_difference(one, other):
    """The place of the first difference of two texts, in words."""
    at = next((i for i, (a, b) in enumerate(zip(one, other)) if a != b), min(len(one), len(other)))
    return f'{len(one)} and {len(other)} bytes, different from byte {at} on: {one[at:at + 60]!r} and {other[at:at + 60]!r}'


def compare(one, other):
    for name in sorted(one.keys() | other.keys()):
        if name not in one or name not in other:
            yield f'{name}: written by {"the other" if name not in one else "the one"} alone'
        elif one[name] != other[name]:
            yield f'{name}: {first_difference(one[name], other[name])}'


def main():
    one, other = (command_of(text) for text in sys.argv[1:3])
    places = {'sources': str(pathlib.Path(sys.argv[3]).resolve()), 'shared': str(pathlib.Path(sys.argv[4]).resolve())}
    has_shared = pathlib.Path(places['shared']).is_dir()
    differs = False
    for case, lines in CASES.items():
        if not has_shared and any('{shared}' in line for line in lines):
            print(f'{case}: left out, no {places["shared"]}')
            continue
        with tempfile.TemporaryDirectory() as first, tempfile.TemporaryDirectory() as second:
            written = run(one, lines, first, places)
            differences = list(compare(written, run(other, lines, second, places)))
        differs |= bool(differences)
        print(f'{case}: {len(written)} outputs, {len(differences) or "none"} different')
        for difference in differences:
            print(f'    {difference}')
    return 1 if differs else 0


if __name__ == '__main__':
    sys.exit(main())
