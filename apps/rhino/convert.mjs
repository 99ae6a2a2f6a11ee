// Extracts the surfaces of a Rhino file with openNURBS: `node convert.mjs FILE.3dm OUTPUT`. OUTPUT is a converted model
// (see src/ripstop/io/cad/converted.h): a line of JSON, then the meshes. An object made of NURBS has them under `brep`,
// besides the meshes of its faces that Rhino stored.
import fs from 'node:fs';
import rhino3dm from 'rhino3dm';

const UNITS = {2: ['mm', 0.001], 3: ['cm', 0.01], 4: ['m', 1], 8: ['in', 0.0254], 9: ['ft', 0.3048],
               1: ['micron', 1e-6], 5: ['km', 1000], 6: ['microinch', 2.54e-8], 7: ['mil', 2.54e-5], 10: ['mile', 1609.344],
               13: ['nm', 1e-9], 14: ['dm', 0.1], 15: ['dam', 10], 16: ['hm', 100], 19: ['yd', 0.9144]};
const SUBD_STEPS = 3;  // each halves the edges: what is left is 1/64 of the control net's sagitta

class Refused extends Error {}

function list(items) {
  return Array.from({length: items.count}, (_, i) => items.get(i));
}

const identity = [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1];

/** Row-major 4 x 4. */
function times(a, b) {
  return identity.map((_, n) => {
    const i = n >> 2, j = n & 3;
    return a[4 * i] * b[j] + a[4 * i + 1] * b[4 + j] + a[4 * i + 2] * b[8 + j] + a[4 * i + 3] * b[12 + j];
  });
}

function rowsOf(transform) {
  return identity.map((_, n) => transform[`m${n >> 2}${n & 3}`]);
}

function moved(m, p) {
  const [x, y, z] = p;
  return [0, 1, 2].map((i) => m[4 * i] * x + m[4 * i + 1] * y + m[4 * i + 2] * z + m[4 * i + 3]);
}

function mirrors(m) {
  return m[0] * (m[5] * m[10] - m[6] * m[9]) - m[1] * (m[4] * m[10] - m[6] * m[8]) + m[2] * (m[4] * m[9] - m[5] * m[8]) < 0;
}

/** A mesh's vertices and triangles, made of quads by their first diagonal. */
function meshOf(mesh, place) {
  const stored = mesh.vertices();
  const vertices = Array.from({length: stored.count}, (_, i) => moved(place, stored.point3dAt(i)));
  const triangles = [];
  const turned = mirrors(place);
  for (const [a, b, c, d] of list(mesh.faces())) {
    triangles.push(turned ? [a, c, b] : [a, b, c]);
    if (c !== d) triangles.push(turned ? [a, d, c] : [a, c, d]);
  }
  return welded(vertices, triangles);
}

/** Vertices in the same place made one: Rhino doubles them along creases. */
function welded(vertices, triangles) {
  const at = new Map();
  const number = vertices.map((p) => {
    const key = p.join();
    if (!at.has(key)) at.set(key, at.size);
    return at.get(key);
  });
  const points = [...at.keys()].map((key) => key.split(',').map(Number));
  const kept = triangles.map((t) => t.map((v) => number[v])).filter(([a, b, c]) => a !== b && b !== c && c !== a);
  return {points, triangles: kept};
}

function weightedPoint(p, place) {
  const w = p[3];
  return [...moved(place, [p[0] / w, p[1] / w, p[2] / w]), w];
}

function nurbsCurve(curve, place) {
  const nurbs = curve.toNurbsCurve();
  if (!nurbs) throw new Refused('one of its edges is no NURBS curve');
  const points = list(nurbs.points()).map((p) => weightedPoint(p, place));
  return {degree: nurbs.order - 1, knots: nurbs.knots().toList(), points};
}

function nurbsSurface(surface, place) {
  const nurbs = surface.toNurbsSurface();
  if (!nurbs) throw new Refused('one of its surfaces is no NURBS surface');
  const net = nurbs.points();
  const points = [];
  for (let i = 0; i < net.countU; ++i)
    for (let j = 0; j < net.countV; ++j) points.push(weightedPoint(net.get(i, j), place));
  return {degree_u: nurbs.orderU - 1, degree_v: nurbs.orderV - 1, count_u: net.countU, count_v: net.countV,
          knots_u: nurbs.knotsU().toList(), knots_v: nurbs.knotsV().toList(), points};
}

/** Where each edge starts and ends, by the trims that run along it. */
function endsOf(faces, count) {
  const ends = Array.from({length: count}, () => null);
  for (const face of faces)
    for (const loop of list(face.loops))
      for (const trim of list(loop.trims)) {
        const e = trim.edgeIndex;
        if (e < 0 || ends[e]) continue;
        ends[e] = trim.isReversed ? [trim.endVertexIndex, trim.startVertexIndex]
                                  : [trim.startVertexIndex, trim.endVertexIndex];
      }
  return ends;
}

