// The roll: where every piece lies on the cloth, row below row, as `ripstop nest` has laid them.
import { html, svg } from './dom.js';
import { count, figure } from './format.js';

const rowLength = 12000; // mm
const firstRows = 8;

function pathOf(points) {
    let path = '';
    for (let i = 0; i < points.length; i += 2)
        path += `${i ? 'L' : 'M'}${points[i].toFixed(1)} ${points[i + 1].toFixed(1)}`;
    return `${path}Z`;
}

// A placement with the piece's tile, what it takes of the roll's length, and where its name is written.
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
                role: 'img',
                'aria-label': `The roll from ${figure(start / 1000, 0)} to ${figure(end / 1000, 1)} m: ${count(here.length, 'piece')}`,
            },
            svg('rect', { class: 'cloth', x: start, y: -width, width: end - start, height: width }),
            svg(
                'g',
                { transform: 'scale(1 -1)' },
                here.map(({ tile, placement, transform }) =>
                    svg(
                        'path',
                        {
                            class: tile.ok ? 'laid' : 'laid bad',
                            d: pathOf(tile.piece.cut),
                            transform,
                            onclick: () => onTile(tile),
                        },
                        svg(
                            'title',
                            {},
                            `${tile.name}, copy ${placement.copy}${placement.mirrored ? ', mirror image' : ''}`,
                        ),
                    ),
                ),
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
                    },
                    tile.name,
                ),
            ),
        ),
        html('figcaption', {}, `${figure(start / 1000, 0)} to ${figure(end / 1000, 1)} m`),
    );
}

function markerView(model, marker, onTile) {
    const byName = new Map(model.tiles.filter((tile) => tile.piece).map((tile) => [tile.name, tile]));
    const pieces = marker.placements
        .filter(({ piece }) => byName.has(piece))
        .map((placement) => laid(placement, byName.get(placement.piece)));
    const starts = [];
    for (let start = 0; start < marker.length_mm; start += rowLength) starts.push(start);
    const rows = html('div', { class: 'rows' });
    const show = (number) =>
        rows.replaceChildren(...starts.slice(0, number).map((start) => rowView(marker, pieces, start, onTile)));
    show(firstRows);
    const more = html(
        'button',
        {
            class: 'more',
            hidden: starts.length <= firstRows,
            onclick: () => {
                show(starts.length);
                more.hidden = true;
            },
        },
        `Show all ${count(starts.length, 'row')}`,
    );
    const name = [marker.fabric, marker.colour].filter(Boolean).join(', ');
    return [
        html(
            'h3',
            {},
            `${name}: ${figure(marker.length_mm / 1000, 1)} m of cloth ${figure(marker.roll_width_mm, 0)} mm wide, ${figure(marker.utilisation_pct, 1)} % of it used, ${count(pieces.length, 'piece')}`,
        ),
        rows,
        more,
    ];
}

// Nothing where nothing was laid.
export function rollView(model, onTile) {
    if (!model.roll) return null;
    return html(
        'section',
        { class: 'roll-section', 'aria-label': 'The roll' },
        html('h2', {}, 'The roll'),
        model.roll.markers.map((marker) => markerView(model, marker, onTile)),
        model.roll.refused.length > 0 &&
            html(
                'ul',
                { class: 'findings' },
                model.roll.refused.map(({ piece, reason }) => html('li', {}, `${piece} is not laid: ${reason}`)),
            ),
    );
}
