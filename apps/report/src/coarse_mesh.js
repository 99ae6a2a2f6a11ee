// The cloth in fewer triangles, for while it moves: the corners within a cell of space are one, at their mean.
const mostTriangles = 120000;

// Numbers of the cells of a grid that places lie in, from 0, and the mean of the places in each.
function clustered(positions, size) {
    const numbers = new Map(),
        cells = new Uint32Array(positions.length / 3);
    const sums = [];
    for (let i = 0; i < cells.length; ++i) {
        const [x, y, z] = [0, 1, 2].map((k) => Math.floor(positions[3 * i + k] / size) + 32768);
        const key = (x * 65536 + y) * 65536 + z;
        let cell = numbers.get(key);
        if (cell === undefined) {
            cell = numbers.size;
            numbers.set(key, cell);
            sums.push(0, 0, 0, 0);
        }
        cells[i] = cell;
        for (let k = 0; k < 3; ++k) sums[4 * cell + k] += positions[3 * i + k];
        ++sums[4 * cell + 3];
    }
    return { cells, mean: (cell, k) => sums[4 * cell + k] / sums[4 * cell + 3] };
}

// Three corners a triangle and its tile, as the shape has them, and `of`: which of the shape's triangles each is. Null where the shape
// is small enough as it is.
export function coarseMesh({ positions, ids, radius }) {
    if (ids.length <= mostTriangles) return null;
    // Of triangles of one size on a sphere about as many are left as fill it at this size; a lobed shape has more.
    const { cells, mean } = clustered(positions, radius * Math.sqrt((16 * Math.PI) / mostTriangles));
    const of = [];
    for (let t = 0; t < ids.length; ++t) {
        const [a, b, c] = cells.subarray(3 * t, 3 * t + 3);
        if (a !== b && b !== c && c !== a) of.push(t);
    }
    const coarse = { positions: new Float32Array(9 * of.length), ids: new Uint16Array(of.length), of };
    of.forEach((t, i) => {
        coarse.ids[i] = ids[t];
        for (let corner = 0; corner < 3; ++corner)
            for (let k = 0; k < 3; ++k) coarse.positions[9 * i + 3 * corner + k] = mean(cells[3 * t + corner], k);
    });
    return coarse;
}
