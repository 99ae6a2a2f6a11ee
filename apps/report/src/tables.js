// Tables of all tiles and seams: sorted by any column, the first rows shown until more are asked for.
import { html } from './dom.js';
import { count, degrees, figure, percent, signedMillimetres } from './format.js';
import { meaning } from './verdict.js';

const firstRows = 100;

const largest = (...values) => values.reduce((worst, value) => (Math.abs(value) > Math.abs(worst) ? value : worst), 0);
const codes = (model, tile) => [...new Set(tile.findings.map(({ code }) => meaning(model, code)))].join(', ');
const worstEdge = (tile) => largest(...tile.said.chains.map((chain) => chain.error_pct ?? NaN));

const tileColumns = (model) => [
    { name: 'Tile', value: (tile) => tile.name, isName: true },
    { name: 'Verdict', value: (tile) => (tile.ok ? 'can be made' : codes(model, tile) || 'not judged'), isVerdict: true },
    {
        name: 'Cut like',
        value: (tile) => tile.said.equal_to ?? (tile.said.mirror_of ? `${tile.said.mirror_of}, turned over` : ''),
    },
    { name: 'Area m²', value: (tile) => tile.said.area_m2, show: (value) => figure(value, 3) },
    { name: 'Area error', value: (tile) => tile.said.area_error_pct, show: (value) => percent(value) },
    { name: 'Worst edge', value: worstEdge, show: (value) => percent(value) },
    {
        name: 'Warp strain',
        value: (tile) => largest(tile.said.strain.warp_min_pct, tile.said.strain.warp_max_pct),
        show: (value) => percent(value),
    },
    {
        name: 'Weft strain',
        value: (tile) => largest(tile.said.strain.weft_min_pct, tile.said.strain.weft_max_pct),
        show: (value) => percent(value),
    },
    { name: 'Shear', value: (tile) => tile.said.strain.shear_max_deg, show: (value) => degrees(value, 2) },
];

const seamColumns = [
    { name: 'Seam', value: (seam) => seam.id, isName: true },
    {
        name: 'Verdict',
        value: (seam) => (seam.ok ? (seam.said.certain ? 'fits' : 'fits, not certain') : 'does not fit'),
        isVerdict: true,
    },
    { name: 'Between', value: (seam) => seam.said.tile_a },
    { name: 'and', value: (seam) => seam.said.tile_b },
    { name: 'As drawn mm', value: (seam) => seam.said.length_mm, show: (value) => figure(value, 1) },
    { name: 'On the first', value: (seam) => seam.said.flat_a_mm, show: (value) => figure(value, 1) },
    { name: 'On the second', value: (seam) => seam.said.flat_b_mm, show: (value) => figure(value, 1) },
    { name: 'Mismatch', value: (seam) => seam.said.mismatch_mm, show: (value) => signedMillimetres(value) },
    { name: 'Farthest apart mm', value: (seam) => seam.said.drift_max_mm, show: (value) => figure(value, 2) },
    { name: 'Allowed mm', value: (seam) => seam.said.limit_mm, show: (value) => figure(value, 2) },
];

const flightColumns = [
    {
        name: 'Off drawn mm',
        value: (tile) => tile.said.inflated.deviation_max_mm,
        show: (value) => signedMillimetres(value, 1),
    },
    { name: 'Tension N/m', value: (tile) => tile.said.inflated.stress_max_n_per_m, show: (value) => figure(value, 1) },
];
const tapeColumns = [
    { name: 'Tape cut mm', value: (seam) => seam.said.tape_cut_mm ?? 0, show: (value) => figure(value || NaN, 1) },
    {
        name: 'Tape bears N',
        value: (seam) => seam.said.tape_force_max_n ?? -1,
        show: (value) => figure(value < 0 ? NaN : value, 0),
    },
];

const collator = new Intl.Collator('en', { numeric: true });

// By size where figures have signs: the worst is what one looks for.
function ordered(items, { value }, descending) {
    const key = (item) => value(item);
    const sorted = items.toSorted((one, other) => {
        const [a, b] = [key(one), key(other)];
        if (typeof a === 'string') return collator.compare(a, b);
        return Math.abs(a ?? Infinity) - Math.abs(b ?? Infinity);
    });
    return descending ? sorted.reverse() : sorted;
}

