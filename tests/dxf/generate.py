"""Writes random drawings, from a fixed seed, and what ezdxf finds in each.

generate.py FOLDER COUNT: writes FOLDER/N.dxf, and on stdout what is visible in each, in file order:
N unit METRES
N line LAYER CLOSED LENGTH x0 y0 z0 x1 y1 z1 and three numbers for each of 24 evenly spaced points
N text LAYER x y HEIGHT TURN
"""
import random
import re
import sys
from math import atan2, cos, degrees, dist, hypot, pi, sin

import ezdxf
from ezdxf.math import Matrix44, Vec3

SAMPLES = 24
LAYERS = ["CUT", "Sew", "marks", "Nähte", "OFF", "Ice"]
UNITS = {0: 0, 1: 0.0254, 2: 0.3048, 4: 0.001, 5: 0.01, 6: 1}
# Letters of a code page, for names.
PAGES = {"cp1252": "Ärmel", "cp1250": "Čapka", "cp1251": "Рукав", "cp1253": "Μανίκι"}


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
    attribs["elevation"] = (0, 0, rng.choice([0, 12]))
    space.add_polyline2d(corners, format="xyb", close=rng.random() < 0.5, dxfattribs=attribs)


def add_polyline_in_space(space, rng, attribs):
    corners = [(*point(rng), rng.uniform(0, 50)) for _ in range(rng.randint(2, 6))]
    space.add_polyline3d(corners, close=rng.random() < 0.5, dxfattribs=attribs)


def add_circle(space, rng, attribs):
    attribs["extrusion"] = extrusion(rng)
    space.add_circle((*point(rng), rng.choice([0, 7])), rng.uniform(1, 100), attribs)


def add_arc(space, rng, attribs):
    attribs["extrusion"] = extrusion(rng)
    start, end = rng.uniform(-400, 400), rng.uniform(-400, 400)
    space.add_arc((*point(rng), 0), rng.uniform(1, 100), start, end, dxfattribs=attribs)


def add_ellipse(space, rng, attribs):
    turn, size = rng.uniform(0, 2 * pi), rng.uniform(5, 300)
    start, end = rng.choice([(0, 2 * pi), (rng.uniform(0, 6), rng.uniform(0, 6))])
    space.add_ellipse((*point(rng), 0), (size * cos(turn), size * sin(turn), 0), rng.uniform(0.1, 1), start, end,
                      dxfattribs=attribs)


def add_spline(space, rng, attribs):
    degree = rng.randint(1, 5)
    controls = [(*point(rng), rng.choice([0, rng.uniform(0, 9)])) for _ in range(rng.randint(degree + 1, degree + 6))]
    weights = [rng.uniform(0.3, 3) for _ in controls]
    spline = space.add_spline(dxfattribs=attribs)
    rng.choice([
        lambda: spline.set_open_uniform(controls, degree),
        lambda: spline.set_closed(controls, degree),
        lambda: spline.set_open_rational(controls, weights, degree),
        lambda: spline.set_closed_rational(controls, weights, degree),
    ])()


def add_spline_through_points(space, rng, attribs):
    spline = space.add_spline([(*point(rng), rng.choice([0, 5])) for _ in range(rng.randint(3, 8))], dxfattribs=attribs)
    if rng.random() < 0.5:
        spline.dxf.start_tangent, spline.dxf.end_tangent = (1, 2, 0), (*point(rng), 0)


def add_spline_without_knots(space, rng, attribs):
    spline = space.add_spline(dxfattribs=attribs)
    spline.dxf.degree = rng.randint(1, 4)
    spline.control_points = [(*point(rng), 0) for _ in range(spline.dxf.degree + rng.randint(1, 4))]


def add_text(space, rng, attribs):
    attribs.update(height=rng.uniform(1, 9), rotation=rng.uniform(-179, 179))
    attribs["extrusion"] = rng.choice([(0, 0, 1), (0, 0, -1)])
    text = space.add_text("a", dxfattribs=attribs)
    align = rng.choice(["LEFT", "MIDDLE_CENTER", "TOP_RIGHT", "FIT", "ALIGNED"])
    text.set_pos(point(rng), point(rng) if align in ("FIT", "ALIGNED") else None, align=align)


