// The roll: the place of every piece on the cloth, row below row, as laid by `ripstop nest`.
import { html, svg } from '../view/dom.js';
import { count, figure } from '../view/format.js';
import { notLaid } from './verdict.js';

const rowLength = 12000; // mm
const firstRows = 8;

function pathOf(points) {
    let path = '';
    for (let i = 0; i < points.length; i += 2)
        path += `${i ? 'L' : 'M'}${points[i].toFixed(1)} ${points[i + 1].toFixed(1)}`;
    return `${path}Z`;
}

// A placement with the piece's tile, its extent along the roll, and the place of its name.
function laid(placement, tile) {
    const side = placement.mirrored === placement.face_down ? 1 : -1;
    const turn = (placement.turn_deg * Math.PI) / 180;
    const at = (x, y) => [
        placement.x_mm + x * Math.cos(turn) - side * y * Math.sin(turn),
        placement.y_mm + x * Math.sin(turn) + side * y * Math.cos(turn),
    ];
    const { cut } = tile.piece;
    const box = [Infinity, -Infinity, Infinity, -Infinity];
    for (let i = 0; i < cut.length; i += 2) {
        const [x, y] = at(cut[i], cut[i + 1]);
        box[0] = Math.min(box[0], x);
        box[1] = Math.max(box[1], x);
        box[2] = Math.min(box[2], y);
        box[3] = Math.max(box[3], y);
    }
    const transform = `translate(${placement.x_mm} ${placement.y_mm}) rotate(${placement.turn_deg}) scale(1 ${side})`;
    return { placement, tile, box, transform, middle: [(box[0] + box[1]) / 2, (box[2] + box[3]) / 2] };
}

const patternOf = ({ name, said }) => said.equal_to ?? said.mirror_of ?? name;

// Each piece is a button. Each row is one stop of the tab key; the arrow keys go from piece to piece.
function pieceButton({ tile, placement, transform }, isStop, onTile) {
    const copy = `${tile.name}, copy ${placement.copy + 1}${placement.mirrored ? ', mirror image' : ''}`;
    return svg(
        'path',
        {
            class: tile.ok ? 'laid' : 'laid bad',
            d: pathOf(tile.piece.cut),
            transform,
            role: 'button',
            tabindex: isStop ? 0 : -1,
            'aria-label': tile.ok ? copy : `${copy}, fails`,
            'data-pattern': patternOf(tile),
            onclick: () => onTile(tile),
        },
        svg('title', {}, copy),
    );
}

function walkRow(event) {
    const pieces = [...event.currentTarget.querySelectorAll('.laid')];
    const at = pieces.indexOf(event.target);
    const steps = { ArrowRight: 1, ArrowDown: 1, ArrowLeft: -1, ArrowUp: -1, Home: -pieces.length, End: pieces.length };
    if (at < 0) return;
    if (event.key === 'Enter' || event.key === ' ') event.target.dispatchEvent(new MouseEvent('click'));
    else if (event.key in steps) {
        const next = pieces[Math.min(pieces.length - 1, Math.max(0, at + steps[event.key]))];
        event.target.setAttribute('tabindex', '-1');
        next.setAttribute('tabindex', '0');
        next.focus();
    } else return;
    event.preventDefault();
}

// The lengths of cloth in a row, and where one ends and the next begins.
function clothOf(marker, start) {
    const width = marker.roll_width_mm;
    const parts = marker.roll_parts.filter(
        (part) => part.start_mm < start + rowLength && part.start_mm + part.length_mm > start,
    );
    const within = (at) => Math.min(start + rowLength, Math.max(start, at));
    return [
        parts.map(({ start_mm: from, length_mm: length }) =>
            svg('rect', {
                class: 'cloth',
                x: within(from),
                y: -width,
                width: within(from + length) - within(from),
                height: width,
            }),
        ),
        parts
            .filter((part) => part.start_mm > 0 && part.start_mm >= start)
            .map(({ start_mm: at }) =>
                svg(
                    'path',
                    { class: 'join', d: `M${at} 0V${-width}` },
                    svg('title', {}, 'Here a length of cloth ends'),
                ),
            ),
    ];
}

