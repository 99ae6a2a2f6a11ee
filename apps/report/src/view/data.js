// What the program put into the page, unpacked: report.json as it is, the shapes (src/ripstop/report/page_shapes.h) and, once `nest` was
// run, marker.json.
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

// Steps from row to row, summed up; a typed array wraps round as the steps do.
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

    map(map) {
        return map && { values: this.of(Int16Array, map.array), step: map.step };
    }

    line(number) {
        const places = this.summed(Int32Array, number, 2);
        return Float64Array.from(places, (place) => place / 100); // mm
    }
}

function tileOf(index, said, shape, arrays, fabrics) {
    const Vertex = shape.space && arrays.places[shape.space.array][1] / 6 < 65536 ? Uint16Array : Uint32Array;
    const maps = {};
    for (const [name, map] of Object.entries(shape.maps ?? {})) maps[name] = arrays.map(map);
    const triangles = arrays.summed(Vertex, shape.triangles, 3);
    const flight = shape.flight ? flightOf(shape.flight, triangles, arrays, maps) : null;
    return {
        index,
        said,
        name: said.name,
        ok: said.verdict.manufacturable,
        findings: said.verdict.findings,
        fabric: fabrics.get(said.fabric),
        space: arrays.grid(shape.space, 3), // where it is shown: as drawn, in flight or between (envelope_shape.js)
        flight, // where its vertices are in flight; null where it was not inflated
        flat: shape.flat ? arrays.grid(shape.flat, 2) : null,
        triangles,
        loop: arrays.summed(Vertex, shape.loop, 1),
        chains: shape.chains,
        maps,
        edgeError: arrays.map(shape.edge_error),
        tension: arrays.map(shape.tension),
        limits: { strain: shape.strain_limit, shear: shape.shear_limit },
        sides: [], // the seams along it: { seam, side }
        piece: null,
    };
}

// In flight, its figures beside the maps of the cloth: `flightTension` and the like. Of the deviation the mean of the corners.
function flightOf(shape, triangles, arrays, maps) {
    const { array, step } = shape.deviation;
    const atVertices = arrays.of(Int16Array, array);
    const deviation = new Int16Array(triangles.length / 3);
    for (let t = 0; t < deviation.length; ++t) {
        const [a, b, c] = [triangles[3 * t], triangles[3 * t + 1], triangles[3 * t + 2]];
        deviation[t] = Math.round((atVertices[a] + atVertices[b] + atVertices[c]) / 3);
    }
    maps.flightDeviation = { values: deviation, step };
    maps.flightTension = arrays.map(shape.tension);
    maps.flightWarp = arrays.map(shape.warp);
    maps.flightWeft = arrays.map(shape.weft);
    maps.flightShear = arrays.map(shape.shear);
    maps.flightStrainWarp = arrays.map(shape.strain_warp);
    maps.flightStrainWeft = arrays.map(shape.strain_weft);
    maps.flightStrainShear = arrays.map(shape.strain_shear);
    maps.flightState = arrays.map(shape.state);
    return arrays.grid(shape.space, 3);
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

export async function readModel() {
    const [reportBuffer, buffer] = await Promise.all([unpacked('ripstop-report'), unpacked('ripstop-shapes')]);
    const report = JSON.parse(new TextDecoder().decode(reportBuffer));
    const textLength = new DataView(buffer).getUint32(4, true);
    const shapes = JSON.parse(new TextDecoder().decode(new Uint8Array(buffer, 8, textLength)));
    const arrays = new Arrays(buffer, 8 + textLength, shapes.arrays);
    const fabrics = new Map(report.fabrics.map((fabric) => [fabric.name, fabric]));
    const tiles = report.tiles.map((said, i) => tileOf(i, said, shapes.tiles[i], arrays, fabrics));
    const seams = report.seams.map((said, index) => {
        const seam = { index, said, id: said.id, ok: said.ok, sides: [] };
        for (const name of ['a', 'b']) {
            const run = shapes.seams[index]?.[name];
            if (!run) continue;
            const side = { ...run, name, seam };
            seam.sides.push(side);
            tiles[run.tile].sides.push(side);
        }
        return seam;
    });
    for (const tile of tiles) tile.sides.sort((one, other) => one.first - other.first);
    for (const shape of shapes.pieces) tiles[shape.tile].piece = pieceOf(shape, arrays);
    const roll = document.getElementById('ripstop-roll').textContent
        ? JSON.parse(new TextDecoder().decode(await unpacked('ripstop-roll')))
        : null;
    return { report, tiles, seams, roll };
}

// The points of a side of a seam along its tile's boundary: `columns` numbers each, out of `positions`.
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
