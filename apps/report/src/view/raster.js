// Rasterises triangles: a hundred times faster than one path each, and without gaps.

// The pixels of a canvas; with `farthest`, also a depth buffer.
export function makeImage(context, farthest) {
    const { width, height } = context.canvas;
    const data = context.createImageData(width, height);
    const depths = farthest === undefined ? null : new Float32Array(width * height).fill(farthest);
    return { width, height, data, pixels: new Uint32Array(data.data.buffer), depths };
}

// Fills the pixels whose centres lie in the triangle; with depths, only where nothing is nearer (greater) than `depth`.
export function fillTriangle(image, colour, x, y, depth) {
    const top = Math.max(0, Math.ceil(Math.min(y[0], y[1], y[2]) - 0.5));
    const bottom = Math.min(image.height - 1, Math.floor(Math.max(y[0], y[1], y[2]) - 0.5));
    for (let row = top; row <= bottom; ++row) {
        const middle = row + 0.5;
        let from = Infinity,
            to = -Infinity;
        for (let k = 0; k < 3; ++k) {
            const next = (k + 1) % 3;
            if (y[k] <= middle === y[next] <= middle) continue;
            const at = x[k] + ((middle - y[k]) / (y[next] - y[k])) * (x[next] - x[k]);
            from = Math.min(from, at);
            to = Math.max(to, at);
        }
        const first = Math.max(0, Math.ceil(from - 0.5)),
            last = Math.min(image.width - 1, Math.floor(to - 0.5));
        for (let i = row * image.width + first; i <= row * image.width + last; ++i) {
            if (image.depths) {
                if (image.depths[i] > depth) continue;
                image.depths[i] = depth;
            }
            image.pixels[i] = colour;
        }
    }
}
