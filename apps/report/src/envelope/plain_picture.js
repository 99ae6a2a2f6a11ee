// The picture without WebGL: each pixel has the colour of the nearest triangle there, with lines on top.
import { fillTriangle, makeImage } from '../view/raster.js';

// Triangles with three corners each, coloured by their palette indices; `ahead`: depth offset towards the viewer.
function fill(image, { project, colours, ratio }, positions, triangleShades, ahead) {
    const x = [0, 0, 0],
        y = [0, 0, 0];
    for (let t = 0; t < triangleShades.length; ++t) {
        let depth = ahead;
        for (let k = 0; k < 3; ++k) {
            const [across, down, towards] = project(positions.subarray(9 * t + 3 * k, 9 * t + 3 * k + 3));
            x[k] = across * ratio;
            y[k] = down * ratio;
            depth += towards / 3;
        }
        fillTriangle(image, colours[triangleShades[t]], x, y, depth);
    }
}

// Paints cloth and band, and returns the data that `visible` needs. `table`: the palette's bytes.
export function paintCloth(context, shape, shades, table, project, ratio) {
    const image = makeImage(context, -Infinity);
    image.pixels.fill(0xffffffff);
    const paint = { project, colours: new Uint32Array(table.buffer), ratio };
    fill(image, paint, shape.positions, shades.cloth, 0);
    if (shades.rim) fill(image, paint, shape.rim.positions, shades.rim, 0.004 * shape.radius);
    context.putImageData(image.data, 0, 0);
    return image;
}

// Whether cloth in front hides a place. Depths are those of triangles' middles, so lines may lie behind by some of
// their size.
function isHidden([x, y, towards], image, ratio, play) {
    const column = Math.floor(x * ratio),
        row = Math.floor(y * ratio);
    if (column < 0 || row < 0 || column >= image.width || row >= image.height) return false;
    return image.depths[row * image.width + column] > towards + play;
}

export function visible(points, image, project, ratio, play) {
    const result = [];
    for (let i = 0; i < points.length; i += 6) {
        const middle = [0, 1, 2].map((k) => (points[i + k] + points[i + k + 3]) / 2);
        if (!isHidden(project(middle), image, ratio, play)) result.push(...points.slice(i, i + 6));
    }
    return result;
}

export function stroke(context, project, points, colour, width, dash = []) {
    context.strokeStyle = colour;
    context.lineWidth = width;
    context.setLineDash(dash);
    context.beginPath();
    for (let i = 0; i < points.length; i += 6) {
        const goesOn = i > 0 && [0, 1, 2].every((k) => points[i + k] === points[i + k - 3]);
        if (!goesOn) {
            // Many short paths are much faster to draw than one with many parts.
            context.stroke();
            context.beginPath();
            context.moveTo(...project(points.slice(i, i + 3)));
        }
        context.lineTo(...project(points.slice(i + 3, i + 6)));
    }
    context.stroke();
}
