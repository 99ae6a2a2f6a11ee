// Writes a Rhino file for the guide, with openNURBS: the designed envelope as if drawn by hand, in millimetres,
// one layer per gore, with grain lines, and, if asked for, four mistakes.
import { execFileSync } from 'node:child_process';
import { existsSync, readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { fileURLToPath } from 'node:url';

const root = fileURLToPath(new URL('../..', import.meta.url));

export const canWriteRhino = () => existsSync(join(root, 'apps/rhino/node_modules/rhino3dm'));

// The objects of an OBJ file: name, vertices in its own unit, faces with indices from 0.
function readObjects(file) {
    const objects = [],
        vertices = [];
    for (const line of readFileSync(file, 'utf8').split('\n')) {
        const [key, ...rest] = line.split(/\s+/);
        if (key === 'o') objects.push({ name: rest[0], vertices: [], faces: [], at: new Map() });
        if (key === 'v') vertices.push(rest.slice(0, 3).map(Number));
        if (key !== 'f') continue;
        const { at, vertices: own, faces } = objects.at(-1);
        const local = (index) => {
            if (!at.has(index)) at.set(index, own.push(vertices[index - 1].map((x) => 1000 * x)) - 1);
            return at.get(index);
        };
        faces.push(rest.filter(Boolean).map((word) => local(parseInt(word))));
    }
    return objects;
}

// From the vertex in the middle of a tile, some way along its gore: a maker draws this to show the warp.
function grainLine(tile) {
    const mean = [0, 1, 2].map((k) => tile.vertices.reduce((sum, v) => sum + v[k], 0) / tile.vertices.length);
    const nearest = (point) =>
        tile.vertices.reduce((best, v) =>
            Math.hypot(...v.map((x, k) => x - point[k])) < Math.hypot(...best.map((x, k) => x - point[k])) ? v : best,
        );
    const from = nearest(mean);
    const inwards = 1 - 250 / Math.hypot(mean[0], mean[1]);
    return [from, nearest([from[0] * inwards, from[1] * inwards, from[2] + 100])];
}

function withMistakes(objects) {
    const tile = (name) => objects.find((object) => object.name === name);
    const again = { ...tile('G03P04') };
    for (const vertex of tile('G05P06').vertices) vertex[2] += 4;
    const over = tile('G07P05');
    over.faces = over.faces.map((face) => [...face].reverse());
    return [...objects.filter((object) => object.name !== 'G10P07'), again];
}

// Throws if openNURBS does not write it.
export function writeRhinoFile(obj, file, { mistakes }) {
    const tiles = mistakes ? withMistakes(readObjects(obj)) : readObjects(obj);
    const gores = [...new Set(tiles.map(({ name }) => name.slice(0, 3)))];
    const layers = [{ name: 'Envelope' }, ...gores.map((name) => ({ name, parent: 0 })), { name: 'GRAIN' }];
    const meshes = tiles.map(({ name, vertices, faces }) => ({
        kind: 'mesh',
        name,
        layer: 1 + gores.indexOf(name.slice(0, 3)),
        vertices,
        faces,
    }));
    const lines = tiles
        .filter(({ name }) => name.endsWith('P12'))
        .map((tile) => ({ kind: 'line', layer: layers.length - 1, points: grainLine(tile) }));
    const scene = `${file}.scene.json`;
    writeFileSync(scene, JSON.stringify({ unit: 'Millimeters', layers, objects: [...meshes, ...lines] }));
    execFileSync(process.execPath, [join(root, 'tests/rhino/rhino.mjs'), 'write', scene, file, '7'], {
        stdio: ['ignore', 'ignore', 'inherit'],
    });
}
