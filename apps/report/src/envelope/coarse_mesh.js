// The cloth with fewer triangles, for use while it moves: the corners within one grid cell are merged at their mean.
const mostTriangles = 120000;

// The cell index of each place, counted from 0, and the number of cells.
function clustered(positions, size) {
    const numbers = new Map(),
        cells = new Uint32Array(positions.length / 3);
    for (let i = 0; i < cells.length; ++i) {
        const [x, y, z] = [0, 1, 2].map((k) => Math.floor(positions[3 * i + k] / size) + 32768);
        const key = (x * 65536 + y) * 65536 + z;
        let cell = numbers.get(key);
        if (cell === undefined) {
            cell = numbers.size;
            numbers.set(key, cell);
        }
        cells[i] = cell;
    }
    return { cells, count: numbers.size };
}

function meansOf(positions, { cells, count }) {
    const means = new Float64Array(3 * count),
        members = new Uint32Array(count);
    for (let i = 0; i < cells.length; ++i) {
        ++members[cells[i]];
        for (let k = 0; k < 3; ++k) means[3 * cells[i] + k] += positions[3 * i + k];
    }
    return means.map((sum, i) => sum / members[Math.floor(i / 3)]);
}

// Three corners per triangle, as in the shape, and `of`: the shape's triangle of each. `place` moves the corners; call
// it after the shape's places have changed. Null if the shape is small enough.
export function coarseMesh({ positions, ids, radius }) {
    if (ids.length <= mostTriangles) return null;
    // On a sphere with triangles of one size, about as many remain as fill it at this size; a lobed shape keeps more.
    const clusters = clustered(positions, radius * Math.sqrt((16 * Math.PI) / mostTriangles));
    const { cells } = clusters;
    const of = [];
    for (let t = 0; t < ids.length; ++t) {
        const [a, b, c] = cells.subarray(3 * t, 3 * t + 3);
        if (a !== b && b !== c && c !== a) of.push(t);
    }
    const coarse = {
        positions: new Float32Array(9 * of.length),
        of,
        place() {
            const means = meansOf(positions, clusters);
            of.forEach((t, i) => {
                for (let corner = 0; corner < 3; ++corner)
                    for (let k = 0; k < 3; ++k)
                        coarse.positions[9 * i + 3 * corner + k] = means[3 * cells[3 * t + corner] + k];
            });
        },
    };
    coarse.place();
    return coarse;
}
