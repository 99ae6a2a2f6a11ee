// The layout of the page.
import { html } from './dom.js';

const hintWords = 'Click a tile or a seam. Drag turns; once clicked, the wheel zooms. Keys: arrows, + − and Home.';

// The places whose content changes: the picture, its legend, its pose, the print view and the spoken text.
export function makePlaces() {
    return {
        holder: html('div', { class: 'holder' }),
        legend: html('div', { class: 'legend-place' }),
        pose: html('p', { class: 'pose-words' }),
        hint: html('p', { class: 'hint' }, hintWords),
        printed: html('section', { class: 'print-only' }),
        live: html('p', { class: 'unseen', role: 'status' }),
    };
}

// `above`: content above the picture; `below`: content below the work area.
export function layOut(places, { verdict, list, above, panel, below, tip }) {
    const space = html(
        'section',
        { class: 'space', 'aria-label': 'The envelope' },
        above,
        places.legend,
        places.holder,
        places.pose,
        places.hint,
    );
    const main = html('main', {}, html('div', { class: 'work' }, list, space, panel), places.printed, below);
    document.getElementById('page').replaceChildren(verdict, main, tip, places.live);
    new ResizeObserver(() =>
        document.documentElement.style.setProperty('--verdict', `${verdict.offsetHeight}px`),
    ).observe(verdict);
}

export function sayItCannotBeShown(error) {
    const words = `The report cannot be shown by this browser (${error.message}). ` +
        'The figures are in report.json, tiles.csv and seams.csv beside this page.';
    document.getElementById('page').replaceChildren(html('p', { role: 'alert', class: 'starting' }, words));
}
