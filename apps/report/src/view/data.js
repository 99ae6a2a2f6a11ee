// The data that the program put into the page, unpacked: report.json, the shapes
// (src/ripstop/report/page/page_shapes.h) and, after `nest`, marker.json.
import { paletteTable } from './palette.js';

function bytesOf(id) {
    const text = document.getElementById(id).textContent.trim();
    if (Uint8Array.fromBase64) return Uint8Array.fromBase64(text);
    const packed = atob(text);
    const bytes = new Uint8Array(packed.length);
    for (let i = 0; i < packed.length; ++i) bytes[i] = packed.charCodeAt(i);
    return bytes;
}

async function unpacked(id) {
    const stream = new Blob([bytesOf(id)]).stream().pipeThrough(new DecompressionStream('deflate'));
    return new Response(stream).arrayBuffer();
}

// Sums up the steps from row to row; a typed array wraps round as the steps do.
function summed(steps, columns) {
    for (let i = columns; i < steps.length; ++i) steps[i] += steps[i - columns];
    return steps;
}

class Arrays {
    constructor(buffer, base, places) {
        Object.assign(this, { buffer, base, places, known: new Map() });
    }

    once(key, make) {
        if (!this.known.has(key)) this.known.set(key, make());
        return this.known.get(key);
    }

    of(Type, number) {
        const [start, length] = this.places[number];
        return new Type(this.buffer, this.base + start, length / Type.BYTES_PER_ELEMENT);
    }

    summed(Type, number, columns) {
        return this.once(`${Type.name} ${number}`, () => summed(new Type(this.of(Type, number)), columns));
    }

    grid(grid, columns) {
        const places = this.summed(Uint16Array, grid.array, columns);
        const points = new Float32Array(places.length);
        for (let i = 0; i < points.length; ++i) points[i] = grid.lower_m[i % columns] + grid.step_m * places[i];
        return points;
    }

    maps(maps) {
        const entries = Object.entries(maps).map(([id, { array, step }]) => [
            id,
            { values: this.of(Int16Array, array), step },
        ]);
        return Object.fromEntries(entries);
    }

    line(number) {
        const places = this.summed(Int32Array, number, 2);
        return Float64Array.from(places, (place) => place / 100); // mm
    }
}

function tileOf(index, said, shape, arrays, fabrics) {
    const Vertex = shape.space && arrays.places[shape.space.array][1] / 6 < 65536 ? Uint16Array : Uint32Array;
    return {
        index,
        said,
        name: said.name,
        ok: said.verdict.manufacturable,
        findings: said.verdict.findings,
        fabric: fabrics.get(said.fabric),
        space: arrays.grid(shape.space, 3), // where it is shown: as drawn, in flight or between (envelope/shape.js)
        flight: shape.flight ? arrays.grid(shape.flight.space, 3) : null, // where its vertices are in flight
        flat: shape.flat ? arrays.grid(shape.flat, 2) : null,
        triangles: arrays.summed(Vertex, shape.triangles, 3),
        loop: arrays.summed(Vertex, shape.loop, 1),
        chains: shape.chains,
        maps: arrays.maps(shape.maps), // by the maps' ids: a number a triangle
        edges: arrays.maps(shape.edges), // a number a boundary edge
        limits: { strain: shape.strain_limit, shear: shape.shear_limit },
        rings: shape.rings ?? [], // where findings are marked: [vertex, finding]
        proposed: shape.proposed === undefined ? null : arrays.line(shape.proposed),
        sides: [], // the seams along it: { seam, side }
        piece: null,
    };
}

function pieceOf(shape, arrays) {
    return {
        cut: arrays.line(shape.cut),
        sew: arrays.line(shape.sew),
        slits: arrays.line(shape.slits),
        grain: arrays.line(shape.grain),
        lines: shape.lines.map((line) => ({ name: line.name, points: arrays.line(line.points) })),
        labels: shape.labels,
    };
}

function seamOf(index, said, shape, tiles) {
    const seam = { index, said, id: said.id, ok: said.ok, sides: [] };
    for (const name of ['a', 'b']) {
        if (!shape?.[name]) continue;
        const side = { ...shape[name], name, seam };
        seam.sides.push(side);
        tiles[side.tile].sides.push(side);
    }
    return seam;
}

const textOf = (buffer, start, length) => new TextDecoder().decode(new Uint8Array(buffer, start, length));

// `buffer`: the bytes of `page_shapes`.
export function modelOf(report, buffer, roll) {
    const textLength = new DataView(buffer).getUint32(4, true);
    const shapes = JSON.parse(textOf(buffer, 8, textLength));
    const arrays = new Arrays(buffer, 8 + textLength, shapes.arrays);
    const fabrics = new Map(report.fabrics.map((fabric) => [fabric.name, fabric]));
    const tiles = report.tiles.map((said, i) => tileOf(i, said, shapes.tiles[i], arrays, fabrics));
    const seams = report.seams.map((said, i) => seamOf(i, said, shapes.seams[i], tiles));
    for (const tile of tiles) tile.sides.sort((one, other) => one.first - other.first);
    for (const shape of shapes.pieces) tiles[shape.tile].piece = pieceOf(shape, arrays);
    const palettes = shapes.palettes.map((palette) => ({ ...palette, table: paletteTable(palette.colours) }));
    return { report, tiles, seams, roll, palettes, maps: shapes.maps, first: shapes.first, isYUp: shapes.is_y_up };
}

export async function readModel() {
    const [report, buffer] = await Promise.all([unpacked('ripstop-report'), unpacked('ripstop-shapes')]);
    const roll = document.getElementById('ripstop-roll').textContent ? await unpacked('ripstop-roll') : null;
    const jsonOf = (bytes) => JSON.parse(new TextDecoder().decode(bytes));
    return modelOf(jsonOf(report), buffer, roll && jsonOf(roll));
}

// The points of a side of a seam along its tile's boundary: `columns` numbers each, from `positions`.
export function sidePoints(tile, side, positions, columns) {
    const { loop } = tile;
    const at = (edge, share) => {
        const a = loop[edge % loop.length] * columns,
            b = loop[(edge + 1) % loop.length] * columns;
        return Array.from(
            { length: columns },
            (_, k) => positions[a + k] + share * (positions[b + k] - positions[a + k]),
        );
    };
    const last = side.first + side.count - 1;
    const points = [at(side.first, side.from)];
    for (let edge = side.first + 1; edge <= last; ++edge) points.push(at(edge, 0));
    points.push(at(last, side.to));
    return points;
}
