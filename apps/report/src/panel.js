// What is chosen, in full: a tile with its piece and edges, or a seam with both its sides.
import { html, svg } from './dom.js';
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
} from './format.js';
import { matesAreWide, mateName, pieceView, sizeOf } from './piece_view.js';
import { verdictWord } from './verdict.js';

const pair = (name, ...value) => html('div', {}, html('dt', {}, name), html('dd', {}, value));

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

// A tile that is cut like another is divided like it.
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
        `a seam ${proposal.direction} (dashed) helps most of ${proposal.lines_tried} tried. One half: ${left(proposal.halves[0])}; the other: ${left(proposal.halves[1])}.`,
    );
}

function tilePanel(shape, tile, context) {
    const { model } = shape;
    const { said } = tile;
    const { strain } = said;
    return [
        html(
            'h2',
            {},
            html('span', { class: `mark ${tile.ok ? 'ok' : 'bad'}`, 'aria-hidden': 'true' }),
            tile.name,
            ' ',
            html('span', { class: 'verdict-word' }, verdictWord(tile)),
        ),
        tile.findings.length > 0 &&
            html(
                'ul',
                { class: 'findings' },
                tile.findings.map((finding) => html('li', {}, finding.message)),
            ),
        proposalWords(model, tile, context.onTile),
        pieceView(shape, tile, context),
        html(
            'dl',
            { class: 'figures' },
            pair('Piece', tile.flat ? sizeOf(tile) : '–', html('small', {}, patternWords(model, tile))),
            pair(
                'Area',
                squareMetres(said.area_m2, said.area_m2 < 1 ? 4 : 2),
                html('small', {}, `${percent(said.area_error_pct)} on the cloth`),
            ),
            pair(
                'Outline',
                millimetres(said.perimeter_mm),
                html('small', {}, `${percent(said.perimeter_error_pct)} on the cloth`),
            ),
            said.remeshed && drawnMesh(said),
            pair(
                'Warp strain',
                `${percent(strain.warp_min_pct)} to ${percent(strain.warp_max_pct)}`,
                html('small', {}, `limit ±${short(tile.limits.strain * 100)} %`),
            ),
            pair(
                'Weft strain',
                `${percent(strain.weft_min_pct)} to ${percent(strain.weft_max_pct)}`,
                html('small', {}, `limit ±${short(tile.limits.strain * 100)} %`),
            ),
            pair(
                'Shear',
                `up to ${degrees(strain.shear_max_deg, 2)}`,
                html('small', {}, `limit ${degrees((tile.limits.shear * 180) / Math.PI)}`),
            ),
        ),
        said.inflated && [
            html('h3', {}, 'In flight'),
            html(
                'dl',
                { class: 'figures' },
                pair(
                    'Off the drawn shape',
                    millimetres(said.inflated.deviation_rms_mm),
                    html('small', {}, `at most ${signedMillimetres(said.inflated.deviation_max_mm, 1)}`),
                ),
                pair(
                    'Tension',
                    `up to ${figure(said.inflated.stress_max_n_per_m, 1)}\u00a0N/m`,
                    html(
                        'small',
                        {},
                        `along the warp ${figure(said.inflated.stress.warp_max_n_per_m, 1)}, the weft ${figure(said.inflated.stress.weft_max_n_per_m, 1)}`,
                    ),
                ),
                pair(
                    'Wrinkled',
                    plainPercent(said.inflated.wrinkled_pct, 1),
                    html('small', {}, `${plainPercent(said.inflated.slack_pct, 1)} slack`),
                ),
            ),
        ],
        html('h3', {}, 'Sewn edges'),
        edgeList(model, tile, context.onSeam),
        said.note && html('p', { class: 'note' }, said.note),
        html(
            'p',
            { class: 'note' },
            `${said.fabric}; grain: ${said.grain.source}; ${figure(said.triangles, 0)} triangles${said.remeshed ? ' (meshed anew)' : ''}; ${said.method}`,
        ),
    ];
}

// What the input's own triangles measure, if the tile was remeshed.
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

