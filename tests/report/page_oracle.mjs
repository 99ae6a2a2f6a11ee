// Prints what report.html's own modules make of a plan's data, as JSON, so that the tests can compare it with the
// pictures: node page_oracle.mjs APPS_REPORT_SRC REPORT_JSON SHAPES SHARES_JSON. SHAPES holds the bytes of
// `page_shapes`, SHARES the values to colour and to write.
import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { pathToFileURL } from 'node:url';

const [source, reportFile, shapesFile, sharesFile] = process.argv.slice(2);
const report = JSON.parse(readFileSync(reportFile, 'utf8')),
    shares = JSON.parse(readFileSync(sharesFile, 'utf8'));
const load = (name) => import(pathToFileURL(join(source, name)));
const [palette, maps, format, data] = await Promise.all(
    ['palette', 'maps', 'format', 'data'].map((name) => load(`view/${name}.js`)),
);

// The parts of a document that verdict and legend are written into.
class Element {
    constructor(tag) {
        Object.assign(this, { tag, children: [], classList: { add() {} } });
    }
    append(child) {
        this.children.push(child);
    }
    setAttribute() {}
    addEventListener() {}
    get textContent() {
        return this.children.map((child) => child.textContent ?? String(child)).join('');
    }
    all(tag) {
        const inner = this.children.flatMap((child) => (child.all ? child.all(tag) : []));
        return this.tag === tag ? [this, ...inner] : inner;
    }
}
globalThis.document = { createElement: (tag) => new Element(tag) };
const [{ verdictView }, { legendView }] = await Promise.all([load('tables/verdict.js'), load('view/legend.js')]);

const bytes = readFileSync(shapesFile);
const buffer = bytes.buffer.slice(bytes.byteOffset, bytes.byteOffset + bytes.length);
const model = data.modelOf(report, buffer, null);
const view = verdictView(model, { onTile() {}, onSeam() {} });
const lists = Object.fromEntries(
    view.all('section').map((section) => [
        section.all('h2')[0].textContent,
        section.all('li').map((line) => line.textContent),
    ]),
);

function painted(map, scale) {
    const look = maps.lookOf(model, { map: map.id, scale: scale?.id, palette: 'safe' });
    return {
        cloth: model.tiles.map((tile) => [...maps.clothPlaces(tile, look)]),
        edges: model.tiles.map((tile) => [...(maps.rimPlaces(tile, look) ?? [])]),
        legend: legendView(look)
            .all('span')
            .filter((span) => span.all('span').length === 1)
            .map((span) => span.textContent.trim())
            .filter(Boolean),
        note: legendView(look)
            .all('small')
            .map((small) => small.textContent)
            .join(),
    };
}

console.log(
    JSON.stringify({
        headline: view.all('h1')[0].textContent,
        why: lists.Why ?? [],
        redesign: lists['What to redesign'] ?? [],
        first: model.first,
        colours: model.palettes.map(({ table }) => [...table]),
        places: [true, false].map((beyond) => shares.map((share) => palette.placeOf(share ?? NaN, beyond))),
        figures: shares.map((share) => [format.figure(share, 2, true), format.short(1000 * (share ?? NaN))]),
        maps: model.maps.map((map) => ({
            id: map.id,
            name: map.name,
            first: painted(map), // with the initial scale
            scales: map.scales.map((scale) => painted(map, scale)),
        })),
    }),
);
