// The controls above the picture: map, palette, and view.
import { failingSeams, failingTiles } from '../tables/verdict.js';
import { html } from './dom.js';
import { lookOf } from './maps.js';

const optionElement = ({ id, name }) => html('option', { value: id }, name);

// Groups the maps of the pieces and those of the flight, if there are both.
function mapGroups(available) {
    const groups = [
        { name: 'As cut', options: available.filter((map) => !map.in_flight) },
        { name: 'In flight', options: available.filter((map) => map.in_flight) },
    ];
    return groups.every((group) => group.options.length > 0) ? groups : available;
}

function selectBox(label, options, value, onchange) {
    const box = html(
        'select',
        { onchange: () => onchange(box.value) },
        options.map((option) =>
            option.options
                ? html('optgroup', { label: option.name }, option.options.map(optionElement))
                : optionElement(option),
        ),
    );
    box.value = value;
    return html('label', { class: 'choice' }, html('span', {}, label), box);
}

// The scale: by the values or by the limits; hidden if the map has only one.
function scaleChoice(model, state) {
    const names = { there: 'to what is there', tolerance: 'to tolerance' };
    const buttons = Object.entries(names).map(([id, name]) =>
        html('button', { 'data-scale': id, onclick: () => state.change({ scale: id }) }, name),
    );
    const element = html('span', { class: 'choice', role: 'group', 'aria-label': 'Colours scaled' }, 'scaled', buttons);
    const tell = () => {
        const { map, scale } = lookOf(model, state.now);
        element.hidden = map.scales.length < 2;
        for (const button of buttons) button.setAttribute('aria-pressed', String(button.dataset.scale === scale.id));
    };
    state.listen(tell);
    tell();
    return element;
}

// `home` shows the whole envelope.
export function makeTools(model, state, chooser, home) {
    const { map, palette } = state.now;
    return html(
        'div',
        { class: 'tools' },
        selectBox('Colours show', mapGroups(model.maps), map, (id) => state.change({ map: id })),
        scaleChoice(model, state),
        selectBox('Palette', model.palettes, palette, (id) => state.change({ palette: id })),
        html('button', { onclick: home }, 'Whole envelope'),
        html('button', { onclick: chooser.chooseNothing }, 'Choose nothing'),
        failingTiles(model).length + failingSeams(model).length > 0 &&
            html('button', { class: 'next', onclick: chooser.nextFailing }, 'Next that fails'),
    );
}
