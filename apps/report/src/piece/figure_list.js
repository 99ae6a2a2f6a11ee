// A list of named figures, and a heading with a verdict.
import { html } from '../view/dom.js';

export const pair = (name, ...value) => html('div', {}, html('dt', {}, name), html('dd', {}, value));

export const figureList = (...pairs) => html('dl', { class: 'figures' }, pairs);

export const judgedHeading = (ok, name, word) =>
    html(
        'h2',
        {},
        html('span', { class: `mark ${ok ? 'ok' : 'bad'}`, 'aria-hidden': 'true' }),
        name,
        ' ',
        html('span', { class: 'verdict-word' }, word),
    );