function brepOf(brep, place) {
  const faces = list(brep.faces());
  const edges = list(brep.edges());
  const ends = endsOf(faces, edges.length);
  const turned = mirrors(place);
  return {
    edges: edges.map((edge, i) => ({...nurbsCurve(edge, place), from: ends[i]?.[0] ?? -1, to: ends[i]?.[1] ?? -1})),
    faces: faces.map((face) => ({
      surface: nurbsSurface(face.underlyingSurface(), place),
      reversed: face.orientationIsReversed !== turned,
      loops: list(face.loops).map((loop) => list(loop.trims).map((t) => ({edge: t.edgeIndex, reversed: t.isReversed}))),
    })),
  };
}

/** Estimates the distance of a stored mesh from its surface: h t / 8, with the turn t between triangles of height h. */
function chordError({points, triangles}) {
  const minus = (a, b) => a.map((x, i) => x - b[i]);
  const cross = (a, b) => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
  const normals = triangles.map(([a, b, c]) => {
    const n = cross(minus(points[b], points[a]), minus(points[c], points[a]));
    return n.map((x) => x / (Math.hypot(...n) || 1));
  });
  const sides = new Map();
  let worst = 0;
  triangles.forEach((corners, t) => corners.forEach((a, k) => {
    const b = corners[(k + 1) % 3];
    const key = a < b ? `${a},${b}` : `${b},${a}`;
    const other = sides.get(key);
    sides.set(key, t);
    if (other === undefined) return;
    const turn = Math.acos(Math.min(1, normals[t].reduce((sum, x, i) => sum + x * normals[other][i], 0)));
    const apex = corners[(k + 2) % 3];
    worst = Math.max(worst, Math.hypot(...minus(points[apex], points[a])) * turn / 8);
  }));
  return worst;
}

class Converter {
  constructor(rhino, bytes) {
    this.rhino = rhino;
    this.file = rhino.File3dm.fromByteArray(bytes);
    if (!this.file) throw new Refused('no Rhino file that openNURBS can read; open it in Rhino and save it again');
    this.layers = list(this.file.layers());
    this.definitions = new Map(list(this.file.instanceDefinitions()).map((d) => [d.id, d]));
    this.result = {ripstop_converted: 1, layers: this.layers.map((l) => l.fullPath), remarks: [], objects: [], curves: [],
                   unread: []};
    this.arrays = [];
    this.subdivided = 0;
    const unit = UNITS[this.file.settings().modelUnitSystem?.value ?? 0];
    if (unit) this.result.unit = {name: unit[0], metres: unit[1]};
    const objects = list(this.file.objects());
    this.byId = new Map(objects.map((o) => [o.attributes().id, o]));
    this.all = this.file.archiveVersion === 1;  // of newer files ripstop reads meshes and curves itself
    for (const object of objects)
      if (!object.attributes().isInstanceDefinitionObject) this.add(object, identity, {}, 0);
    if (this.subdivided > 0)
      this.result.remarks.push(`${this.subdivided} SubD were divided ${SUBD_STEPS} times towards their limit`);
  }

  attributesOf(attributes, geometry) {
    const result = {};
    for (const [key, value] of geometry.getUserStrings() ?? []) result[key] = value;
    for (const [key, value] of attributes.getUserStrings() ?? []) result[key] = value;
    const layer = this.layers[attributes.layerIndex];
    if (layer) result.layer = layer.fullPath;
    const groups = attributes.groupCount > 0 ? attributes.getGroupList() : [];
    const group = groups?.length ? this.file.groups().findIndex(groups[0]) : null;
    if (group?.name) result.group = group.name;
    return result;
  }

  isSeen(attributes) {
    for (let layer = this.layers[attributes.layerIndex]; layer;
         layer = this.layers.find((other) => other.id === layer.parentLayerId))
      if (!layer.visible) return false;
    return attributes.mode !== this.rhino.ObjectMode.Hidden && attributes.activeSpace !== this.rhino.ActiveSpace.PageSpace;
  }

  isWanted(geometry) {
    const {InstanceReference, Brep, Surface, SubD} = this.rhino;
    return this.all || [InstanceReference, Brep, Surface, SubD].some((kind) => geometry instanceof kind);
  }

