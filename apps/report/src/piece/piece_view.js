// The piece of a tile as it is cut: strain in colours, cut and sew line, notches, grain, labels, seams, and the
// proposed seam.
import { sidePoints } from '../view/data.js';
import { html, svg } from '../view/dom.js';
import { figure, millimetres } from '../view/format.js';
import { clothPlaces, rimPlaces } from '../view/maps.js';
import { cssColour, places } from '../view/palette.js';
import { withButtons } from './piece_zoom.js';
import { fillTriangle, makeImage } from '../view/raster.js';

const pixels = { seen: 900, zoomed: 2000 }; // of the picture of the triangles, along its longer side

// Coordinates of the drawing: x as on the cloth, y downwards, millimetres.
function frameOf(tile) {
    const box = [Infinity, Infinity, -Infinity, -Infinity];
    const points = [...(tile.piece?.cut ?? []), ...(tile.flat ?? []).map((value) => value * 1000)];
    for (let i = 0; i < points.length; i += 2) {
        box[0] = Math.min(box[0], points[i]);
        box[1] = Math.min(box[1], -points[i + 1]);
        box[2] = Math.max(box[2], points[i]);
        box[3] = Math.max(box[3], -points[i + 1]);
    }
    return { x: box[0], y: box[1], width: box[2] - box[0] || 1, height: box[3] - box[1] || 1 };
}

function clothPixels(tile, look, frame, longer) {
    const scale = longer / Math.max(frame.width, frame.height);
    const canvas = html('canvas', { width: Math.ceil(frame.width * scale), height: Math.ceil(frame.height * scale) });
    const context = canvas.getContext('2d');
    const image = makeImage(context);
    const colours = new Uint32Array(look.table.buffer);
    const { flat, triangles } = tile;
    const x = [0, 0, 0],
        y = [0, 0, 0];
    clothPlaces(tile, look).forEach((place, t) => {
        for (let k = 0; k < 3; ++k) {
            const vertex = 2 * triangles[3 * t + k];
            x[k] = (flat[vertex] * 1000 - frame.x) * scale;
            y[k] = (-flat[vertex + 1] * 1000 - frame.y) * scale;
        }
        fillTriangle(image, colours[place], x, y);
    });
    context.putImageData(image.data, 0, 0);
    return { width: canvas.width / scale, height: canvas.height / scale, href: canvas.toDataURL() };
}

// The coloured triangles; `refine`: in the finest useful resolution.
function clothPicture(...what) {
    const frame = what.at(-1);
    const picture = svg('image', { x: frame.x, y: frame.y, preserveAspectRatio: 'none' });
    const paint = (longer) => {
        for (const [name, value] of Object.entries(clothPixels(...what, longer))) picture.setAttribute(name, value);
    };
    paint(pixels.seen);
    return { picture, refine: () => paint(pixels.zoomed) };
}

function pathOf(points, isClosed) {
    let path = '';
    for (let i = 0; i < points.length; i += 2)
        path += `${i ? 'L' : 'M'}${points[i].toFixed(2)} ${(-points[i + 1]).toFixed(2)}`;
    return path + (isClosed ? 'Z' : '');
}

const inMillimetres = (points) => points.flatMap(([x, y]) => [x * 1000, y * 1000]);

function rimPicture(tile, look) {
    const shades = rimPlaces(tile, look);
    if (!shades) return [];
    const paths = new Map();
    shades.forEach((place, i) => {
        const ends = [tile.loop[i], tile.loop[(i + 1) % tile.loop.length]];
        const path = pathOf(
            ends.flatMap((v) => [tile.flat[2 * v] * 1000, tile.flat[2 * v + 1] * 1000]),
            false,
        );
        paths.set(place, (paths.get(place) ?? '') + path);
    });
    return [
        svg('path', { class: 'rim-casing', d: pathOf(outlinePoints(tile), true) }),
        ...[...paths].map(([place, d]) =>
            svg('path', {
                class: `rim${place === places.above || place === places.below ? ' beyond' : ''}`,
                d,
                stroke: cssColour(look.table, place),
            }),
        ),
    ];
}

const outlinePoints = (tile) =>
    Array.from(tile.loop).flatMap((v) => [tile.flat[2 * v] * 1000, tile.flat[2 * v + 1] * 1000]);

function grainArrow(grain) {
    if (grain.length < 4) return null;
    const [x0, y0, x1, y1] = grain;
    const length = Math.hypot(x1 - x0, y1 - y0),
        head = Math.min(40, 0.2 * length);
    const along = [(x1 - x0) / length, (y1 - y0) / length];
    const wing = (side) => [
        x1 - head * along[0] - side * 0.35 * head * along[1],
        y1 - head * along[1] + side * 0.35 * head * along[0],
    ];
    return svg(
        'path',
        { class: 'grain', d: pathOf([x0, y0, x1, y1], false) + pathOf([...wing(1), x1, y1, ...wing(-1)], false) },
        svg('title', {}, 'Grain: the warp'),
    );
}

// In their true height, but limited so that they do not hide the piece.
function labels(piece, frame) {
    const highest = 0.045 * Math.max(frame.width, frame.height);
    return piece.labels.map(({ text, at_mm: [x, y], height_mm: height, turn_deg: turn }) =>
        svg(
            'text',
            {
                x,
                y: -y,
                'font-size': Math.min(highest, height * 1.35),
                'text-anchor': 'middle',
                'dominant-baseline': 'central',
                transform: `rotate(${-turn} ${x} ${-y})`,
            },
            text,
        ),
    );
}

