// The tiles in space as one shape, which both views draw and pick from.
import { sidePoints } from '../view/data.js';
import { clothPlaces, rimPlaces } from '../view/maps.js';
import { seamLine } from './lines.js';
import { makePicking } from './picking.js';

// The first view direction.
export const homeDirection = [0.55, 0.28, 1];

// Converts the input's axes to those of the screen: y up, seen from the front.
const turnOf = ({ isYUp }) => (isYUp ? (p) => p : ([x, y, z]) => [x, z, -y]);

function tileFrame(tile) {
    const middle = [0, 0, 0];
    const { space, triangles } = tile;
    for (let i = 0; i < space.length; ++i) middle[i % 3] += space[i] / (space.length / 3);
    const normal = [0, 0, 0];
    for (let t = 0; t < triangles.length; t += 3) {
        const [a, b, c] = [triangles[t] * 3, triangles[t + 1] * 3, triangles[t + 2] * 3];
        const e = [0, 1, 2].map((k) => space[b + k] - space[a + k]),
            f = [0, 1, 2].map((k) => space[c + k] - space[a + k]);
        normal[0] += e[1] * f[2] - e[2] * f[1];
        normal[1] += e[2] * f[0] - e[0] * f[2];
        normal[2] += e[0] * f[1] - e[1] * f[0];
    }
    const size = Math.hypot(...normal) || 1;
    let radius = 0;
    for (let i = 0; i < space.length; i += 3)
        radius = Math.max(radius, Math.hypot(space[i] - middle[0], space[i + 1] - middle[1], space[i + 2] - middle[2]));
    return { middle, normal: normal.map((value) => value / size), radius };
}

// For each boundary edge, the direction into the cloth, in the plane of its triangle.
function inwardOf(tile) {
    const { loop, space, triangles } = tile;
    const place = new Map(Array.from(loop, (vertex, i) => [vertex, i]));
    const inward = Array.from(loop, () => [0, 0, 0]);
    for (let t = 0; t < triangles.length; t += 3)
        for (let k = 0; k < 3; ++k) {
            const [a, b, c] = [triangles[t + k], triangles[t + ((k + 1) % 3)], triangles[t + ((k + 2) % 3)]];
            const i = place.get(a);
            if (i === undefined || loop[(i + 1) % loop.length] !== b) continue;
            const along = [0, 1, 2].map((j) => space[3 * b + j] - space[3 * a + j]);
            const across = [0, 1, 2].map((j) => space[3 * c + j] - space[3 * a + j]);
            const length = along.reduce((sum, value) => sum + value * value, 0) || 1e-12;
            const share = along.reduce((sum, value, j) => sum + value * across[j], 0) / length;
            const height = across.map((value, j) => value - share * along[j]);
            const size = Math.hypot(...height) || 1;
            inward[i] = height.map((value) => value / size);
        }
    return inward;
}

// A band along the inside of every boundary edge, for maps of edges: two triangles per edge.
function placeRim(tiles, { positions, ids }) {
    let at = 0;
    for (const tile of tiles) {
        const { loop, space, frame } = tile;
        const width = 0.07 * frame.radius;
        const inward = inwardOf(tile);
        const inner = Array.from(loop, (vertex, i) => {
            const before = inward[(i + loop.length - 1) % loop.length];
            const both = inward[i].map((value, k) => value + before[k]);
            const length = Math.hypot(...both) || 1;
            return both.map((value, k) => space[3 * vertex + k] + (width / length) * value);
        });
        for (let i = 0; i < loop.length; ++i) {
            const j = (i + 1) % loop.length;
            const a = space.subarray(3 * loop[i], 3 * loop[i] + 3),
                b = space.subarray(3 * loop[j], 3 * loop[j] + 3);
            for (const point of [a, b, inner[j], a, inner[j], inner[i]]) {
                positions.set(point, 3 * at);
                ids[Math.floor(at++ / 3)] = tile.index;
            }
        }
    }
}

// Everything that depends on the positions of the tiles' vertices.
function placeTiles(shape) {
    const { positions } = shape;
    let at = 0;
    for (const tile of shape.model.tiles) {
        tile.frame = tileFrame(tile);
        for (const vertex of tile.triangles)
            for (let k = 0; k < 3; ++k) positions[at++] = tile.space[3 * vertex + k];
    }
    placeRim(shape.model.tiles, shape.rim);
    shape.picking = null;
}

export const isSeenFromHome = ({ frame: { normal } }) =>
    normal.reduce((sum, value, k) => sum + value * homeDirection[k], 0) > 0;