SHAPES = [add_line, add_light_polyline, add_old_polyline, add_polyline_in_space, add_circle, add_arc, add_ellipse,
          add_spline, add_spline_through_points, add_spline_without_knots, add_text]


def fill(space, rng, count, layers):
    for _ in range(count):
        attribs = {"layer": rng.choice(layers)}
        if rng.random() < 0.1:
            attribs["invisible"] = 1
        rng.choice(SHAPES)(space, rng, attribs)


def insert(space, rng, name, layers):
    size = rng.uniform(0.3, 2)
    scales = rng.choice([(size, size, size), (size, rng.uniform(0.3, 2), rng.uniform(0.3, 2))])
    attribs = {
        # Contents of a block on a frozen layer are invisible; ezdxf leaves this to its caller.
        "layer": rng.choice([layer for layer in layers if layer != "Ice"]),
        "rotation": rng.uniform(0, 360),
        "xscale": scales[0] * rng.choice([1, -1]),
        "yscale": scales[1] * rng.choice([1, -1]),
        "zscale": scales[2],
        "extrusion": extrusion(rng),
    }
    if rng.random() < 0.3:
        attribs.update(row_count=2, column_count=3)
        attribs.update(row_spacing=rng.choice([300, -90, 0]), column_spacing=rng.choice([-200, 0]))
    if rng.random() < 0.1:
        attribs["invisible"] = 1
    # Names of blocks ignore case.
    space.add_blockref(rng.choice([str.upper, str.lower])(name), (*point(rng), rng.choice([0, 9])), attribs)


def make(rng):
    document = ezdxf.new(rng.choice(["R2000", "R2000", "R2010", "R2018"]), setup=False)
    document.encoding, word = rng.choice(list(PAGES.items()))
    document.units = rng.choice(list(UNITS))
    layers = LAYERS if document.encoding == "cp1252" or document.dxfversion > "AC1018" else LAYERS[:3] + LAYERS[4:]
    for layer in layers:
        document.layers.add(layer)
    document.layers.get("OFF").off()
    document.layers.get("ICE").freeze()
    word = rng.choice(["Inner_piece", word])
    inner = document.blocks.new(word, base_point=(*point(rng, 9), 0))
    fill(inner, rng, 2, ["0", "CUT", "OFF"])
    outer = document.blocks.new("Outer", base_point=(3, 4, 0))
    fill(outer, rng, 1, ["0", "Sew"])
    insert(outer, rng, word, ["0", "CUT"])
    space = document.modelspace()
    fill(space, rng, 4, layers)
    insert(space, rng, word, layers)
    insert(space, rng, "Outer", layers)
    return document


def without(text, section):
    return re.sub(r"  0\nSECTION\n  2\n" + section + r"\n.*?\n  0\nENDSEC\n", "", text, flags=re.S)


def save(document, file, rng):
    """Some files lack optional sections and have comments between groups."""
    document.saveas(file)
    if document.dxfversion != "AC1015" or rng.random() < 0.5:
        return
    with open(file, encoding=document.encoding) as stream:
        text = stream.read()
    for section in ("CLASSES", "OBJECTS"):
        text = without(text, section)
    if rng.random() < 0.3:
        text = without(text, "TABLES")
    text = text.replace("ENTITIES\n", "ENTITIES\n999\nwhat is drawn\n")
    text = text.replace("\n  0\nENDSEC", "\n999\nend\n  0\nENDSEC")
    with open(file, "w", encoding=document.encoding) as stream:
        stream.write(text)


def is_seen(entity, layer, document):
    if entity.dxf.get("invisible", 0):
        return False
    known = document.layers.get(layer) if document.layers.has_entry(layer) else None
    # A block on a layer that is off still shows its entities on other layers.
    return known is None or entity.dxftype() == "INSERT" or not (known.is_off() or known.is_frozen())