function rowView(marker, pieces, start, onTile) {
    const width = marker.roll_width_mm,
        end = Math.min(start + rowLength, marker.length_mm);
    const here = pieces.filter(({ box }) => box[1] > start && box[0] < start + rowLength);
    return html(
        'figure',
        {},
        svg(
            'svg',
            {
                class: 'roll',
                viewBox: `${start} ${-width} ${rowLength} ${width}`,
                role: 'group',
                'aria-label': `The roll from ${figure(start / 1000, 0)} to ${figure(end / 1000, 1)} m: ` +
                    count(here.length, 'piece'),
                onkeydown: walkRow,
            },
            clothOf(marker, start),
            svg(
                'g',
                { transform: 'scale(1 -1)' },
                here.map((piece, i) => pieceButton(piece, i === 0, onTile)),
            ),
            here.map(({ tile, box, middle }) =>
                svg(
                    'text',
                    {
                        x: middle[0],
                        y: -middle[1],
                        'text-anchor': 'middle',
                        'dominant-baseline': 'central',
                        'font-size': Math.min(110, (1.5 * (box[1] - box[0])) / Math.max(3, tile.name.length)),
                        'aria-hidden': 'true',
                    },
                    tile.name,
                ),
            ),
        ),
        html('figcaption', {}, `${figure(start / 1000, 0)} to ${figure(end / 1000, 1)} m`),
    );
}

function joinWords({ roll_parts: parts }) {
    if (parts.length < 2) return null;
    const lengths = parts.map(({ length_mm: length }) => figure(length / 1000, 1)).join(', ');
    return html(
        'p',
        { class: 'note' },
        `In ${parts.length} lengths of cloth: ${lengths} m. A dashed line is where one ends.`,
    );
}

function markerView(model, marker, onTile, onShown) {
    const byName = new Map(model.tiles.filter((tile) => tile.piece).map((tile) => [tile.name, tile]));
    const pieces = marker.placements
        .filter(({ piece }) => byName.has(piece))
        .map((placement) => laid(placement, byName.get(placement.piece)))
        .sort((one, other) => one.box[0] - other.box[0]);
    const starts = [];
    for (let start = 0; start < marker.length_mm; start += rowLength) starts.push(start);
    const rows = html('div', { class: 'rows' });
    const more = html(
        'button',
        { class: 'more', onclick: () => showWhole(true) },
        `Show all ${count(starts.length, 'row')}`,
    );
    const showWhole = (isWhole) => {
        const shown = isWhole ? starts : starts.slice(0, firstRows);
        rows.replaceChildren(...shown.map((start) => rowView(marker, pieces, start, onTile)));
        more.hidden = shown.length === starts.length;
        onShown();
    };
    const name = [marker.fabric, marker.colour].filter(Boolean).join(', ');
    const element = html(
        'div',
        {},
        html(
            'h3',
            {},
            `${name}: ${figure(marker.length_mm / 1000, 1)} m of cloth ${figure(marker.roll_width_mm, 0)} mm wide, ` +
                `${figure(marker.utilisation_pct, 1)} % of it used, ${count(pieces.length, 'piece')}`,
        ),
        joinWords(marker),
        rows,
        more,
    );
    return { element, showWhole };
}

function keyOfRoll(model) {
    const entry = (name, words) => html('span', {}, html('i', { class: `swatch ${name}` }), ` ${words}`);
    return html(
        'p',
        { class: 'roll-key' },
        entry('laid-good', 'can be made'),
        model.tiles.some((tile) => !tile.ok) && entry('laid-bad', 'cannot be made as drawn'),
        entry('laid-chosen', 'the piece that is chosen, and its copies'),
    );
}

function refusedView(roll) {
    const { refused, all } = notLaid(roll);
    if (refused === 0) return null;
    return [
        html(
            'h3',
            { class: 'bad' },
            html('b', {}, `Not laid in total: ${figure(refused, 0)} of ${count(all, 'piece')}`),
        ),
        html(
            'ul',
            { class: 'findings' },
            roll.refused.map(({ piece, quantity, reason }) =>
                html('li', {}, html('b', {}, `${figure(quantity, 0)} × ${piece}`), `: not laid, since it ${reason}.`),
            ),
        ),
    ];
}

// Returns null if nothing was laid.
export function rollView(model, state, onTile) {
    if (!model.roll) return null;
    const light = () => {
        const { chosen } = state.now;
        const tile = chosen?.kind === 'tile' ? model.tiles[chosen.index] : null;
        for (const path of element.querySelectorAll('.laid'))
            path.classList.toggle('chosen', Boolean(tile) && path.dataset.pattern === patternOf(tile));
    };
    const element = html('section', { class: 'roll-section', 'aria-label': 'The roll' });
    const markers = model.roll.markers.map((marker) => markerView(model, marker, onTile, light));
    element.append(
        html('h2', {}, 'The roll'),
        ...[keyOfRoll(model), refusedView(model.roll)].flat().filter(Boolean),
        ...markers.map((marker) => marker.element),
    );
    const showWhole = (isWhole) => markers.forEach((marker) => marker.showWhole(isWhole));
    showWhole(false);
    state.listen((now, before) => now.chosen !== before.chosen && light());
    return { element, showWhole };
}
