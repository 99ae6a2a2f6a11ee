// The colours with their numbers.
import { html } from './dom.js';
import { legend, mapOf } from './maps.js';
import { cssColour, paletteTable, places } from './palette.js';

export function legendView(model, { map: id, palette }) {
    const map = mapOf(id);
    const { low, high, note, pinned } = legend(model, map);
    const table = paletteTable(palette);
    const from = map.unsigned ? 0.5 : 0;
    const stops = Array.from({ length: 17 }, (_, i) =>
        cssColour(table, places.first + Math.round((from + (1 - from) * (i / 16)) * (places.steps - 1))),
    );
    const swatch = (place) => html('i', { class: 'swatch', style: `background:${cssColour(table, place)}` });
    return html(
        'div',
        { class: 'legend' },
        html('b', {}, map.name),
        html(
            'div',
            { class: 'scale' },
            pinned && !map.unsigned && html('span', {}, swatch(places.below), ' beyond'),
            html(
                'span',
                { class: 'bar' },
                html('i', { class: 'ramp', style: `background:linear-gradient(90deg, ${stops.join(', ')})` }),
                html(
                    'span',
                    { class: 'ends' },
                    html('span', {}, map.unsigned ? '0' : low),
                    !map.unsigned && html('span', {}, '0'),
                    html('span', {}, map.unsigned ? high.replace('+', '') : high),
                ),
                html('span', { class: 'ends meaning' }, html('span', {}, map.negative), html('span', {}, map.positive)),
            ),
            pinned && html('span', {}, 'beyond ', swatch(places.above)),
        ),
        note && html('small', {}, note),
    );
}