def entities(space, document, motion=Matrix44(), layer="0"):
    """Visible entities with layer and motion; those of a block on layer 0 take the layer of their INSERT."""
    for entity in space:
        own = entity.dxf.layer if entity.dxf.layer != "0" else layer
        if not is_seen(entity, own, document):
            continue
        if entity.dxftype() == "INSERT":
            for one in entity.multi_insert():
                yield from entities(one.block(), document, one.matrix44() * motion, own)
        else:
            yield own, entity, motion


def first_corner(entity):
    if entity.dxftype() == "LWPOLYLINE":
        return Vec3(entity[0][0], entity[0][1], entity.dxf.elevation)
    return entity.vertices[0].dxf.location.replace(z=entity.dxf.get("elevation", Vec3()).z)


def line(entity, error):
    """The points of an entity."""
    kind = entity.dxftype()
    if kind == "LINE":
        return [entity.dxf.start, entity.dxf.end]
    if kind == "SPLINE":
        # It tests only the middle of a chord, and misses bends beside it if chords are few.
        return list(entity.flattening(error, segments=32))
    if kind in ("CIRCLE", "ARC", "ELLIPSE"):
        return list(entity.flattening(error))
    if kind == "POLYLINE" and entity.is_3d_polyline:
        points = [vertex.dxf.location for vertex in entity.vertices]
        return points + points[:1] if entity.is_closed else points
    points = []
    for part in entity.virtual_entities():
        arc = line(part, error)
        # Arcs are reversed to run to the left, whatever the direction of the polyline.
        if points and arc[0].distance(points[-1]) > arc[-1].distance(points[-1]):
            arc.reverse()
        elif not points:
            start = entity.ocs().to_wcs(first_corner(entity))
            if arc[0].distance(start) > arc[-1].distance(start):
                arc.reverse()
        points += arc[1:] if points else arc
    return points


def resampled(points):
    lengths = [0]
    for p, q in zip(points, points[1:]):
        lengths.append(lengths[-1] + dist(p, q))
    found, at = [], 0
    for i in range(SAMPLES):
        wanted = lengths[-1] * i / (SAMPLES - 1)
        while at + 2 < len(points) and lengths[at + 1] < wanted:
            at += 1
        step = lengths[at + 1] - lengths[at]
        found.append(points[at].lerp(points[at + 1], (wanted - lengths[at]) / step if step > 0 else 0))
    return found


def show_line(number, layer, entity, motion):
    size = max(motion.transform_direction(axis).magnitude for axis in (Vec3(1, 0, 0), Vec3(0, 1, 0), Vec3(0, 0, 1)))
    points = [Vec3(p) for p in motion.transform_vertices(line(entity, 0.004 / size))]
    flat = [Vec3(p.x, p.y) for p in points]
    length = sum(dist(p, q) for p, q in zip(flat, flat[1:]))
    box = [bound(p[axis] for p in points) for bound in (min, max) for axis in range(3)]
    numbers = [length, *box, *(value for p in resampled(points) for value in p)]
    is_closed = points[0].distance(points[-1]) < 1e-6 * size
    print(number, "line", layer.upper(), int(is_closed), *(f"{value:.6f}" for value in numbers))


def show_text(number, layer, text, motion):
    _, at, _ = text.get_placement()
    ocs = text.ocs()
    turn = text.dxf.rotation * pi / 180
    along = motion.transform_direction(ocs.to_wcs(Vec3(cos(turn), sin(turn))))
    up = motion.transform_direction(ocs.to_wcs(Vec3(-sin(turn), cos(turn))))
    place = motion.transform(ocs.to_wcs(at))
    height = text.dxf.height * hypot(up.x, up.y)
    print(number, "text", layer.upper(), place.x, place.y, height, degrees(atan2(along.y, along.x)))


folder, count = sys.argv[1], int(sys.argv[2])
for number in range(count):
    rng = random.Random(number)
    file = f"{folder}/{number}.dxf"
    save(make(rng), file, rng)
    document = ezdxf.readfile(file)
    print(number, "unit", UNITS[document.units])
    for layer, entity, motion in entities(document.modelspace(), document):
        (show_text if entity.dxftype() == "TEXT" else show_line)(number, layer, entity, motion)
ezdxf.new().saveas(f"{folder}/binary.dxf", fmt="bin")
