// The verdict: can it be made, what is wrong, what to redesign.
import { html } from './dom.js';
import { says } from './flight_view.js';
import { count, short } from './format.js';

// What a finding's code means to a maker, and the unit of its figure.
const meanings = {
    isoperimetric: ['no flat piece has this outline and this area', ''],
    stretch_bound: ['more curved than the cloth can stretch', ''],
    unsolved: ['no flattening was found', ''],
    uncertified: ['the flattening is not certain', ''],
    flipped: ['cloth turned over', ''],
    outline: ['the outline meets itself', ''],
    overlap: ['the piece lies on itself', ''],
    area: ['area', '%'],
    perimeter: ['length of the outline', '%'],
    chain: ['length of an edge', '%'],
    warp_strain: ['strain along the warp', '%'],
    weft_strain: ['strain along the weft', '%'],
    shear: ['shear between the threads', '°'],
};

const mostSaid = 5; // of what is said of the flight; the section about it has all

export function verdictWord(tile) {
    if (tile.ok) return 'can be made';
    return tile.findings.length === 0 ? 'not judged' : 'cannot be made as drawn';
}

export const failingTiles = (model) => model.tiles.filter((tile) => !tile.ok);
export const failingSeams = (model) => model.seams.filter((seam) => !seam.ok);

export const meaning = (code) => meanings[code]?.[0] ?? code;

// True too where nothing was inflated.
function fliesAsDrawn(said) {
    return !said || (said.converged && said.safe && said.deviation_rms_mm <= said.deviation_limit_mm);
}

function headline(model) {
    const tiles = failingTiles(model),
        seams = failingSeams(model);
    const { envelope } = model.report;
    if (envelope.manufacturable) {
        const fitting =
            model.seams.length > 0
                ? `, and ${model.seams.length === 1 ? 'the seam fits' : `all ${count(model.seams.length, 'seam')} fit`}`
                : '';
        return `${model.tiles.length === 1 ? 'The tile' : `All ${count(model.tiles.length, 'tile')}`} can be made${fitting}.`;
    }
    const parts = [];
    if (tiles.length > 0) parts.push(`${tiles.length} of ${count(model.tiles.length, 'tile')} cannot be made as drawn`);
    if (seams.length > 0)
        parts.push(
            `${seams.length} of ${count(model.seams.length, 'seam')} ${seams.length === 1 ? 'does' : 'do'} not fit`,
        );
    if (parts.length === 0) parts.push('The tiles can be made, but the drawing has faults');
    return parts.join(', and ') + '.';
}

// Each kind of finding once, with how many tiles have it and the worst of them.
function reasons(model) {
    const kinds = new Map();
    for (const tile of failingTiles(model))
        for (const finding of tile.findings) {
            const kind = kinds.get(finding.code) ?? { code: finding.code, tiles: new Set(), worst: null };
            kind.tiles.add(tile);
            const excess = Math.abs(finding.value / (finding.limit || 1));
            if (!kind.worst || excess > kind.worst.excess) kind.worst = { tile, finding, excess };
            kinds.set(finding.code, kind);
        }
    return [...kinds.values()].sort((one, other) => other.tiles.size - one.tiles.size);
}

function reasonLine(kind, onTile) {
    const { finding, tile } = kind.worst;
    const unit = meanings[kind.code]?.[1] ?? '';
    const figures = unit
        ? `: ${short(Math.abs(finding.value))}${unit === '%' ? '\u00a0%' : unit}, allowed ${short(finding.limit)}${unit === '%' ? '\u00a0%' : unit}`
        : '';
    const link = html('button', { class: 'link', onclick: () => onTile(tile) }, tile.name);
    if (kind.tiles.size === 1) return html('li', {}, link, `: ${meaning(kind.code)}${figures}.`);
    return html(
        'li',
        {},
        html('b', {}, count(kind.tiles.size, 'tile')),
        `: ${meaning(kind.code)}. Worst `,
        link,
        `${figures}.`,
    );
}

