// The list beside the picture: tiles or seams, all or those that fail, found by name. One stop of the tab key; arrows walk it.
import { html } from './dom.js';
import { count, sewnTiles } from './format.js';

export function makeList(model, state, { onTile, onSeam, onSearch }) {
    const kinds = {
        tile: { name: 'Tiles', items: model.tiles, label: (tile) => tile.name, open: onTile },
        seam: {
            name: 'Seams',
            items: model.seams,
            label: (seam) => `${seam.id}  ${sewnTiles(seam.said)}`,
            open: onSeam,
        },
    };
    const failing = { tile: model.tiles.some((tile) => !tile.ok), seam: model.seams.some((seam) => !seam.ok) };
    let kind = failing.seam && !failing.tile ? 'seam' : 'tile',
        onlyFailing = failing[kind],
        wanted = '';
    const box = html('ul', { role: 'listbox', tabindex: '0', 'aria-label': 'Tiles', class: 'list' });
    // Where else what is searched for is found.
    const elsewhere = html('p', { class: 'elsewhere', 'aria-live': 'polite' });
    const search = html('input', {
        type: 'search',
        placeholder: 'Search by name',
        'aria-label': 'Search by name',
        autocomplete: 'off',
        spellcheck: 'false',
    });
    const failingBox = html('input', { type: 'checkbox', id: 'only-failing' });
    const tabs = Object.entries(kinds).map(([id, { name, items }]) =>
        html('button', { class: 'tab', 'data-kind': id, onclick: () => show(id) }, `${name} ${items.length}`),
    );
    let shown = [];

    function fill() {
        const { items, label, name } = kinds[kind];
        shown = items.filter((item) => (!onlyFailing || !item.ok) && label(item).toLowerCase().includes(wanted));
        box.setAttribute('aria-label', name);
        box.replaceChildren(
            ...shown.map((item) =>
                html(
                    'li',
                    { role: 'option', id: `${kind}-${item.index}`, 'aria-selected': 'false' },
                    html('span', { class: `mark ${item.ok ? 'ok' : 'bad'}`, 'aria-hidden': 'true' }),
                    label(item),
                    html('span', { class: 'unseen' }, item.ok ? '' : ', fails'),
                ),
            ),
        );
        if (shown.length === 0)
            box.append(
                html(
                    'li',
                    { class: 'nothing', role: 'option', 'aria-disabled': 'true' },
                    onlyFailing ? 'None that fails' : 'None',
                    wanted && ` is called “${wanted}”`,
                ),
            );
        fillElsewhere();
        for (const tab of tabs) tab.setAttribute('aria-pressed', String(tab.dataset.kind === kind));
        failingBox.checked = onlyFailing;
        markChosen();
    }
    function fillElsewhere() {
        const found = (id, isHidden) =>
            kinds[id].items.filter(
                (item) => kinds[id].label(item).toLowerCase().includes(wanted) && (!isHidden || item.ok),
            ).length;
        const other = kind === 'tile' ? 'seam' : 'tile';
        const more = wanted && onlyFailing ? found(kind, true) : 0,
            others = wanted && shown.length + more === 0 ? found(other, false) : 0;
        const link = (words, onclick) => html('button', { class: 'link', onclick }, words);
        elsewhere.replaceChildren(
            ...[
                more > 0 &&
                    link(`${count(more, kind)} more that ${more === 1 ? 'does' : 'do'} not fail`, () => {
                        onlyFailing = false;
                        fill();
                    }),
                others > 0 &&
                    link(count(others, other), () => {
                        onlyFailing = false;
                        show(other);
                    }),
            ].filter(Boolean),
        );
    }
    function show(next) {
        kind = next;
        if (!failing[kind]) onlyFailing = false;
        fill();
    }
    function markChosen() {
        for (const option of box.querySelectorAll('[aria-selected=true]'))
            option.setAttribute('aria-selected', 'false');
        box.removeAttribute('aria-activedescendant');
        const { chosen } = state.now;
        const option = chosen?.kind === kind ? box.querySelector(`#${kind}-${chosen.index}`) : null;
        if (!option) return;
        option.setAttribute('aria-selected', 'true');
        box.setAttribute('aria-activedescendant', option.id);
        const above = option.offsetTop,
            { scrollTop, clientHeight } = box;
        if (above < scrollTop || above + option.offsetHeight > scrollTop + clientHeight)
            box.scrollTop = above - clientHeight / 2;
    }
    const open = (item) => item && kinds[kind].open(item);
    const step = (by) => {
        const { chosen } = state.now;
        const at = chosen?.kind === kind ? shown.findIndex((item) => item.index === chosen.index) : -1;
        if (at < 0) return open(shown[by > 0 ? 0 : shown.length - 1]);
        return open(shown[Math.min(shown.length - 1, Math.max(0, at + by))]);
    };
    box.addEventListener('keydown', (event) => {
        const steps = { ArrowDown: 1, ArrowUp: -1, PageDown: 12, PageUp: -12, Home: -shown.length, End: shown.length };
        if (!(event.key in steps)) return;
        event.preventDefault();
        step(steps[event.key]);
    });
    box.addEventListener('click', (event) => {
        const option = event.target.closest('[role=option][id]');
        if (option) open(kinds[kind].items[Number(option.id.split('-')[1])]);
    });
    search.addEventListener('input', () => {
        wanted = search.value.trim().toLowerCase();
        fill();
        onSearch(wanted);
    });
    search.addEventListener('keydown', (event) => {
        if (event.key === 'Enter') open(shown[0]);
    });
    failingBox.addEventListener('change', () => {
        onlyFailing = failingBox.checked;
        fill();
    });
    state.listen((now, before) => {
        if (now.chosen === before.chosen) return;
        if (now.chosen && now.chosen.kind !== kind) show(now.chosen.kind);
        if (now.chosen && !shown.some((item) => item.index === now.chosen.index)) {
            onlyFailing = false;
            fill();
        }
        markChosen();
    });
    fill();
    return {
        step,
        element: html(
            'nav',
            { class: 'finder', 'aria-label': 'Tiles and seams' },
            search,
            html('div', { class: 'tabs', role: 'group', 'aria-label': 'List of' }, tabs),
            (failing.tile || failing.seam) &&
                html('label', { for: 'only-failing', class: 'only' }, failingBox, ' only those that fail'),
            box,
            elsewhere,
        ),
    };
}
