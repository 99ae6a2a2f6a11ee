// A table that can be sorted by any column and shows its first rows until the user asks for more.
import { html } from '../view/dom.js';
import { count, figure } from '../view/format.js';

const firstRows = 100;

const collator = new Intl.Collator('en', { numeric: true });

// Signed figures are sorted by magnitude, because the user looks for the worst.
function ordered(items, { value }, descending) {
    const key = (item) => value(item);
    const sorted = items.toSorted((one, other) => {
        const [a, b] = [key(one), key(other)];
        if (typeof a === 'string') return collator.compare(a, b);
        return Math.abs(a ?? Infinity) - Math.abs(b ?? Infinity);
    });
    return descending ? sorted.reverse() : sorted;
}

const mark = (ok) => html('span', { class: `mark ${ok ? 'ok' : 'bad'}`, 'aria-hidden': 'true' });

function cell(item, column, onItem) {
    const value = column.value(item);
    const open = () => onItem(item);
    if (column.isName)
        return html('th', { scope: 'row' }, html('button', { class: 'link', onclick: open }, value));
    if (column.isVerdict) return html('td', {}, mark(item.ok), value);
    return html('td', { class: column.show ? 'number' : null }, column.show ? column.show(value) : value);
}

const rowOf = (item, columns, onItem) =>
    html(
        'tr',
        { class: item.ok ? null : 'fails' },
        columns.map((column) => cell(item, column, onItem)),
    );

// The rows to show, in order.
function makeRows(items, columns) {
    const texts = columns.filter((column) => !column.show);
    const rows = {
        sorting: null,
        descending: false,
        wanted: '',
        // Figures start with the largest; a second click on the same column reverses the order.
        sortBy(column) {
            rows.descending = rows.sorting === column ? !rows.descending : Boolean(column.show);
            rows.sorting = column;
        },
        found() {
            const found = items.filter((item) =>
                texts.some((column) => String(column.value(item)).toLowerCase().includes(rows.wanted)),
            );
            return rows.sorting ? ordered(found, rows.sorting, rows.descending) : found;
        },
        directionOf: (column) =>
            column === rows.sorting ? (rows.descending ? 'descending' : 'ascending') : null,
    };
    return rows;
}

function tableElement(id, title, heads, heading, body, more) {
    const label = `Table of ${title.toLowerCase()}`;
    return html(
        'section',
        { class: 'table', id, 'aria-label': title },
        heading,
        html(
            'div',
            { class: 'scroll', tabindex: '0', role: 'region', 'aria-label': label },
            html('table', {}, html('thead', {}, html('tr', {}, heads)), body),
        ),
        more,
    );
}

// `columns`: { name, value(item), show(value) for figures, isName, isVerdict }; `one`: the noun for an item.
export function sortedTable({ id, title, one, items, columns, onItem }) {
    const rows = makeRows(items, columns);
    const body = html('tbody'),
        heading = html('h2');
    const all = count(items.length, one);
    let isWhole = false;
    const heads = columns.map((column) => {
        const sort = () => {
            rows.sortBy(column);
            fill();
        };
        return html('th', { scope: 'col' }, html('button', { onclick: sort }, column.name));
    });
    const more = html('button', { class: 'more', onclick: () => showWhole(true) });
    function fill() {
        const found = rows.found();
        const shown = isWhole ? found : found.slice(0, firstRows);
        body.replaceChildren(...shown.map((item) => rowOf(item, columns, onItem)));
        const many = found.length < items.length ? `${figure(found.length, 0)} of ${all}` : all;
        heading.textContent = `${title} (${many})`;
        more.textContent = `Show all ${found.length}`;
        more.hidden = shown.length === found.length;
        heads.forEach((head, i) => {
            const direction = rows.directionOf(columns[i]);
            if (direction) head.setAttribute('aria-sort', direction);
            else head.removeAttribute('aria-sort');
        });
    }
    function showWhole(whole) {
        isWhole = whole;
        fill();
    }
    fill();
    return {
        element: tableElement(id, title, heads, heading, body, more),
        search(text) {
            rows.wanted = text.toLowerCase();
            fill();
        },
        showWhole,
    };
}
