"""Prints the contours that ezdxf finds, as parse.mjs does, after one line of its audit: release, unit, errors."""
import sys
from math import dist

import ezdxf

doc = ezdxf.readfile(sys.argv[1])


def contours(entities):
    found = []
    for line in entities:
        if line.dxftype() != "POLYLINE":
            continue
        points = [(v.dxf.location.x, v.dxf.location.y) for v in line.vertices]
        last = found[-1] if found else None
        goes_on = last and not last[3] and last[0] == line.dxf.layer and not line.is_closed
        if goes_on and dist(last[1][-1], points[0]) <= 0.001:
            last[1].extend(points[1:])
            last[2] += 1
        else:
            found.append([line.dxf.layer, points, 1, line.is_closed])
        last = found[-1]
        if not last[3] and len(last[1]) > 2 and dist(last[1][0], last[1][-1]) <= 0.001:
            last[1].pop()
            last[3] = True
    return found


def show(name, layer, points, parts, closed):
    pairs = list(zip(points, points[1:] + points[:1]))
    area = sum(p[0] * q[1] - p[1] * q[0] for p, q in pairs) / 2
    print(name, layer, repr(min(p[0] for p in points)), repr(min(p[1] for p in points)), repr(area),
          repr(sum(dist(p, q) for p, q in pairs)), parts, int(closed))


space = doc.modelspace()
lines = [("-", contour) for contour in contours(space)]
for insert in space.query("INSERT"):
    assert insert.dxf.insert == (0, 0, 0), insert.dxf.name
    list(insert.virtual_entities())  # as drawing needs it: every entity can be moved
    lines += [(insert.dxf.name, contour) for contour in contours(doc.blocks.get(insert.dxf.name))]
# The audit of ezdxf 0.18 takes the SEQEND of polylines in blocks for orphans and deletes them, so it comes last.
audit = doc.audit()
print(doc.dxfversion, doc.units, len(audit.errors))
for name, contour in lines:
    show(name, *contour)
