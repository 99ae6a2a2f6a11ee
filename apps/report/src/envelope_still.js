// The envelope without WebGL: seen from afar, the farthest triangles first. Very many triangles are drawn tile by tile.
import { outlineOf, pointedAt, proposalLine, seamLine, shadesOf } from './envelope_shape.js';
import { cssColour, paletteTable } from './palette.js';

const mostTriangles = 60000;

export function makeEnvelopeStill(shape, canvas) {
    const { model } = shape;
    const context = canvas.getContext('2d');
    const byTile = shape.triangleCount > mostTriangles;
    let azimuth = 0.5, height = 0.25, magnified = 1, waiting = false;
    let shades = null, table = null, chosen = [], marked = [], proposed = [];
    let focus = shape.centre;

    const project = (point) => {
        const [x, y, z] = Array.from(point, (value, k) => value - focus[k]);
        const across = x * Math.cos(azimuth) - z * Math.sin(azimuth);
        const towards = x * Math.sin(azimuth) + z * Math.cos(azimuth);
        const up = y * Math.cos(height) - towards * Math.sin(height);
        const scale = (magnified * 0.47 * Math.min(canvas.clientWidth, canvas.clientHeight)) / shape.radius;
        return [canvas.clientWidth / 2 + scale * across, canvas.clientHeight / 2 - scale * up, towards * Math.cos(height) + y * Math.sin(height)];
    };

    function faces() {
        const list = [];
        if (byTile) {
            for (const tile of model.tiles) {
                const points = Array.from(tile.loop, (vertex) => project(tile.space.subarray(3 * vertex, 3 * vertex + 3)));
                list.push({ points, place: shades.cloth[tile.firstTriangle + Math.floor(tile.triangles.length / 6)] });
            }
        } else {
            for (let t = 0; t < shape.triangleCount; ++t) {
                const points = [0, 1, 2].map((k) => project(shape.positions.subarray(9 * t + 3 * k, 9 * t + 3 * k + 3)));
                list.push({ points, place: shades.cloth[t] });
            }
        }
        if (shades.rim)
            for (let e = 0; e < shape.rim.ids.length; ++e) {
                const points = [0, 1, 2].map((k) => project(shape.rim.positions.subarray(9 * e + 3 * k, 9 * e + 3 * k + 3)));
                for (const point of points) point[2] += 0.002 * shape.radius;
                list.push({ points, place: shades.rim[e] });
            }
        for (const face of list) face.depth = face.points.reduce((sum, point) => sum + point[2], 0) / face.points.length;
        return list.sort((one, other) => one.depth - other.depth);
    }

    function stroke(points, colour, width, dash = []) {
        context.strokeStyle = colour;
        context.lineWidth = width;
        context.setLineDash(dash);
        context.beginPath();
        for (let i = 0; i < points.length; i += 6) {
            const goesOn = i > 0 && [0, 1, 2].every((k) => points[i + k] === points[i + k - 3]);
            if (!goesOn) context.moveTo(...project(points.slice(i, i + 3)));
            context.lineTo(...project(points.slice(i + 3, i + 6)));
        }
        context.stroke();
    }

    function draw() {
        waiting = false;
        if (!shades || !canvas.clientWidth) return;
        const ratio = canvas.width / canvas.clientWidth;
        context.setTransform(ratio, 0, 0, ratio, 0, 0);
        context.fillStyle = '#fff';
        context.fillRect(0, 0, canvas.clientWidth, canvas.clientHeight);
        context.lineWidth = 0.6;
        context.setLineDash([]);
        for (const { points, place } of faces()) {
            context.fillStyle = context.strokeStyle = cssColour(table, place);
            context.beginPath();
            points.forEach(([x, y], i) => (i ? context.lineTo(x, y) : context.moveTo(x, y)));
            context.closePath();
            context.fill();
            context.stroke();
        }
        const seen = model.tiles.filter(({ frame: { normal } }) => project(focus.map((value, k) => value + normal[k]))[2] > 0);
        stroke(seen.flatMap(outlineOf), 'rgb(31 41 51 / 0.4)', 1);
        stroke(marked, '#a50f2d', 2.5);
        stroke(proposed, '#111', 3, [8, 5]);
        stroke(chosen, '#fff', 8);
        stroke(chosen, '#00734f', 4.5);
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
        recolour(map, palette) {
            shades = shadesOf(shape, map);
            table = paletteTable(palette);
            request();
        },
        choose(tiles, seam) {
            chosen = seam ? seamLine(model, seam) : tiles.flatMap(outlineOf);
            request();
        },
        mark(failingTiles, failingSeams) {
            marked = [...failingTiles.flatMap(outlineOf), ...failingSeams.flatMap((seam) => seamLine(model, seam))];
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
            const scale = (magnified * 0.47 * Math.min(canvas.clientWidth, canvas.clientHeight)) / shape.radius;
            const across = (x - canvas.clientWidth / 2) / scale, up = (canvas.clientHeight / 2 - y) / scale;
            const right = [Math.cos(azimuth), 0, -Math.sin(azimuth)];
            const towards = [Math.sin(azimuth) * Math.cos(height), Math.sin(height), Math.cos(azimuth) * Math.cos(height)];
            const upward = [-Math.sin(azimuth) * Math.sin(height), Math.cos(height), -Math.cos(azimuth) * Math.sin(height)];
            const origin = focus.map((value, k) => value + across * right[k] + up * upward[k] + 10 * shape.radius * towards[k]);
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
