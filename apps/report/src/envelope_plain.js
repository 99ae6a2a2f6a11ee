// The envelope without WebGL: seen from afar, each pixel in the colour of the nearest triangle there.
import { outlineOf, pointedAt, proposalLine, seamLine, shadesOf } from './envelope_shape.js';
import { paletteTable } from './palette.js';
import { fillTriangle, makeImage } from './raster.js';

export function makeEnvelopePlain(shape, canvas) {
    const { model } = shape;
    const context = canvas.getContext('2d');
    let azimuth = 0.5,
        height = 0.25,
        magnified = 1,
        waiting = false;
    let shades = null,
        table = null,
        showChosen = () => [],
        showMarked = () => [],
        chosen = [],
        isSeam = false,
        marked = [],
        proposed = [];
    let focus = shape.centre;

    // What every point is projected by: asked of the page once a picture, for asking takes longer than drawing.
    let look = null;
    const takeLook = () => {
        const { clientWidth: width, clientHeight: high } = canvas;
        look = {
            sin: Math.sin(azimuth),
            cos: Math.cos(azimuth),
            sinHeight: Math.sin(height),
            cosHeight: Math.cos(height),
            x: width / 2,
            y: high / 2,
            scale: (magnified * 0.47 * Math.min(width, high)) / shape.radius,
        };
    };
    const project = (point) => {
        const x = point[0] - focus[0],
            y = point[1] - focus[1],
            z = point[2] - focus[2];
        const across = x * look.cos - z * look.sin,
            towards = x * look.sin + z * look.cos;
        const up = y * look.cosHeight - towards * look.sinHeight;
        return [look.x + look.scale * across, look.y - look.scale * up, towards * look.cosHeight + y * look.sinHeight];
    };

    // Triangles of three corners each, in the colours of their places; `ahead`: drawn as if nearer by so much.
    function fill(image, positions, triangleShades, ratio, ahead) {
        const colours = new Uint32Array(table.buffer);
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

    // Is a place hidden by cloth before it? Depths are those of triangles' middles, so lines may lie behind by some of their size.
    function isHidden([x, y, towards], image, ratio) {
        const column = Math.floor(x * ratio),
            row = Math.floor(y * ratio);
        if (column < 0 || row < 0 || column >= image.width || row >= image.height) return false;
        return image.depths[row * image.width + column] > towards + 0.04 * shape.radius;
    }

    function visible(points, image, ratio) {
        const result = [];
        for (let i = 0; i < points.length; i += 6) {
            const middle = [0, 1, 2].map((k) => (points[i + k] + points[i + k + 3]) / 2);
            if (!isHidden(project(middle), image, ratio)) result.push(...points.slice(i, i + 6));
        }
        return result;
    }

    function stroke(points, colour, width, dash = []) {
        context.strokeStyle = colour;
        context.lineWidth = width;
        context.setLineDash(dash);
        context.beginPath();
        for (let i = 0; i < points.length; i += 6) {
            const goesOn = i > 0 && [0, 1, 2].every((k) => points[i + k] === points[i + k - 3]);
            if (!goesOn) {
                // Many short paths are drawn much faster than one of many parts.
                context.stroke();
                context.beginPath();
                context.moveTo(...project(points.slice(i, i + 3)));
            }
            context.lineTo(...project(points.slice(i + 3, i + 6)));
        }
        context.stroke();
    }

    function draw() {
        waiting = false;
        if (!shades || !canvas.clientWidth) return;
        takeLook();
        const ratio = canvas.width / canvas.clientWidth;
        const image = makeImage(context, -Infinity);
        image.pixels.fill(0xffffffff);
        fill(image, shape.positions, shades.cloth, ratio, 0);
        if (shades.rim) fill(image, shape.rim.positions, shades.rim, ratio, 0.004 * shape.radius);
        context.putImageData(image.data, 0, 0);
        context.setTransform(ratio, 0, 0, ratio, 0, 0);
        const seen = model.tiles.filter(
            ({ frame: { normal } }) => project(focus.map((value, k) => value + normal[k]))[2] > 0,
        );
        stroke(seen.flatMap(outlineOf), 'rgb(31 41 51 / 0.4)', 1);
        stroke(visible(marked, image, ratio), '#a50f2d', 2.5);
        stroke(visible(proposed, image, ratio), '#111', 3, [8, 5]);
        // Seams are short: they are seen through the cloth too.
        const line = isSeam ? chosen : visible(chosen, image, ratio);
        stroke(line, '#fff', 8);
        stroke(line, '#00734f', 4.5);
    }
    const request = () => {
        if (!waiting) requestAnimationFrame(draw);
        waiting = true;
    };
    const turn = (right, up) => {
        azimuth += right;
        height = Math.min(1.5, Math.max(-1.5, height + up));
        request();
    };
    canvas.addEventListener('pointermove', (event) => {
        if (event.buttons & 1) turn(-event.movementX / 150, event.movementY / 150);
    });

    return {
        // After `shape.pose`.
        repose() {
            chosen = showChosen();
            marked = showMarked();
            request();
        },
        recolour(map, palette) {
            shades = shadesOf(shape, map);
            table = paletteTable(palette);
            request();
        },
        choose(tiles, seam) {
            isSeam = Boolean(seam);
            showChosen = () => (seam ? seamLine(model, seam) : tiles.flatMap(outlineOf));
            chosen = showChosen();
            request();
        },
        mark(failingTiles, failingSeams) {
            showMarked = () => [
                ...failingTiles.flatMap(outlineOf),
                ...failingSeams.flatMap((seam) => seamLine(model, seam)),
            ];
            marked = showMarked();
            proposed = failingTiles.flatMap((tile) => proposalLine(shape, tile));
            request();
        },
        lookAt({ normal }) {
            azimuth = Math.atan2(normal[0], normal[2]);
            height = Math.asin(Math.max(-1, Math.min(1, normal[1]))) * 0.8;
            request();
        },
        home() {
            [azimuth, height, magnified, focus] = [0.5, 0.25, 1, shape.centre];
            request();
        },
        turn,
        zoom(factor) {
            magnified = Math.min(40, Math.max(0.2, magnified / factor));
            request();
        },
        pointed(x, y) {
            // The ray through the pointer: where it meets the plane of the screen, from far before it.
            takeLook();
            const { sin, cos, sinHeight, cosHeight } = look;
            const across = (x - look.x) / look.scale,
                up = (look.y - y) / look.scale;
            const right = [cos, 0, -sin],
                towards = [sin * cosHeight, sinHeight, cos * cosHeight],
                upward = [-sin * sinHeight, cosHeight, -cos * sinHeight];
            const origin = focus.map(
                (value, k) => value + across * right[k] + up * upward[k] + 10 * shape.radius * towards[k],
            );
            return pointedAt(shape, { origin, direction: towards.map((value) => -value) }, [x, y], project);
        },
        resize(width, height) {
            const ratio = Math.min(2, window.devicePixelRatio);
            canvas.width = Math.round(width * ratio);
            canvas.height = Math.round(height * ratio);
            request();
        },
        drawNow: draw,
    };
}
