// Describes Rhino files with openNURBS (rhino3dm), and writes them: the independent side of the .3dm tests.
//
//   node rhino.mjs write SCENE.json OUT.3dm VERSION [lean]   VERSION 2 to 8; lean: geometry only
//   node rhino.mjs describe FILE.3dm                         JSON on stdout
import fs from 'node:fs';
import { createRequire } from 'node:module';
import { lean } from './lean.mjs';

const rhino3dm = createRequire(new URL('../../apps/rhino/package.json', import.meta.url))('rhino3dm');
const rhino = await rhino3dm();

const transform = (rows) => {
    const xform = new rhino.Transform(1);
    for (let r = 0; r < 4; ++r) for (let c = 0; c < 4; ++c) xform[`m${r}${c}`] = rows[4 * r + c];
    return xform;
};

const curves = {
    line: (o) => new rhino.LineCurve(o.points[0], o.points[1]),
    polyline: (o) => new rhino.PolylineCurve(o.points),
    arc: (o) => rhino.ArcCurve.createFromArc(rhino.Arc.createFromPoints(o.points[0], o.points[1], o.points[2])),
    nurbs: (o) => rhino.NurbsCurve.create(false, o.degree, o.points),
    rational: (o) => rhino.NurbsCurve.createFromArc(
        rhino.Arc.createFromPoints(o.points[0], o.points[1], o.points[2])),
    polycurve: (o) => {
        const curve = new rhino.PolyCurve();
        for (const part of o.parts) curve.appendCurve(curves[part.kind](part));
        return curve;
    },
};

const solids = {
    mesh: (o) => {
        const mesh = new rhino.Mesh();
        for (const p of o.vertices) o.single ? mesh.vertices().add(...p) : mesh.vertices().addPoint3d(...p);
        for (const f of o.faces) f.length === 4 ? mesh.faces().addQuadFace(...f) : mesh.faces().addTriFace(...f);
        return mesh;
    },
    sphere: (o) => new rhino.Sphere(o.centre, o.radius).toBrep(),
    extrusion: (o) => rhino.Extrusion.create(new rhino.PolylineCurve(o.points), o.height, false),
    surface: (o) => rhino.NurbsSurface.createRuledSurface(curves.line({ points: o.points.slice(0, 2) }),
                                                          curves.line({ points: o.points.slice(2) })),
    point: (o) => new rhino.Point(o.points[0]),
    dot: (o) => new rhino.TextDot(o.text ?? 'dot', o.points[0]),
    cloud: (o) => { const cloud = new rhino.PointCloud(); for (const p of o.points) cloud.add(p); return cloud; },
};

function write(scene, path, version, isLean) {
    const file = new rhino.File3dm();
    file.settings().modelUnitSystem = rhino.UnitSystem[scene.unit ?? 'Millimeters'];
    for (const given of scene.layers ?? []) {
        const layer = new rhino.Layer();
        layer.name = given.name;
        if (given.parent !== undefined) layer.parentLayerId = file.layers().get(given.parent).id;
        layer.visible = given.visible ?? true;
        file.layers().add(layer);
    }
    for (const name of scene.groups ?? []) {
        const group = new rhino.Group();
        group.name = name;
        file.groups().add(group);
    }
    const definitions = new Map();
    const geometry = (o) => {
        if (o.kind === 'block') return new rhino.InstanceReference(definitions.get(o.definition), transform(o.xform));
        const made = (curves[o.kind] ?? solids[o.kind])(o);
        for (const [key, value] of Object.entries(o.geometry_text ?? {})) made.setUserString(key, value);
        return made;
    };
    const attributes = (o) => {
        const made = new rhino.ObjectAttributes();
        if (o.name !== undefined) made.name = o.name;
        made.layerIndex = o.layer ?? 0;
        for (const group of o.groups ?? []) made.addToGroup(group);
        if (o.hidden) made.mode = rhino.ObjectMode.Hidden;
        if (o.hidden) made.visible = false;
        if (o.page) made.activeSpace = rhino.ActiveSpace.PageSpace;
        for (const [key, value] of Object.entries(o.text ?? {})) made.setUserString(key, value);
        return made;
    };
    for (const d of scene.definitions ?? []) {
        const index = file.instanceDefinitions().add(d.name, '', '', '', [0, 0, 0], d.objects.map(geometry),
                                                     d.objects.map(attributes));
        definitions.set(d.name, file.instanceDefinitions().get(index).id);
    }
    for (const o of scene.objects)
        if (o.kind === 'block') file.objects().addInstanceObject(geometry(o), attributes(o));
        else file.objects().add(geometry(o), attributes(o));
    const options = new rhino.File3dmWriteOptions();
    options.version = version;
    const bytes = Buffer.from(file.toByteArrayOptions(options));
    fs.writeFileSync(path, isLean ? lean(bytes) : bytes);
}

const nameOf = (table, value) => Object.entries(table).find(([, v]) => v === value || v?.value === value?.value)?.[0];

function described(object) {
    const { constructor: { name: type } } = object.geometry();
    const attributes = object.attributes(), geometry = object.geometry();
    const says = { type, name: attributes.name, layer: attributes.layerIndex,
                   mode: attributes.mode.value, visible: attributes.visible, groups: [], text: {} };
    if (attributes.groupCount > 0) says.groups = [...attributes.getGroupList()];
    for (const of of [geometry, attributes])
        if (of.userStringCount > 0) for (const [key, value] of of.getUserStrings()) says.text[key] = value;
    const box = geometry.getBoundingBox();
    if (box) says.box = [box.min, box.max];
    if (type === 'Mesh') {
        says.vertices = geometry.vertices().count;
        says.triangles = geometry.faces().count + geometry.faces().quadCount;
    }
    if (geometry instanceof rhino.Curve) {
        says.start = geometry.pointAtStart;
        says.end = geometry.pointAtEnd;
    }
    return says;
}

function describe(path) {
    const file = rhino.File3dm.fromByteArray(new Uint8Array(fs.readFileSync(path)));
    const says = { version: file.archiveVersion, unit: nameOf(rhino.UnitSystem, file.settings().modelUnitSystem),
                   layers: [], groups: [], objects: [] };
    for (let i = 0; i < file.layers().count; ++i) {
        const layer = file.layers().get(i);
        says.layers.push({ path: layer.fullPath, visible: layer.visible });
    }
    for (let i = 0; i < file.groups().count; ++i) says.groups.push(file.groups().get(i).name);
    for (let i = 0; i < file.objects().count; ++i) says.objects.push(described(file.objects().get(i)));
    process.stdout.write(JSON.stringify(says, null, 1) + '\n');
}

const [verb, input, output, version, option] = process.argv.slice(2);
if (verb === 'write') write(JSON.parse(fs.readFileSync(input)), output, Number(version), option === 'lean');
else if (verb === 'describe') describe(input);
else throw new Error(`no verb "${verb}", expected write or describe`);
