// The envelope in flight: the results in words and in tables.
import { html } from '../view/dom.js';
import { figure, millimetres, percent, plainPercent, short, signedMillimetres } from '../view/format.js';

export const says = (model) => model.report.inflated?.says ?? [];

// Figures are aligned right under headings with their unit; the first column and the last `words` columns are aligned
// left.
function table(caption, heads, rows, words = 0) {
    const align = (i) => (i > 0 && i < heads.length - words ? 'number' : null);
    const cell = (value, i) =>
        i === 0 ? html('th', { scope: 'row' }, value) : html('td', { class: align(i) }, value);
    return html(
        'div',
        { class: 'wide', tabindex: '0', role: 'region', 'aria-label': caption },
        html(
            'table',
            {},
            html('caption', {}, caption),
            html(
                'thead',
                {},
                html(
                    'tr',
                    {},
                    heads.map((head, i) => html('th', { scope: 'col', class: align(i) }, head)),
                ),
            ),
            html(
                'tbody',
                {},
                rows.map((row) => html('tr', { class: row.fails ? 'fails' : null }, row.values.map(cell))),
            ),
        ),
    );
}

const mark = (ok) => html('span', { class: `mark ${ok ? 'ok' : 'bad'}`, 'aria-hidden': 'true' });

function sizes(said) {
    const row = (name, drawn, there, unit, decimals) => ({
        values: [
            name,
            `${figure(drawn, decimals)}\u00a0${unit}`,
            `${figure(there, decimals)}\u00a0${unit}`,
            `${figure(there - drawn, decimals, true)}\u00a0${unit}`,
            percent(100 * (there / drawn - 1)),
        ],
    });
    return table(
        'Sizes',
        ['Of the whole', 'As drawn', 'Inflated', 'More by', 'Share'],
        [
            row('Height', said.drawn_height_mm, said.height_mm, 'mm', 0),
            row('Diameter', said.drawn_diameter_mm, said.diameter_mm, 'mm', 0),
            row('Volume', said.drawn_volume_m3, said.volume_m3, 'm³', 1),
        ],
    );
}

function strength(said) {
    if (said.safety.length === 0) return null;
    return table(
        'Strength',
        ['Part', 'Bears', 'Breaks at', 'Counted on', 'Factor', 'Asked', 'Where'],
        said.safety.map((each) => {
            const unit = each.load_n === undefined ? 'N/m' : 'N';
            return {
                fails: !each.ok,
                values: [
                    [mark(each.ok), each.part, html('span', { class: 'unseen' }, each.ok ? '' : ', too weak')],
                    `${figure(each.load_n ?? each.load_n_per_m, 1)}\u00a0${unit}`,
                    `${figure(each.strength_n ?? each.strength_n_per_m, 0)}\u00a0${unit}`,
                    plainPercent(100 * each.knock_down, 0),
                    figure(each.factor, 2),
                    short(each.required),
                    each.where,
                ],
            };
        }),
        1,
    );
}

function causes(said) {
    if (!said.causes) return null;
    const limit = said.deviation_limit_mm;
    const row = (name, value) => ({
        fails: value > limit,
        values: [
            [mark(!(value > limit)), name],
            millimetres(value),
            value === null ? 'not known' : `${value > limit ? 'more than' : 'within'} 0.3 % of the height`,
        ],
    });
    return table(
        'Why it is off',
        ['Cause', 'Moves it by', 'That is'],
        [
            row('The shape: gas pressure cannot hold it', said.causes.shape_mm),
            row('The stretch of cloth and tapes', said.causes.stretch_mm),
            row('The patterns: errors of the pieces as cut', said.causes.patterns_mm),
        ],
        1,
    );
}

const offHeads = ['Off mm, rms', 'at most', 'Moved mm, rms', 'at most', 'Height mm', 'Volume m³'];
const offCells = (each) => [
    figure(each.deviation_rms_mm, 1),
    figure(each.deviation_max_mm, 1, true),
    figure(each.moved_rms_mm, 1),
    figure(each.moved_max_mm, 1),
    figure(each.height_mm, 0),
    figure(each.volume_m3, 1),
];

function rounds(said) {
    if (said.rounds.length === 0) return null;
    return table(
        'How the patterns were corrected',
        ['Round', ...offHeads, 'Taken'],
        said.rounds.map((each, i) => ({
            values: [`${i + 1} ${each.step}`, ...offCells(each), each.best ? 'yes' : ''],
        })),
        1,
    );
}

function sensitivity(said) {
    if (said.sensitivity.length === 0) return null;
    return table(
        'If the assumptions were different',
        ['With', ...offHeads],
        said.sensitivity.map((each) => ({ values: [each.what, ...offCells(each)] })),
    );
}

const pair = (name, value, small) =>
    html('div', {}, html('dt', {}, name), html('dd', {}, value, small && html('small', {}, small)));

function figures(model, said, onTile) {
    const worst = model.tiles.find((tile) => tile.name === said.stress_max_tile);
    return html(
        'dl',
        { class: 'figures' },
        pair(
            'Off the drawn shape',
            millimetres(said.deviation_rms_mm),
            `root mean square; at most ${signedMillimetres(said.deviation_max_mm, 1)}`,
        ),
        pair('Moved from its place', millimetres(said.moved_rms_mm), `at most ${millimetres(said.moved_max_mm)}`),
        pair(
            'Lift',
            `${figure(said.lift_n, 0)}\u00a0N`,
            `${figure(said.lift_n / 9.80665, 0)} kg beside ` +
                `its own ${figure(said.cloth_mass_kg + said.tape_mass_kg, 1)} kg`,
        ),
        pair(
            'Tension of the cloth',
            `${figure(said.stress_max_n_per_m, 1)}\u00a0N/m`,
            worst && ['at most, on ', html('button', { class: 'link', onclick: () => onTile(worst) }, worst.name)],
        ),
        said.tape_force_max_n > 0 &&
            pair('Force in load tapes', `${figure(said.tape_force_max_n, 0)}\u00a0N`, 'at most'),
        pair('Wrinkled', plainPercent(said.wrinkled_pct, 1), `of the cloth; ${plainPercent(said.slack_pct, 1)} slack`),
    );
}

function basis(said) {
    const { load } = said;
    const air = `${figure(load.inside_c, 0)} °C inside, ${figure(load.outside_c, 0)} °C outside, ` +
        `${figure(load.altitude_m, 0)} m up`;
    const extra = load.extra_pressure_pa ? `, ${figure(load.extra_pressure_pa, 0)} Pa more everywhere` : '';
    const sectors = said.sectors > 1 ? `; one of ${said.sectors} equal sectors was computed` : '';
    return html(
        'p',
        { class: 'note' },
        `${air}${extra}: ${figure(load.crown_pressure_pa, 1)} Pa at the top. ` +
            `Solved: ${said.stop}, ${said.stop_reason}${sectors}. `,
        'Factors after CS 31HB.25 and 14 CFR 31.25, with a limit load of 1.4.',
    );
}

export function flightView(model, onTile) {
    const said = model.report.inflated;
    if (!said) return null;
    return html(
        'section',
        { class: 'flight', id: 'flight', 'aria-label': 'In flight' },
        html('h2', {}, 'In flight'),
        html(
            'ul',
            {},
            says(model).map((sentence) => html('li', {}, sentence)),
        ),
        figures(model, said, onTile),
        html(
            'div',
            { class: 'flight-tables' },
            [sizes, causes, strength, rounds, sensitivity].map((make) => make(said)),
        ),
        basis(said),
    );
}
