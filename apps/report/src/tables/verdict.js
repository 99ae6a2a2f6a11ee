// The verdict: whether the envelope can be made, its faults, and what to redesign. The words come from envelope.says in
// report.json, which all outputs share; here the names of tiles and seams in them become links.
import { html } from '../view/dom.js';
import { says as saysOfFlight } from './flight_view.js';
import { count, figure } from '../view/format.js';

const mostWarnings = 4; // the rest are among the notes

const mostSaid = 5; // of what is said of the flight; the section about it has all

export function verdictWord(tile) {
    if (tile.ok) return 'can be made';
    return tile.findings.length === 0 ? 'not judged' : 'cannot be made as drawn';
}

export const failingTiles = (model) => model.tiles.filter((tile) => !tile.ok);
export const failingSeams = (model) => model.seams.filter((seam) => !seam.ok);

// The meaning of a finding's code for a maker.
export const meaning = (model, code) => model.report.envelope.says.codes[code] ?? code;

// The headline's text on the flight; null if the envelope flies as drawn or was not inflated.
function flightWord(said) {
    if (!said) return null;
    if (!said.converged) return ' How it flies is not known.';
    if (!(said.lift_n > 0 && said.volume_m3 > 0.5 * said.drawn_volume_m3)) return ' It does not stand.';
    if (said.deviation_rms_mm > said.deviation_limit_mm) return ' It does not fly as drawn.';
    return said.safe ? null : ' It is too weak.';
}

// For a plan that was laid on the roll: the number of pieces that did not fit.
export function notLaid(roll) {
    const refused = roll?.refused.reduce((sum, { quantity }) => sum + quantity, 0) ?? 0;
    const laid = roll?.markers.reduce((sum, { placements }) => sum + placements.length, 0) ?? 0;
    return { refused, all: refused + laid };
}

function rollWords({ refused, all }) {
    return ` But ${figure(refused, 0)} of ${count(all, 'piece')} ${refused === 1 ? 'does' : 'do'} not fit the roll.`;
}

const lines = (texts, attributes) =>
    html(
        'ul',
        attributes,
        texts.map((text) => html('li', {}, text)),
    );

// Sentences made of parts: texts, { tile: name } and { seam: id }.
function sentences(title, said, linkOf) {
    if (said.length === 0) return null;
    const texts = said.map((parts) => parts.map((part) => (typeof part === 'string' ? part : linkOf(part))));
    return html('section', {}, html('h2', {}, title), lines(texts));
}

export function verdictView(model, { onTile, onSeam }) {
    const { report } = model;
    const { manufacturable: good, says, warnings } = report.envelope;
    const unlaid = notLaid(model.roll);
    const flaw = flightWord(report.inflated);
    const linkOf = ({ tile, seam }) => {
        const open = () =>
            tile === undefined
                ? onSeam(model.seams.find(({ id }) => id === seam))
                : onTile(model.tiles.find(({ name }) => name === tile));
        return html('button', { class: 'link', onclick: open }, tile ?? seam);
    };
    const notes = [...warnings.slice(mostWarnings), ...says.notes];
    return html(
        'header',
        { class: `verdict ${good && !flaw ? 'good' : 'poor'}${good && !flaw && unlaid.refused > 0 ? ' short' : ''}` },
        html(
            'p',
            { class: 'file' },
            html('b', {}, report.input.file || 'Envelope'),
            ` · ${report.fabrics.map((fabric) => fabric.name).join(', ')}`,
        ),
        html(
            'h1',
            {},
            html('span', { class: good ? 'word can' : 'word' }, `${says.word} `),
            says.headline,
            unlaid.refused > 0 && html('span', { class: 'but' }, rollWords(unlaid)),
            flaw && html('span', { class: 'word' }, flaw),
        ),
        warnings.length > 0 && lines(warnings.slice(0, mostWarnings), { class: 'warnings', 'aria-label': 'Warnings' }),
        html(
            'div',
            { class: 'why' },
            sentences('Why', says.why, linkOf),
            sentences('What to redesign', says.redesign, linkOf),
            saysOfFlight(model).length > 0 &&
                html(
                    'section',
                    { class: 'says' },
                    html('h2', {}, html('a', { href: '#flight' }, 'In flight')),
                    lines(saysOfFlight(model).slice(0, mostSaid)),
                ),
        ),
        notes.length > 0 &&
            html('details', { class: 'note' }, html('summary', {}, count(notes.length, 'note')), lines(notes)),
    );
}
