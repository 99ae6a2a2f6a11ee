// The chosen tile: its verdict, its piece, its figures and its seams.
import { html } from '../view/dom.js';
import {
    count,
    degrees,
    figure,
    millimetres,
    percent,
    plainPercent,
    short,
    signedMillimetres,
    squareMetres,
} from '../view/format.js';
import { verdictWord } from '../tables/verdict.js';
import { figureList, judgedHeading, pair } from './figure_list.js';
import { mateName, pieceView, sizeOf } from './piece_view.js';

function patternWords(model, tile) {
    const { equal_to: equal, mirror_of: mirror, quantity, quantity_mirrored: turned } = tile.said;
    if (equal) return `cut like ${equal}`;
    if (mirror) return `cut like ${mirror}, turned over`;
    const copies = [quantity > 1 && `${quantity} cut alike`, turned > 0 && `${turned} turned over`].filter(Boolean);
    return copies.join(', ') || 'cut once';
}

function edgeList(model, tile, onSeam) {
    if (tile.sides.length === 0) return html('p', {}, 'No edge of this tile is sewn to another.');
    return html(
        'ul',
        { class: 'edges' },
        tile.sides.map((side) => {
            const { said } = side.seam;
            const own = side.name === 'a' ? said.flat_a_mm : said.flat_b_mm;
            const other = side.name === 'a' ? said.flat_b_mm : said.flat_a_mm;
            return html(
                'li',
                {},
                html('button', { class: 'link', onclick: () => onSeam(side.seam) }, side.seam.id),
                ` to ${mateName(model, side)}: ${millimetres(own)}, its mate ${millimetres(other)} `,
                html('span', { class: said.ok ? 'ok' : 'bad' }, `(${signedMillimetres(own - other)})`),
            );
        }),
    );
}

// A tile that is cut like another one has the same proposal.
function proposalWords(model, tile, onTile) {
    const { proposal, equal_to: equal, mirror_of: mirror } = tile.said;
    const like = proposal ? null : model.tiles.find(({ name, said }) => said.proposal && name === (equal ?? mirror));
    if (like)
        return html(
            'p',
            { class: 'proposal' },
            html('b', {}, 'To redesign: '),
            'divide it as is proposed for ',
            html('button', { class: 'link', onclick: () => onTile(like) }, like.name),
            mirror ? ', turned over.' : ', which is cut alike.',
        );
    if (!proposal) return null;
    const left = (half) =>
        half.verdict.findings.length === 0
            ? 'can be made'
            : `${count(half.verdict.findings.length, 'finding')} left, area ${percent(half.area_error_pct)}`;
    return html(
        'p',
        { class: 'proposal' },
        html('b', {}, 'To redesign: '),
        `a seam ${proposal.direction} (dashed) helps most of ${proposal.lines_tried} tried. ` +
            `One half: ${left(proposal.halves[0])}; the other: ${left(proposal.halves[1])}.`,
    );
}

// The measures of the input's own triangles, if the tile was remeshed.
function drawnMesh(said) {
    const { area_before_m2, flat_area_change_pct, perimeter_before_mm, distance_max_mm } = said.remeshed;
    return pair(
        'Drawn mesh',
        `${squareMetres(area_before_m2, area_before_m2 < 1 ? 4 : 2)}, outline ${millimetres(perimeter_before_mm)}`,
        html(
            'small',
            {},
            `area ${percent(flat_area_change_pct)} on the cloth; `,
            `the new mesh lies up to ${figure(distance_max_mm, 2)}\u00a0mm from it`,
        ),
    );
}

// From the minimum to the maximum, if they differ.
function rangeWords(least, most) {
    if (Math.max(Math.abs(least), Math.abs(most)) < 0.005) return 'below 0.01\u00a0%';
    return `${percent(least)} to ${percent(most)}`;
}

function pieceFigures(model, tile) {
    const { said, limits } = tile;
    const { strain } = said;
    const strainLimit = html('small', {}, `limit ±${short(limits.strain * 100)} %`);
    const onCloth = (error) => html('small', {}, `${percent(error)} on the cloth`);
    return figureList(
        pair('Piece', tile.flat ? sizeOf(tile) : '–', html('small', {}, patternWords(model, tile))),
        pair('Area', squareMetres(said.area_m2, said.area_m2 < 1 ? 4 : 2), onCloth(said.area_error_pct)),
        pair('Outline', millimetres(said.perimeter_mm), onCloth(said.perimeter_error_pct)),
        said.remeshed && drawnMesh(said),
        pair('Warp strain', rangeWords(strain.warp_min_pct, strain.warp_max_pct), strainLimit),
        pair('Weft strain', rangeWords(strain.weft_min_pct, strain.weft_max_pct), strainLimit.cloneNode(true)),
        pair(
            'Shear',
            `up to ${degrees(strain.shear_max_deg, 2)}`,
            html('small', {}, `limit ${degrees((limits.shear * 180) / Math.PI)}`),
        ),
    );
}

function flightFigures({ inflated }) {
    if (!inflated) return null;
    const { warp_max_n_per_m: warp, weft_max_n_per_m: weft } = inflated.stress;
    return [
        html('h3', {}, 'In flight'),
        figureList(
            pair(
                'Off the drawn shape',
                millimetres(inflated.deviation_rms_mm),
                html('small', {}, `at most ${signedMillimetres(inflated.deviation_max_mm, 1)}`),
            ),
            pair(
                'Tension',
                `up to ${figure(inflated.stress_max_n_per_m, 1)}\u00a0N/m`,
                html('small', {}, `along the warp ${figure(warp, 1)}, the weft ${figure(weft, 1)}`),
            ),
            pair(
                'Wrinkled',
                plainPercent(inflated.wrinkled_pct, 1),
                html('small', {}, `${plainPercent(inflated.slack_pct, 1)} slack`),
            ),
        ),
    ];
}

function madeOf(said) {
    const mesh = `${figure(said.triangles, 0)} triangles${said.remeshed ? ' (meshed anew)' : ''}`;
    return `${said.fabric}; grain: ${said.grain.source}; ${mesh}; ${said.method}`;
}

export function tilePanel(model, tile, context) {
    const { said, findings } = tile;
    return [
        judgedHeading(tile.ok, tile.name, verdictWord(tile)),
        findings.length > 0 &&
            html(
                'ul',
                { class: 'findings' },
                findings.map((finding) => html('li', {}, finding.message)),
            ),
        proposalWords(model, tile, context.onTile),
        pieceView(model, tile, context),
        pieceFigures(model, tile),
        flightFigures(said),
        html('h3', {}, 'Sewn edges'),
        edgeList(model, tile, context.onSeam),
        said.note && html('p', { class: 'note' }, said.note),
        html('p', { class: 'note' }, madeOf(said)),
    ];
}