const proposedSeam = (tile) =>
    tile.proposed &&
    svg(
        'path',
        { class: 'proposed', d: pathOf(tile.proposed, false) },
        svg('title', {}, 'A seam that would help here'),
    );

// A ring at each finding.
function rings(tile, frame) {
    const radius = 0.018 * Math.max(frame.width, frame.height);
    return tile.rings.map(([vertex, finding]) =>
        svg(
            'circle',
            { class: 'ring', cx: tile.flat[2 * vertex] * 1000, cy: -tile.flat[2 * vertex + 1] * 1000, r: radius },
            svg('title', {}, tile.findings[finding]?.message ?? ''),
        ),
    );
}

function seamPaths(model, tile, chosenSeam, onSeam, radius) {
    return tile.sides.map((side) => {
        const points = sidePoints(tile, side, tile.flat, 2);
        const d = pathOf(inMillimetres(points), false);
        const isChosen = side.seam === chosenSeam;
        // The seam starts where its first side starts; the second side runs the other way.
        const start = isChosen && points.at(side.name === 'a' ? 0 : -1).map((value) => value * 1000);
        return [
            isChosen && svg('path', { class: 'seam-casing', d }),
            isChosen && svg('path', { class: 'seam-chosen', d }),
            isChosen && svg('circle', { class: 'start', cx: start[0], cy: -start[1], r: radius }),
            svg(
                'path',
                { class: 'seam-reach', d, 'data-seam': side.seam.id, onclick: () => onSeam(side.seam) },
                svg('title', {}, `Seam ${side.seam.id}: sewn to ${mateName(model, side)}`),
            ),
        ];
    });
}

export function mateOf(side) {
    return side.seam.sides.find((other) => other.name !== side.name);
}

export const mateName = (model, side) => (mateOf(side) ? model.tiles[mateOf(side).tile].name : 'nothing');

const framesOf = (tiles) => tiles.filter((tile) => tile.flat).map(frameOf);

// The initial view: the piece in the middle, with space for the largest piece it is compared with.
function homeOf(frame, tiles) {
    const frames = framesOf(tiles);
    const [width, height] = ['width', 'height'].map((side) => Math.max(...frames.map((other) => other[side])));
    const margin = 0.035 * Math.max(width, height);
    return [
        frame.x + (frame.width - width) / 2 - margin,
        frame.y + (frame.height - height) / 2 - margin,
        width + 2 * margin,
        height + 2 * margin,
    ];
}

// Whether two pieces fit better one below the other than side by side.
export const matesAreWide = (tiles) => framesOf(tiles).every(({ width, height }) => width > 2 * height);

// The triangle of the flat tile that contains a place [mm, y up].
export function triangleAt(tile, x, y) {
    const { flat, triangles } = tile;
    const [px, py] = [x / 1000, y / 1000];
    for (let t = 0; t < triangles.length; t += 3) {
        const [a, b, c] = [2 * triangles[t], 2 * triangles[t + 1], 2 * triangles[t + 2]];
        const turns = (i, j) => (flat[j] - flat[i]) * (py - flat[i + 1]) - (flat[j + 1] - flat[i + 1]) * (px - flat[i]);
        const [u, v, w] = [turns(a, b), turns(b, c), turns(c, a)];
        if ((u >= 0 && v >= 0 && w >= 0) || (u <= 0 && v <= 0 && w <= 0)) return t / 3;
    }
    return -1;
}

// `hover(triangle, event)`: -1 outside the cloth.
export function pieceView(model, tile, { look, chosenSeam, onSeam, hover, atScaleOf }) {
    if (!tile.flat) return html('p', { class: 'nothing' }, 'This tile could not be laid flat, so there is no piece.');
    const frame = frameOf(tile);
    const home = homeOf(frame, atScaleOf ?? [tile]);
    const { piece } = tile;
    const cloth = clothPicture(tile, look, frame);
    const drawing = svg(
        'svg',
        {
            class: 'piece',
            viewBox: home.join(' '),
            role: 'img',
            tabindex: 0,
            'aria-label': `The flat piece of ${tile.name}, ${size(frame)}`,
        },
        piece && svg('path', { class: 'allowance', d: pathOf(piece.cut, true) }),
        cloth.picture,
        rimPicture(tile, look),
        piece && [
            svg('path', { class: 'cut', d: pathOf(piece.cut, true) }),
            svg('path', { class: 'sew', d: pathOf(piece.sew, true) }),
            svg('path', { class: 'notches', d: slitPath(piece.slits) }),
            piece.lines.map((line) =>
                svg('path', { class: 'drawn', d: pathOf(line.points, false) }, svg('title', {}, line.name)),
            ),
            grainArrow(piece.grain),
            labels(piece, frame),
        ],
        proposedSeam(tile),
        !chosenSeam && rings(tile, frame),
        seamPaths(model, tile, chosenSeam, onSeam, home[2] / 70),
    );
    if (hover)
        drawing.addEventListener('pointermove', (event) => {
            const at = new DOMPoint(event.clientX, event.clientY).matrixTransform(drawing.getScreenCTM().inverse());
            hover(triangleAt(tile, at.x, -at.y), event);
        });
    return withButtons(drawing, home, tile.name, cloth.refine);
}

function slitPath(slits) {
    let path = '';
    for (let i = 0; i < slits.length; i += 4) path += pathOf(slits.slice(i, i + 4), false);
    return path;
}

export const size = (frame) => `${figure(frame.width, 0)} × ${millimetres(frame.height, 0)}`;
export const sizeOf = (tile) => size(frameOf(tile));
