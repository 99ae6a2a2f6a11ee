// Writes a Rhino file with surfaces whose stored mesh is missing or wrong: node nurbs.mjs KIND OUT.3dm VERSION
import fs from 'node:fs';
import { createRequire } from 'node:module';

const rhino = await createRequire(new URL('../../apps/rhino/package.json', import.meta.url))('rhino3dm')();
const [kind, out, version] = process.argv.slice(2);
const file = new rhino.File3dm();
file.settings().modelUnitSystem = rhino.UnitSystem.Millimeters;
for (const name of ['skin', 'crown']) {
    const layer = new rhino.Layer();
    layer.name = name;
    file.layers().add(layer);
}

function called(name, layer, text = {}) {
    const attributes = new rhino.ObjectAttributes();
    attributes.name = name;
    attributes.layerIndex = layer;
    for (const [key, value] of Object.entries(text)) attributes.setUserString(key, value);
    return attributes;
}

const sheet = (x) => rhino.NurbsSurface.createRuledSurface(new rhino.LineCurve([x, 0, 0], [x + 1000, 0, 0]),
                                                           new rhino.LineCurve([x, 1000, 0], [x + 1000, 1000, 0]));
const cylinder = () => new rhino.Cylinder(new rhino.Circle([5000, 0, 0], 500), 2000);

function stored(brep, scale) {  // of a sheet at x = 0
    const mesh = new rhino.Mesh();
    for (const [x, y] of [[0, 0], [1, 0], [1, 1], [0, 1]]) mesh.vertices().add(x * 1000 * scale, y * 1000, 0);
    mesh.faces().addQuadFace(0, 1, 2, 3);
    brep.faces().get(0).setMesh(mesh, rhino.MeshType.Render);
    return brep;
}

if (kind === 'all') {
    file.objects().add(rhino.Brep.createFromBoundingBox(new rhino.BoundingBox([0, 0, 0], [1000, 1000, 1000])),
                       called('box', 0));
    file.objects().add(rhino.Brep.createFromCylinder(cylinder(), true, true), called('drum', 0, { tile: 'DRUM', k: 'v' }));
    file.objects().add(rhino.Extrusion.create(
        new rhino.PolylineCurve([[0, 5000, 0], [1000, 5000, 0]]), 700, false), called('strip', 0));
    file.objects().add(sheet(20000), called('', 1));
} else if (kind === 'stored') {
    file.objects().add(stored(rhino.Brep.createFromSurface(sheet(0)), 1), called('true', 0));
    file.objects().add(stored(rhino.Brep.createFromSurface(sheet(0)), 1.2), called('false', 0));
} else {  // a block placed unchanged, and mirrored
    const part = file.instanceDefinitions().add('gore', '', '', '', [0, 0, 0], [rhino.Brep.createFromSurface(sheet(0))],
                                                [called('', 0)]);
    const id = file.instanceDefinitions().get(part).id;
    for (const [name, sign] of [['left', -1], ['right', 1]]) {
        const place = new rhino.Transform(1);
        place.m00 = sign;
        file.objects().addInstanceObject(new rhino.InstanceReference(id, place), called(name, 0));
    }
}
const options = new rhino.File3dmWriteOptions();
options.version = Number(version);
fs.writeFileSync(out, Buffer.from(file.toByteArrayOptions(options)));
