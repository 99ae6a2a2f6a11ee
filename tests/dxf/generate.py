"""Writes drawings made at random, from a fixed seed, and what ezdxf finds of each on every layer.

generate.py FOLDER COUNT: FOLDER/N.dxf, and on stdout a line a drawing and layer:
N LAYER length x0 y0 x1 y1 z0 z1
"""
import random
import sys
from math import cos, dist, pi, sin

import ezdxf

LAYERS = ["CUT", "Sew", "marks"]


def extrusion(rng):
    kind = rng.random()
    if kind < 0.6:
        return (0, 0, 1)
    if kind < 0.8:
        return (0, 0, -1)
    return (rng.uniform(-1, 1), rng.uniform(-1, 1), rng.uniform(0.1, 1))


def point(rng, size=100):
    return (rng.uniform(-size, size), rng.uniform(-size, size))


def add_line(space, rng, attribs):
    space.add_line((*point(rng), 0), (*point(rng), rng.choice([0, 20])), attribs)


def add_light_polyline(space, rng, attribs):
    corners = [(*point(rng), rng.choice([0, 0, rng.uniform(-2, 2)])) for _ in range(rng.randint(2, 7))]
    attribs["extrusion"] = extrusion(rng)
    attribs["elevation"] = rng.choice([0, 12])
    space.add_lwpolyline(corners, format="xyb", close=rng.random() < 0.5, dxfattribs=attribs)


def add_old_polyline(space, rng, attribs):
    corners = [(*point(rng), rng.choice([0, rng.uniform(-1, 1)])) for _ in range(rng.randint(2, 6))]
    attribs["extrusion"] = extrusion(rng)
    space.add_polyline2d(corners, format="xyb", close=rng.random() < 0.5, dxfattribs=attribs)


def add_polyline_in_space(space, rng, attribs):
    corners = [(*point(rng), rng.uniform(0, 50)) for _ in range(rng.randint(2, 6))]
    space.add_polyline3d(corners, close=rng.random() < 0.5, dxfattribs=attribs)


def add_circle(space, rng, attribs):
    attribs["extrusion"] = extrusion(rng)
    space.add_circle((*point(rng), rng.choice([0, 7])), rng.uniform(1, 100), attribs)


def add_arc(space, rng, attribs):
    attribs["extrusion"] = extrusion(rng)
    space.add_arc((*point(rng), 0), rng.uniform(1, 100), rng.uniform(-400, 400), rng.uniform(-400, 400), dxfattribs=attribs)


def add_ellipse(space, rng, attribs):
    turn, size = rng.uniform(0, 2 * pi), rng.uniform(5, 300)
    start, end = rng.choice([(0, 2 * pi), (rng.uniform(0, 6), rng.uniform(0, 6))])
    space.add_ellipse((*point(rng), 0), (size * cos(turn), size * sin(turn), 0), rng.uniform(0.1, 1), start, end,
                      dxfattribs=attribs)


def add_spline(space, rng, attribs):
    degree = rng.randint(2, 5)
    controls = [(*point(rng), rng.choice([0, rng.uniform(0, 9)])) for _ in range(rng.randint(degree + 1, degree + 6))]
    weights = [rng.uniform(0.3, 3) for _ in controls]
    spline = space.add_spline(dxfattribs=attribs)
    rng.choice([
        lambda: spline.set_open_uniform(controls, degree),
        lambda: spline.set_closed(controls, degree),
        lambda: spline.set_open_rational(controls, weights, degree),
        lambda: spline.set_closed_rational(controls, weights, degree),
    ])()


SHAPES = [add_line, add_light_polyline, add_old_polyline, add_polyline_in_space, add_circle, add_arc, add_ellipse, add_spline]


def fill(space, rng, count, layers):
    for _ in range(count):
        attribs = {"layer": rng.choice(layers)}
        if rng.random() < 0.1:
            attribs["invisible"] = 1
        rng.choice(SHAPES)(space, rng, attribs)


def insert(space, rng, name, layers, may_be_array=True):
    # A scale that is not the same both ways, or a tilted plane, makes no circle of a circle.
    size = rng.uniform(0.3, 2)
    attribs = {
        "layer": rng.choice(layers),
        "rotation": rng.uniform(0, 360),
        "xscale": size * rng.choice([1, -1]),
        "yscale": size * rng.choice([1, -1]),
        "zscale": size,
        "extrusion": rng.choice([(0, 0, 1), (0, 0, -1)]),
    }
    # ezdxf does not scale the steps of an array with the block around it.
    if may_be_array and rng.random() < 0.3:
        attribs.update(row_count=2, column_count=3, row_spacing=300, column_spacing=-200)
    # Names of blocks have no case.
    space.add_blockref(rng.choice([str.upper, str.lower])(name), (*point(rng), 0), attribs)


def make(rng):
    document = ezdxf.new(rng.choice(["R2000", "R2010", "R2018"]), setup=False)
    for layer in LAYERS:
        document.layers.add(layer)
    inner = document.blocks.new("Inner_piece", base_point=(*point(rng, 9), 0))
    fill(inner, rng, 2, ["0", "CUT"])
    outer = document.blocks.new("Outer", base_point=(3, 4, 0))
    fill(outer, rng, 1, ["0", "Sew"])
    insert(outer, rng, "Inner_piece", ["0", "CUT"], may_be_array=False)
    space = document.modelspace()
    fill(space, rng, 4, LAYERS)
    insert(space, rng, "Inner_piece", LAYERS)
    insert(space, rng, "Outer", LAYERS)
    return document


def entities(space, layer="0"):
    """What is drawn, with its layer: what a block has on layer 0 is on the layer of its INSERT."""
    for entity in space:
        own = entity.dxf.layer if entity.dxf.layer != "0" else layer
        if entity.dxf.get("invisible", 0):
            continue
        if entity.dxftype() == "INSERT":
            for one in entity.multi_insert():
                yield from entities(one.virtual_entities(), own)
        else:
            yield own, entity


def lines(entity):
    """The points of an entity, of each of its parts."""
    kind = entity.dxftype()
    if kind == "LINE":
        yield [entity.dxf.start, entity.dxf.end]
    elif kind in ("CIRCLE", "ARC", "ELLIPSE", "SPLINE"):
        yield list(entity.flattening(0.02))
    elif kind == "POLYLINE" and entity.is_3d_polyline:
        points = [vertex.dxf.location for vertex in entity.vertices]
        yield points + points[:1] if entity.is_closed else points
    else:
        for part in entity.virtual_entities():
            yield from lines(part)


folder, count = sys.argv[1], int(sys.argv[2])
for number in range(count):
    document = make(random.Random(number))
    document.saveas(f"{folder}/{number}.dxf")
    found = {}
    for layer, entity in entities(ezdxf.readfile(f"{folder}/{number}.dxf").modelspace()):
        sums = found.setdefault(layer.upper(), [0, [], [], []])
        for points in lines(entity):
            sums[0] += sum(dist((p[0], p[1]), (q[0], q[1])) for p, q in zip(points, points[1:]))
            for axis in range(3):
                sums[1 + axis] += [min(p[axis] for p in points), max(p[axis] for p in points)]
    for layer, (length, x, y, z) in sorted(found.items()):
        print(number, layer, length, min(x), min(y), max(x), max(y), min(z), max(z))
