// A text beside the pointer about the item below it.
import { html } from './dom.js';
import { degrees, figure, percent, sewnTiles, signedMillimetres } from './format.js';
import { clothValue } from './maps.js';

export function hoverWords({ tile, triangle, seam }) {
    const value = (key) => clothValue(tile, key, triangle);
    const words = [html('b', {}, tile.name)];
    if (seam) words.push(html('div', {}, `Seam ${seam.id}: ${sewnTiles(seam.said)}`));
    if (Number.isNaN(value('warp'))) words.push(html('div', {}, 'flipped on the cloth'));
    else if (value('warp') !== undefined)
        words.push(
            html('div', {}, `warp ${percent(value('warp') * 100)}, weft ${percent(value('weft') * 100)}`),
            html(
                'div',
                {},
                `shear ${degrees((value('shear') * 180) / Math.PI, 2)}, area ${percent(value('area') * 100)}`,
            ),
        );
    if (value('flight-tension') !== undefined)
        words.push(
            html(
                'div',
                {},
                `in flight ${signedMillimetres(value('deviation') * 1000, 1)} off, ` +
                    `${figure(value('flight-tension'), 1)}\u00a0N/m, ` +
                    `${['taut', 'wrinkled', 'slack'][value('state')]}`,
            ),
        );
    if (seam?.said.tape_force_max_n !== undefined)
        words.push(html('div', {}, `load tape ${figure(seam.said.tape_force_max_n, 0)}\u00a0N`));
    return words;
}

export function makeTip() {
    const element = html('div', { class: 'tip', hidden: true, 'aria-hidden': 'true' });
    const show = (words, event) => {
        element.hidden = !words;
        if (!words) return;
        element.replaceChildren(...words);
        element.style.left = `${Math.min(event.clientX + 14, window.innerWidth - element.offsetWidth - 8)}px`;
        element.style.top = `${Math.min(event.clientY + 14, window.innerHeight - element.offsetHeight - 8)}px`;
    };
    return { element, show };
}
