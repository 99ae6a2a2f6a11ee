// Finds the first triangle that a ray meets. Triangles are grouped in blocks of 64 in their given order, each with a
// bounding box: meshes list neighbours close together, so few blocks are searched.
const blockSize = 64;

export function makePicking(positions) {
    const triangleCount = positions.length / 9;
    const blockCount = Math.ceil(triangleCount / blockSize);
    const boxes = new Float32Array(6 * blockCount);
    for (let b = 0; b < blockCount; ++b) {
        const box = [Infinity, Infinity, Infinity, -Infinity, -Infinity, -Infinity];
        for (let i = 9 * b * blockSize; i < Math.min(9 * (b + 1) * blockSize, positions.length); ++i) {
            const k = i % 3;
            box[k] = Math.min(box[k], positions[i]);
            box[k + 3] = Math.max(box[k + 3], positions[i]);
        }
        boxes.set(box, 6 * b);
    }

    const meetsBox = (b, origin, inverse, nearest) => {
        let from = 0,
            to = nearest;
        for (let k = 0; k < 3; ++k) {
            const one = (boxes[6 * b + k] - origin[k]) * inverse[k],
                other = (boxes[6 * b + k + 3] - origin[k]) * inverse[k];
            from = Math.max(from, Math.min(one, other));
            to = Math.min(to, Math.max(one, other));
        }
        return from <= to;
    };

    // Moeller and Trumbore: returns the distance along the ray, or Infinity.
    const meetsTriangle = (t, o, d) => {
        const i = 9 * t;
        const ax = positions[i],
            ay = positions[i + 1],
            az = positions[i + 2];
        const ex = positions[i + 3] - ax,
            ey = positions[i + 4] - ay,
            ez = positions[i + 5] - az;
        const fx = positions[i + 6] - ax,
            fy = positions[i + 7] - ay,
            fz = positions[i + 8] - az;
        const px = d[1] * fz - d[2] * fy,
            py = d[2] * fx - d[0] * fz,
            pz = d[0] * fy - d[1] * fx;
        const det = ex * px + ey * py + ez * pz;
        if (det === 0) return Infinity;
        const tx = o[0] - ax,
            ty = o[1] - ay,
            tz = o[2] - az;
        const u = (tx * px + ty * py + tz * pz) / det;
        if (u < 0 || u > 1) return Infinity;
        const qx = ty * ez - tz * ey,
            qy = tz * ex - tx * ez,
            qz = tx * ey - ty * ex;
        const v = (d[0] * qx + d[1] * qy + d[2] * qz) / det;
        if (v < 0 || u + v > 1) return Infinity;
        const distance = (fx * qx + fy * qy + fz * qz) / det;
        return distance > 0 ? distance : Infinity;
    };

    // `origin`, `direction`: three numbers each. Returns { triangle, distance } or null.
    return function pick(origin, direction) {
        const inverse = direction.map((value) => 1 / (value || 1e-30));
        let nearest = Infinity,
            found = -1;
        for (let b = 0; b < blockCount; ++b) {
            if (!meetsBox(b, origin, inverse, nearest)) continue;
            for (let t = b * blockSize; t < Math.min((b + 1) * blockSize, triangleCount); ++t) {
                const distance = meetsTriangle(t, origin, direction);
                if (distance < nearest) {
                    nearest = distance;
                    found = t;
                }
            }
        }
        return found < 0 ? null : { triangle: found, distance: nearest };
    };
}
