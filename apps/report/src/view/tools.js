// What stands above the picture: which colours, in which palette, and what is shown.
import { failingSeams, failingTiles } from '../tables/verdict.js';
import { html } from './dom.js';
import { paletteNames } from './palette.js';

const optionElement = ({ id, name }) => html('option', { value: id }, name);

// The maps of the pieces and those of the flight apart, where there are both.
function mapGroups(available) {
    const groups = [
        { name: 'As cut', options: available.filter((map) => !map.inFlight) },
        { name: 'In flight', options: available.filter((map) => map.inFlight) },
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

// `home` shows the whole envelope.
export function makeTools(model, maps, state, chooser, home) {
    const { map, palette } = state.now;
    return html(
        'div',
        { class: 'tools' },
        selectBox('Colours show', mapGroups(maps), map, (id) => state.change({ map: id })),
        selectBox('Palette', paletteNames, palette, (id) => state.change({ palette: id })),
        html('button', { onclick: home }, 'Whole envelope'),
        html('button', { onclick: chooser.chooseNothing }, 'Choose nothing'),
        failingTiles(model).length + failingSeams(model).length > 0 &&
            html('button', { class: 'next', onclick: chooser.nextFailing }, 'Next that fails'),
    );
}