// How far the sides are apart on the way along the seam, and what is allowed.
function driftChart(seam) {
    const { said } = seam;
    const points = [{ at_mm: 0, drift_mm: 0 }, ...said.notches, { at_mm: said.length_mm, drift_mm: said.mismatch_mm }];
    const top = 1.15 * Math.max(said.limit_mm, ...points.map((point) => Math.abs(point.drift_mm)), said.drift_max_mm);
    const x = (at) => 52 + (at / said.length_mm) * 340,
        y = (drift) => 50 - (drift / top) * 42;
    const worst = points.reduce((most, point) =>
        Math.abs(point.drift_mm) > Math.abs(most.drift_mm) ? point : most,
    );
    const number = (text, at, height, anchor) => svg('text', { x: at, y: height, 'text-anchor': anchor }, text);
    return html(
        'figure',
        { class: 'drift' },
        svg(
            'svg',
            {
                viewBox: '0 0 400 112',
                role: 'img',
                'aria-label': `The sides are at most ${figure(said.drift_max_mm, 2)} mm apart`,
            },
            svg('rect', {
                class: 'allowed',
                x: 52,
                width: 340,
                y: y(said.limit_mm),
                height: y(-said.limit_mm) - y(said.limit_mm),
            }),
            svg('line', { class: 'axis', x1: 52, x2: 392, y1: 50, y2: 50 }),
            y(0) - y(said.limit_mm) > 11
                ? [
                      number(figure(said.limit_mm, 2, true), 48, y(said.limit_mm) + 3, 'end'),
                      number('0', 48, 53, 'end'),
                      number(`${figure(-said.limit_mm, 2)} mm`, 48, y(-said.limit_mm) + 3, 'end'),
                  ]
                : number(`±${millimetres(said.limit_mm, 2)}`, 48, 53, 'end'),
            number('start', 52, 109, 'middle'),
            number(millimetres(said.length_mm, 0), 392, 109, 'end'),
            svg('polyline', {
                class: said.ok ? 'ok' : 'bad',
                points: points.map((point) => `${x(point.at_mm)},${y(point.drift_mm)}`).join(' '),
            }),
            points.slice(1, -1).map((point) => svg('circle', { cx: x(point.at_mm), cy: y(point.drift_mm), r: 2.5 })),
            svg('circle', { class: 'start', cx: x(0), cy: 50, r: 4 }),
            !said.ok &&
                number(
                    `${figure(worst.drift_mm, 2, true)} mm`,
                    Math.min(392, Math.max(90, x(worst.at_mm))),
                    y(worst.drift_mm) + (worst.drift_mm > 0 ? 14 : -8),
                    'end',
                ),
        ),
        html(
            'figcaption',
            {},
            `How far ${said.tile_a === said.tile_b ? 'the second side' : said.tile_b} is ahead along the seam, from its start (the ring, on both pieces too) on, from notch to notch; the band is what is allowed, ±${millimetres(said.limit_mm, 2)}.`,
        ),
    );
}

function seamWord(said) {
    if (!said.ok) return 'does not fit';
    return said.certain ? 'fits' : 'fits, as far as the meshes can tell';
}

