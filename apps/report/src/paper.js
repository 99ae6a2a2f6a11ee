// On paper: every row of the tables, and the pieces of the tiles that fail.
import { html } from './dom.js';
import { pieceView } from './piece_view.js';
import { failingTiles } from './verdict.js';

const mostPieces = 24;

// The picture of the envelope as it is now, on a canvas of its own: one of WebGL is at times blank on paper.
function copyOf({ canvas, drawNow }) {
    drawNow();
    const copy = html('canvas', { class: 'envelope-copy', width: canvas.width, height: canvas.height });
    copy.getContext('2d').drawImage(canvas, 0, 0);
    return copy;
}

export function printWhole(shape, view, tables, printed, context) {
    let copy = null;
    window.addEventListener('beforeprint', () => {
        for (const table of tables) table.showWhole(true);
        for (const details of document.querySelectorAll('details')) details.open = true;
        const failing = failingTiles(shape.model)
            .filter((tile) => tile.flat)
            .slice(0, mostPieces);
        printed.replaceChildren(
            ...(failing.length > 0
                ? [
                      html('h2', {}, 'The pieces that fail'),
                      html(
                          'div',
                          { class: 'pieces' },
                          failing.map((tile) =>
                              html('figure', {}, pieceView(shape, tile, context()), html('figcaption', {}, tile.name)),
                          ),
                      ),
                  ]
                : []),
        );
        copy = copyOf(view);
        view.canvas.after(copy);
    });
    window.addEventListener('afterprint', () => {
        for (const table of tables) table.showWhole(false);
        printed.replaceChildren();
        copy?.remove();
    });
}
