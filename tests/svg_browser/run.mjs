// Compares the geometry that the library reads from SVG drawings with Chromium's: first the cases, then COUNT
// random drawings from SEED on: node run.mjs PRINT_PATHS [COUNT [SEED]]. Exits with 77, which CTest counts as
// skipped, if the browser or the npm packages are missing.
import { execFileSync } from 'node:child_process';
import { existsSync, mkdtempSync, rmSync, writeFileSync } from 'node:fs';
import { createRequire } from 'node:module';
import { tmpdir } from 'node:os';
import { dirname, join } from 'node:path';
import { fileURLToPath, pathToFileURL } from 'node:url';
import { cases } from './cases.mjs';
import { drawings } from './drawings.mjs';
import { measure } from './measure.mjs';

const here = dirname(fileURLToPath(import.meta.url));
const [printer, count = '100', seed = '1'] = process.argv.slice(2);
const chromium = process.env.RIPSTOP_CHROMIUM ?? '/usr/bin/chromium';

function skip(reason) {
    console.log(`skipped: ${reason}`);
    process.exit(77);
}
if (!existsSync(chromium)) skip(`no browser at ${chromium} (Debian: chromium); RIPSTOP_CHROMIUM names another`);
if (!existsSync(join(here, '../../apps/report/node_modules/playwright-core')))
    skip('no playwright-core; make setup installs it');
const { chromium: browsers } = createRequire(new URL('../../apps/report/package.json', import.meta.url))(
    'playwright-core',
);

const chordError = 0.05; // mm, or user units where the drawing has no unit
const rounding = 2e-5; // of coordinates: Chromium stores those of paths in single precision, and scales in 1/64 px
const pageRounding = 3e-5; // of coordinates on a stretched page: Chromium rounds width and height to 1/64 px
// Relative to the size of a path with arcs. Chromium draws an arc as cubics, one per quarter of an ellipse, with
// an error of up to 2.7e-4 of the radius. It also takes the square root of the remainder of 1/4 in single
// precision, so the centre of an arc that barely reaches its ends is off by up to 2^-11.5.
const arcs = 2.8e-4 + 2 ** -11.5;
// User units: the largest distance of the chords with which Chromium measures a length from the curve, 0.5 along
// both axes.
const skia = 0.5 * Math.SQRT2;
const samples = 48;

function toSegment([x, y], [ax, ay], [bx, by]) {
    const [dx, dy] = [bx - ax, by - ay];
    const square = dx * dx + dy * dy;
    const t = square > 0 ? Math.min(1, Math.max(0, ((x - ax) * dx + (y - ay) * dy) / square)) : 0;
    return Math.hypot(ax + t * dx - x, ay + t * dy - y);
}

function distance(point, lines) {
    let least = Infinity;
    for (const line of lines)
        for (let i = 0; i + 1 < line.length; ++i) least = Math.min(least, toSegment(point, line[i], line[i + 1]));
    return least;
}

const lengthOf = (line) =>
    line.slice(1).reduce((sum, point, i) => sum + Math.hypot(point[0] - line[i][0], point[1] - line[i][1]), 0);

// The total turn of a line [rad].
function turnOf(line) {
    const angles = line
        .slice(1)
        .map((point, i) => [point[0] - line[i][0], point[1] - line[i][1]])
        .filter(([x, y]) => x !== 0 || y !== 0)
        .map(([x, y]) => Math.atan2(y, x));
    return angles.slice(1).reduce((sum, angle, i) => sum + Math.acos(Math.cos(angle - angles[i])), 0);
}

function boxOf(lines) {
    const all = lines.flat();
    const along = (k) => all.map((point) => point[k]);
    return [Math.min(...along(0)), Math.min(...along(1)), Math.max(...along(0)), Math.max(...along(1))];
}

const worst = { point: 0, box: 0, total: 0 };
const counts = { shapes: 0, totals: 0, boxes: 0, texts: 0, kinds: {} };

// The faults of one shape: `lines` as read, `shape` as in Chromium; a screen px is `scale` long.
function faultsOf(lines, shape, scale, error) {
    const found = [];
    const points = shape.points.map(([x, y]) => [x * scale, y * scale]);
    const size = Math.max(1, ...points.flat().map(Math.abs));
    const [left, top, right, bottom] = boxOf(lines);
    const slack = chordError + error * size + (shape.hasArcs ? arcs * Math.hypot(right - left, bottom - top) : 0);
    for (const point of points) {
        const off = distance(point, lines);
        worst.point = Math.max(worst.point, off / slack);
        if (!(off <= slack)) return [`the point ${point} is ${off} off`];
    }
    // The whole shape: no line more than Chromium has.
    if (shape.scale !== null) {
        const total = shape.total * shape.scale * scale;
        const ours = lines.map(lengthOf).reduce((sum, length) => sum + length, 0);
        // Chords within e of a curve that turns by t are shorter than it by up to 0.341 e t. The factor is a third
        // if they are many (8/3 s²/c for each, and s/c is an eighth of its turn), and (pi/2 - sqrt 2) / (1 - sqrt
        // 1/2) / (pi/2) for one chord per quarter circle, the fewest that Chromium uses.
        const turn = lines.map(turnOf).reduce((sum, angle) => sum + angle, 0);
        const allowed =
            0.341 * (chordError + skia * shape.scale * scale) * turn +
            2 * error * Math.max(size, total) +
            (shape.hasArcs ? arcs * total : 0);
        worst.total = Math.max(worst.total, Math.abs(ours - total) / allowed);
        ++counts.totals;
        if (!(Math.abs(ours - total) <= allowed)) found.push(`its length is ${ours}, not ${total}`);
    }
    if (shape.isUpright) {
        const [a, b] = shape.corners.map(([x, y]) => [x * scale, y * scale]);
        const box = [Math.min(a[0], b[0]), Math.min(a[1], b[1]), Math.max(a[0], b[0]), Math.max(a[1], b[1])];
        const off = Math.max(...boxOf(lines).map((value, i) => Math.abs(value - box[i])));
        worst.box = Math.max(worst.box, off / slack);
        ++counts.boxes;
        if (!(off <= slack)) found.push(`its box is ${boxOf(lines)}, not ${box}`);
    }
    return found;
}