function seamPanel(shape, seam, context) {
    const { model } = shape;
    const { said } = seam;
    const tiles = [...new Set(seam.sides.map((side) => model.tiles[side.tile]))]; // one where it is sewn to itself
    const link = (tile) => html('button', { class: 'link', onclick: () => context.onTile(tile) }, tile.name);
    return [
        html(
            'h2',
            {},
            html('span', { class: `mark ${seam.ok ? 'ok' : 'bad'}`, 'aria-hidden': 'true' }),
            `Seam ${seam.id}`,
            ' ',
            html('span', { class: 'verdict-word' }, seamWord(said)),
        ),
        html(
            'p',
            {},
            tiles.length > 1
                ? ['Between ', link(tiles[0]), ' and ', link(tiles[1]), '.']
                : [link(tiles[0]), ' is sewn to itself.'],
        ),
        html(
            'dl',
            { class: 'figures' },
            pair('As drawn', millimetres(said.length_mm)),
            pair(`On ${said.tile_a}, edge ${said.chain_a}`, millimetres(said.flat_a_mm)),
            pair(`On ${said.tile_b}, edge ${said.chain_b}`, millimetres(said.flat_b_mm)),
            pair(
                'Mismatch',
                html('span', { class: said.ok ? 'ok' : 'bad' }, signedMillimetres(said.mismatch_mm)),
                html('small', {}, percent(said.mismatch_pct)),
            ),
            pair(
                'Farthest apart',
                millimetres(said.drift_max_mm, 2),
                html(
                    'small',
                    {},
                    `at ${millimetres(said.drift_max_at_mm, 0)}; allowed ${millimetres(said.limit_mm, 2)}`,
                ),
            ),
            pair(
                'Sewn',
                said.type,
                html('small', {}, `allowance ${short(said.allowance_a_mm)} and ${short(said.allowance_b_mm)} mm`),
            ),
        ),
        said.further_tiles && html('p', {}, `One seam with ${said.further_tiles.join(' and ')}, sewn into it.`),
        said.sewn_into && html('p', {}, `${said.tile_a} is sewn into seam ${said.sewn_into}: one seam, notches on all.`),
        said.tape_cut_mm !== undefined &&
            html(
                'dl',
                { class: 'figures' },
                pair('Load tape, cut', millimetres(said.tape_cut_mm), html('small', {}, 'at rest')),
                said.tape_force_max_n !== undefined &&
                    pair('In flight it bears', `up to ${figure(said.tape_force_max_n, 0)}\u00a0N`),
            ),
        !said.certain &&
            html(
                'p',
                { class: 'note' },
                `The meshes leave ${millimetres(said.uncertainty_mm, 2)} of its length open; finer ones would make it certain.`,
            ),
        driftChart(seam),
        html(
            'div',
            { class: `mates${matesAreWide(tiles) ? ' wide' : ''}` },
            tiles.map((tile) =>
                html(
                    'figure',
                    {},
                    html('figcaption', {}, tile.name),
                    pieceView(shape, tile, { ...context, chosenSeam: seam, atScaleOf: tiles }),
                ),
            ),
        ),
    ];
}

function nothingChosen(model) {
    const patterns = model.tiles.filter((tile) => !tile.said.equal_to && !tile.said.mirror_of).length;
    return [
        html('h2', { class: 'screen-only' }, 'Choose a tile or a seam'),
        html('p', { class: 'screen-only' }, 'Click one in the picture, or choose it in the list. Its piece is shown here as it is cut.'),
        html(
            'dl',
            { class: 'figures' },
            pair(
                'Tiles',
                figure(model.tiles.length, 0),
                html('small', {}, patterns < model.tiles.length ? `of ${figure(patterns, 0)} patterns` : ''),
            ),
            pair('Seams', figure(model.seams.length, 0)),
            pair('Cloth', squareMetres(model.report.envelope.area_m2)),
        ),
        html('h3', {}, 'In the piece'),
        html(
            'ul',
            { class: 'key' },
            html('li', {}, html('i', { class: 'key-cut' }), 'cut line'),
            html('li', {}, html('i', { class: 'key-sew' }), 'sew line'),
            html('li', {}, html('i', { class: 'key-notch' }), 'notches: the same places on both pieces'),
            html('li', {}, html('i', { class: 'key-grain' }), 'grain: the warp'),
            html('li', {}, html('i', { class: 'key-proposed' }), 'a seam that would help'),
        ),
    ];
}

export function panelContent(shape, state, context) {
    const { model } = shape;
    const { chosen } = state;
    if (!chosen) return nothingChosen(model);
    if (chosen.kind === 'tile') return tilePanel(shape, model.tiles[chosen.index], context);
    return seamPanel(shape, model.seams[chosen.index], context);
}

// One sentence for those who hear and do not see.
export function spoken(model, chosen) {
    if (!chosen) return 'Nothing chosen';
    if (chosen.kind === 'tile') {
        const tile = model.tiles[chosen.index];
        return `Tile ${tile.name}, ${verdictWord(tile)}, area error ${plainPercent(tile.said.area_error_pct, 2)}, ${tile.sides.length} sewn edges`;
    }
    const { said, id } = model.seams[chosen.index];
    return `Seam ${id} between ${said.tile_a} and ${said.tile_b}, ${seamWord(said)}, mismatch ${signedMillimetres(said.mismatch_mm)}`;
}
