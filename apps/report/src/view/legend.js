// The colours with their numbers.
import { html } from './dom.js';
import { cssColour, places } from './palette.js';

function ramp(table, from) {
    const stops = Array.from({ length: 17 }, (_, i) =>
        cssColour(table, places.first + Math.round((from + (1 - from) * (i / 16)) * (places.steps - 1))),
    );
    return html('i', { class: 'ramp', style: `background:linear-gradient(90deg, ${stops.join(', ')})` });
}

const ends = (...words) =>
    html(
        'span',
        { class: 'ends' },
        words.map((word) => html('span', {}, word)),
    );

function scaleBar({ map, scale, table }, swatch) {
    const meaning = ends(map.negative, map.positive);
    meaning.classList.add('meaning');
    return html(
        'div',
        { class: 'scale' },
        scale.beyond && !map.unsigned && html('span', {}, swatch(places.below), ' beyond'),
        html(
            'span',
            { class: 'bar' },
            ramp(table, map.unsigned ? 0.5 : 0),
            map.unsigned ? ends(scale.low, scale.high) : ends(scale.low, scale.middle, scale.high),
            meaning,
        ),
        scale.beyond && html('span', {}, 'beyond ', swatch(places.above)),
    );
}

const stateBar = ({ states }, swatch) =>
    html(
        'div',
        { class: 'scale' },
        states.map((state, i) => html('span', {}, swatch(places.states + i), ` ${state}`)),
    );

// `look`: from lookOf.
export function legendView(look) {
    const { map, scale, table } = look;
    const swatch = (place) => html('i', { class: 'swatch', style: `background:${cssColour(table, place)}` });
    return html(
        'div',
        { class: 'legend' },
        html('b', {}, map.name),
        map.states.length > 0 ? stateBar(map, swatch) : scaleBar(look, swatch),
        scale.note && html('small', {}, scale.note),
    );
}
