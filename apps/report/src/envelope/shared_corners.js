// Triangles that share vertices and have a colour each. WebGL takes the colour of a triangle's last corner, so every
// triangle needs a last corner of its own: about one vertex per triangle instead of three.

// `corners`: the vertices of the triangles, three each. Returns the same triangles, each with a last corner of its own,
// and the source vertex of each new one: { index, copies }.
export function withOwnCorners(corners, vertexCount) {
    const index = new Uint32Array(corners.length);
    const isTaken = new Uint8Array(vertexCount);
    const copies = Array.from({ length: vertexCount }, (_, vertex) => vertex);
    for (let t = 0; t < corners.length; t += 3) {
        let own = 0;
        while (own < 3 && isTaken[corners[t + own]]) ++own;
        if (own === 3) {
            index.set([corners[t], corners[t + 1], copies.length], t);
            copies.push(corners[t + 2]);
            continue;
        }
        isTaken[corners[t + own]] = 1;
        index.set([corners[t + ((own + 1) % 3)], corners[t + ((own + 2) % 3)], corners[t + own]], t);
    }
    return { index, copies };
}