// The place of a tile or a seam, the direction it faces, and its size.
export function placeOfChosen(model, tiles, seam) {
    if (!seam) return tiles[0].frame;
    const line = seamLine(model, seam);
    const ends = [line.slice(0, 3), line.slice(-3)];
    const normal = [0, 1, 2].map((k) => tiles.reduce((sum, tile) => sum + tile.frame.normal[k], 0));
    const size = Math.hypot(...normal);
    const half = 6 * Math.floor(line.length / 12);
    return {
        middle: line.slice(half, half + 3),
        normal: size > 0.2 ? normal.map((value) => value / size) : tiles[0].frame.normal,
        radius: Math.max(0.4 * tiles[0].frame.radius, Math.hypot(...ends[0].map((value, k) => value - ends[1][k])) / 2),
    };
}

function farthest(tiles, from) {
    let radius = 0;
    for (const { space } of tiles)
        for (let i = 0; i < space.length; i += 3)
            radius = Math.max(radius, Math.hypot(space[i] - from[0], space[i + 1] - from[1], space[i + 2] - from[2]));
    return radius;
}

export function makeEnvelopeShape(model) {
    const { tiles } = model;
    const triangleCount = tiles.reduce((sum, tile) => sum + tile.triangles.length / 3, 0);
    const edgeCount = tiles.reduce((sum, tile) => sum + tile.loop.length, 0);
    const lower = [Infinity, Infinity, Infinity],
        upper = [-Infinity, -Infinity, -Infinity];
    for (const tile of tiles)
        for (let i = 0; i < tile.space.length; ++i) {
            lower[i % 3] = Math.min(lower[i % 3], tile.space[i]);
            upper[i % 3] = Math.max(upper[i % 3], tile.space[i]);
        }
    const turn = turnOf(model);
    const ids = new Uint16Array(triangleCount);
    const box = [turn(lower), turn(upper)];
    let first = 0;
    for (const tile of tiles) {
        for (const points of [tile.space, tile.flight ?? []])
            for (let i = 0; i < points.length; i += 3) points.set(turn([points[i], points[i + 1], points[i + 2]]), i);
        tile.drawn = tile.flight ? tile.space.slice() : tile.space;
        tile.firstTriangle = first;
        ids.fill(tile.index, first, (first += tile.triangles.length / 3));
    }
    const centre = box[0].map((value, k) => (value + box[1][k]) / 2);
    const shape = {
        model,
        triangleCount,
        positions: new Float32Array(9 * triangleCount), // three corners a triangle
        ids, // the tile of each triangle
        rim: { positions: new Float32Array(18 * edgeCount), ids: new Uint16Array(2 * edgeCount) },
        centre,
        radius: farthest(tiles, centre) || 1,
        turn,
        hasFlight: tiles.some((tile) => tile.flight),
        // Moves the tiles to `share` of the way from their drawn places to those in flight; above 1, beyond.
        pose(share) {
            for (const { space, drawn, flight } of tiles)
                for (let i = 0; flight && i < space.length; ++i) space[i] = drawn[i] + share * (flight[i] - drawn[i]);
            placeTiles(shape);
        },
        pick(origin, direction) {
            shape.picking ??= makePicking(shape.positions);
            return shape.picking(origin, direction);
        },
    };
    placeTiles(shape);
    return shape;
}

// The palette index of each of the shape's triangles, and of the band's.
export function shadesOf(shape, look) {
    const { model } = shape;
    const cloth = new Uint16Array(shape.ids.length);
    const rim = look.map.of_edges ? new Uint16Array(shape.rim.ids.length) : null;
    let edge = 0;
    for (const tile of model.tiles) {
        cloth.set(clothPlaces(tile, look), tile.firstTriangle);
        if (rim) for (const place of rimPlaces(tile, look)) rim.fill(place, 2 * edge, 2 * ++edge);
    }
    return { cloth, rim };
}

// The tile's triangle under the pointer, and the seam within `reach` pixels. `project` maps a point to the screen.
export function pointedAt(shape, ray, pointer, project, reach = 7) {
    const hit = shape.pick(ray.origin, ray.direction);
    if (!hit) return null;
    const tile = shape.model.tiles[shape.ids[hit.triangle]];
    let nearest = reach,
        seam = null;
    for (const side of tile.sides) {
        const points = sidePoints(tile, side, tile.space, 3).map(project);
        for (let i = 0; i + 1 < points.length; ++i) {
            const away = distanceToSegment(pointer, points[i], points[i + 1]);
            if (away < nearest) [nearest, seam] = [away, side.seam];
        }
    }
    return { tile, triangle: hit.triangle - tile.firstTriangle, seam };
}

export function distanceToSegment(p, a, b) {
    const along = [b[0] - a[0], b[1] - a[1]];
    const length = along[0] ** 2 + along[1] ** 2 || 1e-12;
    const share = Math.min(1, Math.max(0, ((p[0] - a[0]) * along[0] + (p[1] - a[1]) * along[1]) / length));
    return Math.hypot(p[0] - a[0] - share * along[0], p[1] - a[1] - share * along[1]);
}
