#!/usr/bin/env python3
"""Draws docs/images/balloon.svg: the envelope that `make demo` designs, beside the pieces of its first gore.

The colours are for the picture alone. Usage, after `make demo`: balloon_picture.py demo docs/images/balloon.svg
"""
import json
import math
import pathlib
import sys

WIDTH, HEIGHT = 1200, 620
COLOURS = ["#c8102e", "#f2a900", "#f7f4ec"]
UP = math.radians(8)  # the eye is this far above the horizon
LIGHT = (0.45, -0.75, 0.48)
ROW = 4  # pieces beside each other


def read_tiles(path):
    """Name, vertices and triangles of each object."""
    tiles, vertices = [], []
    for line in path.read_text().splitlines():
        words = line.split()
        if line.startswith("o "):
            tiles.append((words[1], []))
        elif line.startswith("v "):
            vertices.append(tuple(map(float, words[1:4])))
        elif line.startswith("f "):
            tiles[-1][1].append([int(word.split("/")[0]) - 1 for word in words[1:4]])
    return vertices, tiles


def boundary(triangles):
    """The outline of a disk, as vertex numbers in order."""
    edges = {(a, b) for t in triangles for a, b in ((t[0], t[1]), (t[1], t[2]), (t[2], t[0]))}
    following = dict(edge for edge in edges if edge[::-1] not in edges)
    loop = [next(iter(sorted(following)))]
    while following[loop[-1]] != loop[0]:
        loop.append(following[loop[-1]])
    return loop


def seen(point):
    """Right, up and towards the eye."""
    x, y, z = point
    return x, z * math.cos(UP) + y * math.sin(UP), z * math.sin(UP) - y * math.cos(UP)


def normal_of(vertices, triangles):
    total = [0.0, 0.0, 0.0]
    for a, b, c in triangles:
        u = [vertices[b][k] - vertices[a][k] for k in range(3)]
        v = [vertices[c][k] - vertices[a][k] for k in range(3)]
        for k in range(3):
            total[k] += u[(k + 1) % 3] * v[(k + 2) % 3] - u[(k + 2) % 3] * v[(k + 1) % 3]
    length = math.sqrt(sum(each * each for each in total))
    return [each / length for each in total]


def shaded(colour, normal):
    light = sum(a * b for a, b in zip(normal, LIGHT)) / math.sqrt(sum(each * each for each in LIGHT))
    factor = 0.62 + 0.38 * max(0.0, light)
    return "#" + "".join(f"{round(int(colour[i:i + 2], 16) * factor):02x}" for i in (1, 3, 5))


def path(points):
    return "M" + "L".join(f"{x:.1f} {y:.1f}" for x, y in points) + "Z"


def colour_of(name):
    """A spiral of three colours: by gore and panel."""
    gore, panel = int(name[1:3]), int(name[4:6])
    return COLOURS[(gore + panel // 2) % 3]


def envelope_svg(vertices, tiles, box):
    drawn = []
    for name, triangles in tiles:
        normal = normal_of(vertices, triangles)
        points = [seen(vertices[v]) for v in boundary(triangles)]
        if seen(normal)[2] < -0.1:
            continue  # at the back
        depth = sum(point[2] for point in points) / len(points)
        drawn.append((depth, name, normal, points))
    low = [min(p[k] for _, _, _, points in drawn for p in points) for k in (0, 1)]
    high = [max(p[k] for _, _, _, points in drawn for p in points) for k in (0, 1)]
    left, top, width, height = box
    scale = min(width / (high[0] - low[0]), height / (high[1] - low[1]))
    x0 = left + width / 2 - scale * (low[0] + high[0]) / 2
    y0 = top + height / 2 + scale * (low[1] + high[1]) / 2
    lines = []
    for _, name, normal, points in sorted(drawn):
        placed = [(x0 + scale * p[0], y0 - scale * p[1]) for p in points]
        lines.append(f'<path fill="{shaded(colour_of(name), normal)}" d="{path(placed)}"/>')
    return "\n".join(lines)


def piece_svg(piece, box):
    left, top, width, height, scale = box
    cut, sew = piece["cut_line_m"], piece["sew_line_m"]
    low = [min(p[k] for p in cut) for k in (0, 1)]
    high = [max(p[k] for p in cut) for k in (0, 1)]
    x0 = left + width / 2 - scale * (low[0] + high[0]) / 2
    y0 = top + height / 2 + scale * (low[1] + high[1]) / 2

    def at(point):
        return x0 + scale * point[0], y0 - scale * point[1]

    lines = [f'<path class="cut" fill="{colour_of(piece["name"])}" d="{path(map(at, cut))}"/>',
             f'<path class="sew" d="{path(map(at, sew))}"/>']
    for notch in piece["notches"]:
        (x, y), out, depth = notch["on_sew_m"], notch["outward"], notch["reach_m"]
        a, b = at((x, y)), at((x + out[0] * depth, y + out[1] * depth))
        lines.append(f'<path class="notch" d="M{a[0]:.1f} {a[1]:.1f}L{b[0]:.1f} {b[1]:.1f}"/>')
    (ax, ay), (bx, by) = map(at, piece["grain_line_m"])
    lines.append(f'<path class="grain" d="M{ax:.1f} {ay:.1f}L{bx:.1f} {by:.1f}m-5 -3l5 3l-5 3"/>')
    x, y = at(((low[0] + high[0]) / 2, piece["grain_line_m"][0][1]))
    down = 14 if piece["grain_line_m"][0][1] > (low[1] + high[1]) / 2 else -6
    lines.append(f'<text x="{x:.1f}" y="{y + down:.1f}">{piece["name"]}</text>')
    return "\n".join(lines)


def pieces_svg(pieces, box):
    left, top, width, height = box
    rows = math.ceil(len(pieces) / ROW)
    cell = (width / ROW, height / rows)
    size = [max(max(p[k] for p in piece["cut_line_m"]) - min(p[k] for p in piece["cut_line_m"]) for piece in pieces)
            for k in (0, 1)]
    scale = min((cell[0] - 16) / size[0], (cell[1] - 6) / size[1])
    return "\n".join(piece_svg(piece, (left + (i % ROW) * cell[0], top + (rows - 1 - i // ROW) * cell[1], *cell, scale))
                     for i, piece in enumerate(pieces))


def main(demo, target):
    vertices, tiles = read_tiles(demo / "envelope.obj")
    pieces = json.loads((demo / "cut-plan/cut/pieces.json").read_text())["pieces"]
    gore = [piece for piece in pieces if piece["name"].startswith("G01")]
    target.write_text(f"""<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {WIDTH} {HEIGHT}" role="img"
aria-label="A hot-air balloon envelope of {len(tiles)} tiles, and the {len(gore)} flat pieces of one of its gores">
<style>
path {{ stroke: #1f2933; stroke-width: 0.5; stroke-linejoin: round; }}
.cut {{ fill-opacity: 0.85; stroke-width: 0.8; }}
.sew {{ fill: none; stroke-dasharray: 3 2; stroke-width: 0.6; }}
.notch {{ stroke-width: 0.9; }}
.grain {{ fill: none; stroke-width: 0.9; }}
text {{ font: 9px sans-serif; text-anchor: middle; fill: #1f2933; }}
</style>
<rect width="{WIDTH}" height="{HEIGHT}" fill="#fff"/>
{envelope_svg(vertices, tiles, (20, 20, 560, HEIGHT - 40))}
{pieces_svg(gore, (620, 14, 560, HEIGHT - 28))}
</svg>
""")


if __name__ == "__main__":
    main(pathlib.Path(sys.argv[1]), pathlib.Path(sys.argv[2]))
