// The colours with their numbers.
import { html } from './dom.js';
import { legend, mapOf } from './maps.js';
import { cssColour, paletteTable, places } from './palette.js';

function ramp(table, from) {
    const stops = Array.from({ length: 17 }, (_, i) =>
        cssColour(table, places.first + Math.round((from + (1 - from) * (i / 16)) * (places.steps - 1))),
    );
    return html('i', { class: 'ramp', style: `background:linear-gradient(90deg, ${stops.join(', ')})` });
}

function scale(map, { low, high, pinned }, table, swatch) {
    return html(
        'div',
        { class: 'scale' },
        pinned && !map.unsigned && html('span', {}, swatch(places.below), ' beyond'),
        html(
            'span',
            { class: 'bar' },
            ramp(table, map.unsigned ? 0.5 : 0),
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
    );
}

export function legendView(model, { map: id, palette }) {
    const map = mapOf(id);
    const words = legend(model, map);
    const table = paletteTable(palette);
    const swatch = (place) => html('i', { class: 'swatch', style: `background:${cssColour(table, place)}` });
    return html(
        'div',
        { class: 'legend' },
        html('b', {}, map.name),
        words.kinds
            ? html(
                  'div',
                  { class: 'scale' },
                  words.kinds.map((kind) => html('span', {}, swatch(places[kind]), ` ${kind}`)),
              )
            : scale(map, words, table, swatch),
        words.note && html('small', {}, words.note),
    );
}
