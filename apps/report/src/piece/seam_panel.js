// The chosen seam: its verdict, its figures, the distance between its sides, and both pieces.
import { html } from '../view/dom.js';
import { figure, millimetres, percent, short, signedMillimetres } from '../view/format.js';
import { driftChart } from './drift_chart.js';
import { figureList, judgedHeading, pair } from './figure_list.js';
import { matesAreWide, pieceView } from './piece_view.js';

export function seamWord(said) {
    if (!said.ok) return 'does not fit';
    return said.certain ? 'fits' : 'fits, as far as the meshes can tell';
}

function seamFigures(said) {
    return figureList(
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
            html('small', {}, `at ${millimetres(said.drift_max_at_mm, 0)}; allowed ${millimetres(said.limit_mm, 2)}`),
        ),
        pair(
            'Sewn',
            said.type,
            html('small', {}, `allowance ${short(said.allowance_a_mm)} and ${short(said.allowance_b_mm)} mm`),
        ),
    );
}

function tapeFigures(said) {
    if (said.tape_cut_mm === undefined) return null;
    return figureList(
        pair('Load tape, cut', millimetres(said.tape_cut_mm), html('small', {}, 'at rest')),
        said.tape_force_max_n !== undefined &&
            pair('In flight it bears', `up to ${figure(said.tape_force_max_n, 0)}\u00a0N`),
    );
}

export function seamPanel(model, seam, context) {
    const { said } = seam;
    const tiles = [...new Set(seam.sides.map((side) => model.tiles[side.tile]))]; // one where it is sewn to itself
    const link = (tile) => html('button', { class: 'link', onclick: () => context.onTile(tile) }, tile.name);
    const between =
        tiles.length > 1
            ? ['Between ', link(tiles[0]), ' and ', link(tiles[1]), '.']
            : [link(tiles[0]), ' is sewn to itself.'];
    return [
        judgedHeading(seam.ok, `Seam ${seam.id}`, seamWord(said)),
        html('p', {}, between),
        seamFigures(said),
        said.further_tiles && html('p', {}, `One seam with ${said.further_tiles.join(' and ')}, sewn into it.`),
        said.sewn_into &&
            html('p', {}, `${said.tile_a} is sewn into seam ${said.sewn_into}: one seam, notches on all.`),
        tapeFigures(said),
        !said.certain &&
            html(
                'p',
                { class: 'note' },
                `The meshes leave ${millimetres(said.uncertainty_mm, 2)} of its length uncertain; ` +
                    `finer meshes would make it certain.`,
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
                    pieceView(model, tile, { ...context, chosenSeam: seam, atScaleOf: tiles }),
                ),
            ),
        ),
    ];
}
