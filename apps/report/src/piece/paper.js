// Prints every row of the tables and of the roll, and one piece per pattern: of the failing patterns if there are any,
// else of all.
import { html } from '../view/dom.js';
import { count } from '../view/format.js';
import { pieceView } from './piece_view.js';
import { failingTiles } from '../tables/verdict.js';

const mostPieces = 24;

function printedPieces(model, context) {
    const failing = failingTiles(model);
    const wanted = (failing.length > 0 ? failing : model.tiles).filter(
        ({ flat, said }) => flat && !said.equal_to && !said.mirror_of,
    );
    if (wanted.length === 0) return [];
    const shown = wanted.slice(0, mostPieces);
    const copies = ({ said }) => (said.quantity ?? 1) + (said.quantity_mirrored ?? 0);
    return [
        html('h2', {}, failing.length > 0 ? 'The pieces that fail' : 'The patterns'),
        shown.length < wanted.length &&
            html(
                'p',
                {},
                `The first ${shown.length} of ${count(wanted.length, 'piece')}; click any of them in report.html.`,
            ),
        html(
            'div',
            { class: 'pieces' },
            shown.map((tile) =>
                html(
                    'figure',
                    {},
                    pieceView(model, tile, context()),
                    html('figcaption', {}, tile.name, copies(tile) > 1 && ` × ${copies(tile)}`),
                ),
            ),
        ),
    ].filter(Boolean);
}

// `whole`: objects with showWhole(isWhole).
export function printWhole(model, view, whole, printed, context) {
    const picture = html('img', { class: 'envelope-printed', alt: 'The envelope' });
    window.addEventListener('beforeprint', () => {
        for (const part of whole) part.showWhole(true);
        for (const details of document.querySelectorAll('details')) details.open = true;
        printed.replaceChildren(...printedPieces(model, context));
        // Prints an image of the canvas, because browsers print canvases wrongly or over the content above them.
        view.drawNow();
        view.canvas.after(picture);
        picture.src = view.canvas.toDataURL();
    });
    window.addEventListener('afterprint', () => {
        for (const part of whole) part.showWhole(false);
        printed.replaceChildren();
        picture.remove();
    });
}