  add(object, place, inherited, depth) {
    const attributes = object.attributes(), geometry = object.geometry();
    if (!this.isSeen(attributes) || !this.isWanted(geometry)) return;
    const type = this.rhino.ObjectType ? Object.keys(this.rhino.ObjectType).find(
      (key) => this.rhino.ObjectType[key] === geometry.objectType) ?? 'Object' : 'Object';
    const entry = {name: attributes.getUserString('tile') || attributes.name || inherited.name || '', type,
                   attributes: {...inherited.attributes, ...this.attributesOf(attributes, geometry)}};
    try {
      if (geometry instanceof this.rhino.InstanceReference) this.addBlock(geometry, place, entry, depth);
      else this.addGeometry(geometry, place, entry);
    } catch (error) {
      if (!(error instanceof Refused)) throw error;
      this.leaveOut(entry, error.message);
    }
  }

  leaveOut(entry, reason) {
    this.result.unread.push({...entry, reason});
  }

  addBlock(reference, place, entry, depth) {
    const definition = this.definitions.get(reference.parentIdefId);
    if (!definition) throw new Refused('its block is not in the file; embed it, or explode it');
    if (depth > 32) throw new Refused('its blocks are nested more than 32 deep; explode them');
    const inner = times(place, rowsOf(reference.xform));
    for (const id of definition.getObjectIds()) {
      const object = this.byId.get(id);
      if (object) this.add(object, inner, entry, depth + 1);
      else this.leaveOut(entry, 'a part of its block is missing; explode the block');
    }
  }

  addGeometry(geometry, place, entry) {
    const rhino = this.rhino;
    if (geometry instanceof rhino.Mesh) return this.addMeshes(entry, [meshOf(geometry, place)]);
    if (geometry instanceof rhino.SubD) return this.addSubD(geometry, place, entry);
    if (geometry instanceof rhino.Extrusion) return this.addExtrusion(geometry, place, entry);
    if (geometry instanceof rhino.Brep) return this.addBrep(geometry, place, entry);
    if (geometry instanceof rhino.Surface) {
      const brep = rhino.Brep.createFromSurface(geometry);
      if (!brep) throw new Refused('openNURBS makes no polysurface of it; mesh it in Rhino (Mesh) and save again');
      return this.addBrep(brep, place, entry);
    }
    if (geometry instanceof rhino.Curve) return this.addCurve(geometry, place, entry);
    throw new Refused('it is no surface');
  }

  addCurve(curve, place, entry) {
    const count = curve instanceof this.rhino.LineCurve ? 1 : 64;
    const [from, to] = curve.domain;
    const points = Array.from({length: count + 1}, (_, i) => moved(place, curve.pointAt(from + (to - from) * i / count)));
    this.result.curves.push({name: entry.name, attributes: entry.attributes, points});
  }

  addBrep(brep, place, entry) {
    const stored = list(brep.faces()).map((face) => {
      const mesh = face.getMesh(this.rhino.MeshType.Any);
      return mesh ? meshOf(mesh, place) : null;
    });
    this.addMeshes(entry, stored, brepOf(brep, place));
  }

  /** Rhino stores one mesh of all its faces. */
  addExtrusion(extrusion, place, entry) {
    const brep = extrusion.toBrep(true), mesh = extrusion.getMesh(this.rhino.MeshType.Any);
    if (!brep && !mesh) throw new Refused('openNURBS makes no polysurface of it; mesh it in Rhino (Mesh) and save again');
    const stored = mesh ? [meshOf(mesh, place)] : list(brep.faces()).map(() => null);
    this.addMeshes(entry, stored, brep ? brepOf(brep, place) : null);
  }

  addSubD(subd, place, entry) {
    for (let i = 0; i < SUBD_STEPS; ++i) subd.subdivide();
    const mesh = this.rhino.Mesh.createFromSubDControlNet(subd, false);
    if (!mesh) throw new Refused('openNURBS makes no mesh of it; mesh it in Rhino (Mesh) and save again');
    ++this.subdivided;
    this.addMeshes(entry, [meshOf(mesh, place)]);
  }

  addMeshes(entry, meshes, brep) {
    const faces = meshes.map((mesh) => {
      if (!mesh || mesh.triangles.length === 0) return {vertices: 0, triangles: 0};
      this.arrays.push(Buffer.from(Float64Array.from(mesh.points.flat()).buffer),
                       Buffer.from(Int32Array.from(mesh.triangles.flat()).buffer));
      return {vertices: mesh.points.length, triangles: mesh.triangles.length, chord_error: chordError(mesh)};
    });
    this.result.objects.push(brep ? {...entry, faces, brep} : {...entry, faces});
  }

  write(path) {
    fs.writeFileSync(path, Buffer.concat([Buffer.from(JSON.stringify(this.result) + '\n'), ...this.arrays]));
  }
}

try {
  const [input, output] = process.argv.slice(2);
  new Converter(await rhino3dm(), new Uint8Array(fs.readFileSync(input))).write(output);
} catch (error) {
  console.error(`rhino3dm: ${error instanceof Refused ? error.message : `${error}`.split('\n')[0]}`);
  process.exitCode = error instanceof Refused ? 3 : 4;
}
