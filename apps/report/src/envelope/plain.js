// The envelope without WebGL, with the same functions as the WebGL scene (scene.js).
import { outlineOf, proposalLine, seamLine } from './lines.js';
import { paintCloth, stroke, visible } from './plain_picture.js';
import { makeProjection } from './projection.js';
import { pointedAt, shadesOf } from './shape.js';

// Lines in space drawn over the cloth; `place` updates them after the tiles have moved.
function makeMarks(shape) {
    const { model } = shape;
    let showChosen = () => [],
        showFailing = () => [];
    const marks = { chosen: [], failing: [], proposed: [], isSeam: false };
    return Object.assign(marks, {
        place() {
            marks.chosen = showChosen();
            marks.failing = showFailing();
        },
        choose(tiles, seam) {
            marks.isSeam = Boolean(seam);
            showChosen = () => (seam ? seamLine(model, seam) : tiles.flatMap(outlineOf));
            marks.chosen = showChosen();
        },
        mark(tiles, seams) {
            showFailing = () => [...tiles.flatMap(outlineOf), ...seams.flatMap((seam) => seamLine(model, seam))];
            marks.failing = showFailing();
            marks.proposed = tiles.flatMap((tile) => proposalLine(shape, tile));
        },
    });
}

function drawLines(context, shape, marks, image, project, ratio) {
    const seenOf = (points) => visible(points, image, project, ratio, 0.04 * shape.radius);
    const draw = (points, ...how) => stroke(context, project, points, ...how);
    const facing = shape.model.tiles.filter(
        ({ frame: { normal } }) => project(shape.centre.map((value, k) => value + normal[k]))[2] > 0,
    );
    draw(facing.flatMap(outlineOf), 'rgb(31 41 51 / 0.4)', 1);
    draw(seenOf(marks.failing), '#a50f2d', 2.5);
    draw(seenOf(marks.proposed), '#111', 3, [8, 5]);
    // A chosen seam is short, so it is drawn through the cloth too.
    const line = marks.isSeam ? marks.chosen : seenOf(marks.chosen);
    draw(line, '#fff', 8);
    draw(line, '#00734f', 4.5);
}

export function makeEnvelopePlain(shape, canvas) {
    const context = canvas.getContext('2d');
    const projection = makeProjection(shape, canvas);
    const { project, rayThrough } = projection;
    const marks = makeMarks(shape);
    let waiting = false,
        colours = null;
    const draw = () => {
        waiting = false;
        if (!colours || !canvas.clientWidth) return;
        projection.takeLook();
        const ratio = canvas.width / canvas.clientWidth;
        const image = paintCloth(context, shape, colours.shades, colours.table, project, ratio);
        context.setTransform(ratio, 0, 0, ratio, 0, 0);
        drawLines(context, shape, marks, image, project, ratio);
    };
    const request = () => {
        if (!waiting) requestAnimationFrame(draw);
        waiting = true;
    };
    const then =
        (change) =>
        (...values) => {
            change(...values);
            request();
        };
    const turn = then(projection.turn);
    canvas.addEventListener('pointermove', (event) => {
        if (event.buttons & 1) turn(-event.movementX / 150, event.movementY / 150);
    });
    return {
        turn,
        home: then(projection.home),
        zoom: then(projection.zoom),
        lookAt: then(({ normal }) => projection.lookAlong(normal)),
        repose: then(marks.place), // after `shape.pose`
        choose: then(marks.choose),
        mark: then(marks.mark),
        recolour: then((look) => {
            colours = { shades: shadesOf(shape, look), table: look.table };
        }),
        pointed: (x, y) => pointedAt(shape, rayThrough(x, y), [x, y], project),
        resize: then((width, height) => {
            const ratio = Math.min(2, window.devicePixelRatio);
            canvas.width = Math.round(width * ratio);
            canvas.height = Math.round(height * ratio);
        }),
        drawNow: draw,
    };
}
