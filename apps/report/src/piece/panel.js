// The panel with all details of the chosen tile or seam.
import { html } from '../view/dom.js';
import { figure, plainPercent, signedMillimetres, squareMetres } from '../view/format.js';
import { hoverWords } from '../view/tip.js';
import { verdictWord } from '../tables/verdict.js';
import { figureList, pair } from './figure_list.js';
import { seamPanel, seamWord } from './seam_panel.js';
import { tilePanel } from './tile_panel.js';

function nothingChosen(model) {
    const patterns = model.tiles.filter((tile) => !tile.said.equal_to && !tile.said.mirror_of).length;
    return [
        html('h2', { class: 'screen-only' }, 'Choose a tile or a seam'),
        html(
            'p',
            { class: 'screen-only' },
            'Click one in the picture, or choose it in the list. Its piece is shown here as it is cut.',
        ),
        figureList(
            pair(
                'Tiles',
                figure(model.tiles.length, 0),
                html('small', {}, patterns < model.tiles.length ? `of ${figure(patterns, 0)} patterns` : ''),
            ),
            pair('Seams', figure(model.seams.length, 0)),
            pair('Cloth', squareMetres(model.report.envelope.area_m2)),
        ),
        html('h3', {}, 'In the piece'),
        html(
            'ul',
            { class: 'key' },
            html('li', {}, html('i', { class: 'key-cut' }), 'cut line'),
            html('li', {}, html('i', { class: 'key-sew' }), 'sew line'),
            html('li', {}, html('i', { class: 'key-notch' }), 'notches: the same places on both pieces'),
            html('li', {}, html('i', { class: 'key-grain' }), 'grain: the warp'),
            html('li', {}, html('i', { class: 'key-proposed' }), 'a seam that would help'),
        ),
    ];
}

function panelContent(model, chosen, context) {
    if (!chosen) return nothingChosen(model);
    if (chosen.kind === 'tile') return tilePanel(model, model.tiles[chosen.index], context);
    return seamPanel(model, model.seams[chosen.index], context);
}

// One sentence for screen readers.
export function spoken(model, chosen) {
    if (!chosen) return 'Nothing chosen';
    if (chosen.kind === 'tile') {
        const tile = model.tiles[chosen.index];
        return (
            `Tile ${tile.name}, ${verdictWord(tile)}, ` +
            `area error ${plainPercent(tile.said.area_error_pct, 2)}, ${tile.sides.length} sewn edges`
        );
    }
    const { said, id } = model.seams[chosen.index];
    return (
        `Seam ${id} between ${said.tile_a} and ${said.tile_b}, ` +
        `${seamWord(said)}, mismatch ${signedMillimetres(said.mismatch_mm)}`
    );
}

// Whether the last input came from the keyboard.
function watchKeys() {
    const watch = { isByKey: false };
    for (const type of ['keydown', 'pointerdown'])
        window.addEventListener(type, () => (watch.isByKey = type === 'keydown'), { capture: true });
    return watch;
}

// `context()`: look, onTile, onSeam. `show` shows the chosen item, `reveal` scrolls to it.
export function makePanel(model, state, tip, context) {
    const watch = watchKeys();
    const element = html('section', { class: 'panel', 'aria-label': 'The piece', tabindex: '0' });
    element.addEventListener('pointerleave', () => tip.show(null));
    return {
        element,
        show() {
            const { chosen } = state.now;
            const tile = chosen?.kind === 'tile' ? model.tiles[chosen.index] : null;
            const hover =
                tile && ((triangle, event) => tip.show(triangle < 0 ? null : hoverWords({ tile, triangle }), event));
            const content = panelContent(model, chosen, { ...context(), hover });
            element.replaceChildren(...[content].flat(Infinity).filter(Boolean));
        },
        // It may be off the screen: on a telephone, or when chosen in the tables.
        reveal() {
            const { top, bottom } = element.getBoundingClientRect();
            if (!watch.isByKey && (top > 0.8 * window.innerHeight || bottom < 0.3 * window.innerHeight))
                element.scrollIntoView({ block: 'start' });
        },
    };
}