// Chromium has one shape for a path with several lines.
function grouped(paths, shapes) {
    const groups = [];
    let next = 0;
    for (const shape of shapes) {
        const own = paths.slice(next, next + shape.lines);
        next += shape.lines;
        const lines = own.map(({ points, closed }) => (closed ? [...points, points[0]] : points));
        groups.push({ shape, lines, entity: own.length === shape.lines ? own[0].entity : 'end of the file' });
    }
    return { groups, left: Math.max(0, paths.length - next) };
}

function compare(read, seen) {
    if (read.error) return [`refused: ${read.error}`];
    const found = [...seen.wrong];
    const scale = read.mm_per_unit / seen.unit.x;
    const error = Math.abs(seen.unit.y / seen.unit.x - 1) > 1e-9 ? pageRounding : rounding;
    const { groups, left } = grouped(read.paths, seen.shapes);
    if (left !== 0) found.push(`${left} lines more than Chromium draws`);
    for (const { shape, lines, entity } of groups) {
        ++counts.shapes;
        counts.kinds[shape.entity] = (counts.kinds[shape.entity] ?? 0) + 1;
        if (entity !== shape.entity)
            return [...found, `${shape.id}: a ${entity} where Chromium draws a ${shape.entity}`];
        found.push(...faultsOf(lines, shape, scale, error).map((text) => `${shape.entity} ${shape.id}: ${text}`));
    }
    if (read.texts.length !== seen.texts.length)
        return [...found, `${read.texts.length} texts, not ${seen.texts.length}`];
    read.texts.forEach((text, i) => {
        const other = seen.texts[i];
        ++counts.texts;
        const off = Math.hypot(text.at[0] - other.at[0] * scale, text.at[1] - other.at[1] * scale);
        const size = Math.max(1, ...text.at.map(Math.abs));
        if (text.text !== other.text || off > 1e-4 * size) found.push(`the text ${other.text} is ${off} off`);
        if (Math.abs(text.height - other.height * scale) > 1e-4 * size)
            found.push(`the text ${other.text} is ${text.height} high, not ${other.height * scale}`);
    });
    for (const { kind, reason, carried } of read.unread) if (!carried) found.push(`not read: ${kind} ${reason}`);
    return found;
}

const work = mkdtempSync(join(tmpdir(), 'ripstop-svg-'));
let failed = 0;
try {
    const made = drawings(Number(count), Number(seed)).map((text, i) => ({ name: `seed ${Number(seed) + i}`, text }));
    const all = [...cases, ...made];
    const files = all.map(({ text }, i) => {
        const file = join(work, `${i}.svg`);
        writeFileSync(file, text);
        return file;
    });
    const read = JSON.parse(execFileSync(printer, files, { maxBuffer: 1 << 30 }).toString());
    const browser = await browsers.launch({
        executablePath: chromium,
        headless: true,
        args: ['--no-sandbox', '--no-first-run'],
    });
    try {
        const page = await browser.newPage({ viewport: { width: 1000, height: 1000 } });
        for (const [i, file] of files.entries()) {
            await page.goto(pathToFileURL(file).href);
            const isNamed = read[i].unread?.some(({ carried }) => !carried);
            const found = all[i].isNamed
                ? isNamed
                    ? []
                    : ['nothing is named']
                : compare(read[i], await page.evaluate(measure, samples));
            if (found.length > 0) {
                ++failed;
                console.log(`${all[i].name}:\n  ${found.slice(0, 5).join('\n  ')}`);
                if (process.env.KEEP) writeFileSync(join(process.env.KEEP, `${i}.svg`), all[i].text);
            }
        }
    } finally {
        await browser.close();
    }
} finally {
    rmSync(work, { recursive: true, force: true });
}
console.log(
    `${cases.length} cases, ${count} drawings: ${JSON.stringify(counts)}; ` +
        `at most ${JSON.stringify(worst)} of what is allowed; ${failed} differ`,
);
process.exit(failed > 0 ? 1 : 0);