function table(id, title, items, columns, onItem) {
    let sorting = null,
        descending = false,
        wanted = '',
        isWhole = false;
    const body = html('tbody');
    const more = html('button', {
        class: 'more',
        onclick: () => {
            isWhole = true;
            fill();
        },
    });
    const heads = columns.map((column) =>
        html('th', { scope: 'col' }, html('button', { onclick: () => sortBy(column) }, column.name)),
    );

    function row(item) {
        return html(
            'tr',
            { class: item.ok ? null : 'fails' },
            columns.map((column) => {
                const value = column.value(item);
                if (column.isName)
                    return html(
                        'th',
                        { scope: 'row' },
                        html('button', { class: 'link', onclick: () => onItem(item) }, value),
                    );
                if (column.isVerdict)
                    return html(
                        'td',
                        {},
                        html('span', { class: `mark ${item.ok ? 'ok' : 'bad'}`, 'aria-hidden': 'true' }),
                        value,
                    );
                return html('td', { class: column.show ? 'number' : null }, column.show ? column.show(value) : value);
            }),
        );
    }
    const heading = html('h2');
    const all = count(items.length, title === 'Tiles' ? 'tile' : 'seam');
    function fill() {
        const texts = columns.filter((column) => !column.show);
        let rows = items.filter((item) =>
            texts.some((column) => String(column.value(item)).toLowerCase().includes(wanted)),
        );
        if (sorting) rows = ordered(rows, sorting, descending);
        const shown = isWhole ? rows : rows.slice(0, firstRows);
        body.replaceChildren(...shown.map(row));
        heading.textContent = `${title} (${rows.length < items.length ? `${figure(rows.length, 0)} of ${all}` : all})`;
        more.textContent = `Show all ${rows.length}`;
        more.hidden = shown.length === rows.length;
        heads.forEach((head, i) => {
            if (columns[i] === sorting) head.setAttribute('aria-sort', descending ? 'descending' : 'ascending');
            else head.removeAttribute('aria-sort');
        });
    }
    function sortBy(column) {
        descending = sorting === column ? !descending : Boolean(column.show);
        sorting = column;
        fill();
    }
    fill();
    return {
        element: html(
            'section',
            { class: 'table', id, 'aria-label': title },
            heading,
            html(
                'div',
                { class: 'scroll', tabindex: '0', role: 'region', 'aria-label': `Table of ${title.toLowerCase()}` },
                html('table', {}, html('thead', {}, html('tr', {}, heads)), body),
            ),
            more,
        ),
        search(text) {
            wanted = text.toLowerCase();
            fill();
        },
        showWhole(whole) {
            isWhole = whole;
            fill();
        },
    };
}

export function tileTable(model, onTile) {
    const columns = model.report.inflated ? [...tileColumns(model), ...flightColumns] : tileColumns(model);
    return table('tiles', 'Tiles', model.tiles, columns, onTile);
}

export function seamTable(model, onSeam) {
    const hasTapes = model.seams.some((seam) => seam.said.tape_cut_mm !== undefined);
    return table('seams', 'Seams', model.seams, hasTapes ? [...seamColumns, ...tapeColumns] : seamColumns, onSeam);
}

const row = (...cells) =>
    html(
        'tr',
        {},
        cells.map((cell, i) => (i ? html('td', {}, cell) : html('th', { scope: 'row' }, cell))),
    );

// What it was judged by and made of.
export function basis(model) {
    const { report } = model;
    const { tolerances, input } = report;
    return html(
        'section',
        { class: 'basis', 'aria-label': 'What it was judged by' },
        html('h2', {}, 'What it was judged by'),
        html(
            'table',
            {},
            html(
                'tbody',
                {},
                row('Area of a piece', `within ±${tolerances.area_pct} %`),
                row('Length of an edge, fit of a seam', `within ±${tolerances.length_pct} %`),
                report.fabrics.map((fabric) =>
                    row(
                        `Fabric ${fabric.name}`,
                        `strain within ±${fabric.strain_limit_pct} %, shear up to ${figure(fabric.shear_limit_deg, 1)}°; ${count(fabric.tiles, 'tile')}, ${figure(fabric.area_m2, 2)} m²${fabric.description ? `; ${fabric.description}` : ''}`,
                    ),
                ),
                report.seam_types.map((type) =>
                    row(
                        `Sewn ${type.type}`,
                        `allowance ${type.allowance_mm} mm; ${count(type.seams, 'seam')}, ${count(type.free_edges, 'free edge')}, ${figure(type.length_mm / 1000, 1)} m`,
                    ),
                ),
                row('Input', `${input.file}, unit ${input.unit}, SHA-256 ${input.sha256}`),
                row(
                    'Made by',
                    `Ripstop ${report.ripstop}. All figures: report.json, tiles.csv and seams.csv beside this page.`,
                ),
            ),
        ),
    );
}
