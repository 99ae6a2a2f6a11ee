// What report.html's own modules say of a plan, as JSON, for the tests to compare with:
// node page_oracle.mjs APPS_REPORT_SRC FILE. FILE holds {report, limits: [{strain, shear} a tile],
// tension: [[N a boundary edge] a tile], shares: [values to colour]}.
import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { pathToFileURL } from 'node:url';

const [source, file] = process.argv.slice(2);
const { report, limits, tension, shares } = JSON.parse(readFileSync(file, 'utf8'));
const load = (name) => import(pathToFileURL(join(source, name)));
const [palette, maps, format] = await Promise.all(['view/palette.js', 'view/maps.js', 'view/format.js'].map(load));

// As much of a document as the verdict is written into.
class Element {
    constructor(tag) {
        Object.assign(this, { tag, children: [] });
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
const { verdictView } = await load('tables/verdict.js');

const model = {
    report,
    tiles: report.tiles.map((said, i) => ({
        said,
        name: said.name,
        ok: said.verdict.manufacturable,
        findings: said.verdict.findings,
        limits: limits[i],
        tension: tension[i].length > 0 ? { values: tension[i], step: 1 } : null,
        maps: {},
    })),
    seams: report.seams.map((said) => ({ said, id: said.id, ok: said.ok })),
};
const view = verdictView(model, { onTile() {}, onSeam() {} });
const lists = Object.fromEntries(
    view.all('section').map((section) => [
        section.all('h2')[0].textContent,
        section.all('li').map((line) => line.textContent),
    ]),
);
console.log(
    JSON.stringify({
        headline: view.all('h1')[0].textContent,
        why: lists.Why ?? [],
        redesign: lists['What to redesign'] ?? [],
        colours: [...palette.paletteTable('safe')],
        places: shares.map((share) => palette.placeOf(share ?? NaN)),
        figures: shares.map((share) => [format.figure(share, 2, true), format.short(1000 * (share ?? NaN))]),
        maps: maps.maps.filter(({ inFlight }) => !inFlight).map((map) => {
            const { low, high, note, pinned } = maps.legend(model, map);
            return {
                id: map.id,
                words: [map.name, map.negative, map.positive],
                kinds: [Boolean(map.cloth), Boolean(map.rim), Boolean(map.unsigned)],
                legend: [low, high, note],
                pinned,
            };
        }),
    }),
);
