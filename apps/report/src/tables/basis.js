// The basis of the report: what the envelope was judged by and made of.
import { html } from '../view/dom.js';
import { count, figure, short } from '../view/format.js';

const row = (...cells) =>
    html(
        'tr',
        {},
        cells.map((cell, i) => (i ? html('td', {}, cell) : html('th', { scope: 'row' }, cell))),
    );

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
                row('Area of a piece', `within ±${short(tolerances.area_pct)} %`),
                row('Length of an edge, fit of a seam', `within ±${short(tolerances.length_pct)} %`),
                report.fabrics.map((fabric) =>
                    row(
                        `Fabric ${fabric.name}`,
                        `strain within ±${short(fabric.strain_limit_pct)} %, ` +
                            `shear up to ${figure(fabric.shear_limit_deg, 1)}°; ` +
                            `${count(fabric.tiles, 'tile')}, ${figure(fabric.area_m2, 2)} m²` +
                            (fabric.description ? `; ${fabric.description}` : ''),
                    ),
                ),
                report.seam_types.map((type) =>
                    row(
                        `Sewn ${type.type}`,
                        `allowance ${short(type.allowance_mm)} mm; ${count(type.seams, 'seam')}, ` +
                            `${count(type.free_edges, 'free edge')}, ${figure(type.length_mm / 1000, 1)} m`,
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