export function verdictView(model, { onTile, onSeam }) {
    const { report } = model;
    const good = report.envelope.manufacturable;
    const flies = fliesAsDrawn(report.inflated);
    const seams = failingSeams(model);
    const proposals = model.tiles.filter((tile) => tile.said.proposal);
    const others = report.envelope.findings.filter((finding) => finding.code !== 'seam');
    const uncertain = model.seams.filter((seam) => !seam.said.certain).length;
    const notes = [
        ...(uncertain > 0
            ? [
                  `${count(uncertain, 'seam')} ${uncertain === 1 ? 'is' : 'are'} not certain: the meshes leave more of the length open than the seam may err.`,
              ]
            : []),
        ...report.input.remarks,
    ];
    const worstSeam = seams.toSorted(
        (one, other) => Math.abs(other.said.drift_max_mm) - Math.abs(one.said.drift_max_mm),
    )[0];
    const redesign = proposals.length > 0 || report.envelope.merges.length > 0;
    return html(
        'header',
        { class: `verdict ${good && flies ? 'good' : 'poor'}` },
        html(
            'p',
            { class: 'file' },
            html('b', {}, report.input.file || 'Envelope'),
            ` · ${report.fabrics.map((fabric) => fabric.name).join(', ')}`,
        ),
        html(
            'h1',
            {},
            html('span', { class: good ? 'word can' : 'word' }, good ? 'Manufacturable. ' : 'Not manufacturable as drawn. '),
            headline(model),
            !flies && html('span', { class: 'word' }, ' It does not fly as drawn.'),
        ),
        html(
            'div',
            { class: 'why' },
            !good &&
                html(
                    'section',
                    {},
                    html('h2', {}, 'Why'),
                    html(
                        'ul',
                        {},
                        reasons(model).map((kind) => reasonLine(kind, onTile)),
                        worstSeam &&
                            html(
                                'li',
                                {},
                                html('b', {}, count(seams.length, 'seam')),
                                ': the two sides differ in length. Worst ',
                                html('button', { class: 'link', onclick: () => onSeam(worstSeam) }, worstSeam.id),
                                `: ${short(worstSeam.said.drift_max_mm)}\u00a0mm apart, allowed ${short(worstSeam.said.limit_mm)}\u00a0mm.`,
                            ),
                        others.map((finding) => html('li', {}, finding.message)),
                    ),
                ),
            redesign &&
                html(
                    'section',
                    {},
                    html('h2', {}, 'What to redesign'),
                    html(
                        'ul',
                        {},
                        proposals
                            .slice(0, 6)
                            .map((tile) =>
                                html(
                                    'li',
                                    {},
                                    html('button', { class: 'link', onclick: () => onTile(tile) }, tile.name),
                                    `: draw a seam ${tile.said.proposal.direction}; ${halves(tile.said.proposal)}.`,
                                ),
                            ),
                        proposals.length > 6 &&
                            html('li', {}, `and ${proposals.length - 6} more: choose a failing tile.`),
                        report.envelope.merges.length > 0 &&
                            html(
                                'li',
                                {},
                                `${count(report.envelope.merges.length, 'pair')} of neighbours could be one tile; report.json names them.`,
                            ),
                    ),
                ),
            says(model).length > 0 &&
                html(
                    'section',
                    { class: 'says' },
                    html('h2', {}, html('a', { href: '#flight' }, 'In flight')),
                    html(
                        'ul',
                        {},
                        says(model)
                            .slice(0, mostSaid)
                            .map((sentence) => html('li', {}, sentence)),
                    ),
                ),
        ),
        notes.length > 0 &&
            html(
                'details',
                { class: 'note' },
                html('summary', {}, count(notes.length, 'note')),
                html(
                    'ul',
                    {},
                    notes.map((note) => html('li', {}, note)),
                ),
            ),
    );
}

function halves(proposal) {
    const good = proposal.halves.filter((half) => half.verdict.findings.length === 0).length;
    return [
        'both halves are better, neither can be made yet',
        'one half can be made then',
        'both halves can be made then',
    ][good];
}
