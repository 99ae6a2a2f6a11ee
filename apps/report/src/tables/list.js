// The list beside the picture: tiles or seams, all or only those that fail, with a search. One stop of the tab key; the
// arrow keys walk it.
import { html } from '../view/dom.js';
import { count } from '../view/format.js';
import { makeListed } from './listed.js';

const optionOf = (kind, item, label) =>
    html(
        'li',
        { role: 'option', id: `${kind}-${item.index}`, 'aria-selected': 'false' },
        html('span', { class: `mark ${item.ok ? 'ok' : 'bad'}`, 'aria-hidden': 'true' }),
        label,
        html('span', { class: 'unseen' }, item.ok ? '' : ', fails'),
    );

const nothingCalled = ({ onlyFailing, wanted }) =>
    html(
        'li',
        { class: 'nothing', role: 'option', 'aria-disabled': 'true' },
        onlyFailing ? 'None that fails' : 'None',
        wanted && ` is called “${wanted}”`,
    );

// The list box; `mark` shows the chosen option.
function makeBox(listed) {
    const box = html('ul', { role: 'listbox', tabindex: '0', 'aria-label': 'Tiles', class: 'list' });
    const fill = () => {
        const { label, name } = listed.kinds[listed.kind];
        box.setAttribute('aria-label', name);
        box.replaceChildren(...listed.shown.map((item) => optionOf(listed.kind, item, label(item))));
        if (listed.shown.length === 0) box.append(nothingCalled(listed));
    };
    const mark = (chosen) => {
        for (const option of box.querySelectorAll('[aria-selected=true]'))
            option.setAttribute('aria-selected', 'false');
        box.removeAttribute('aria-activedescendant');
        const option = chosen?.kind === listed.kind ? box.querySelector(`#${listed.kind}-${chosen.index}`) : null;
        if (!option) return;
        option.setAttribute('aria-selected', 'true');
        box.setAttribute('aria-activedescendant', option.id);
        const above = option.offsetTop,
            { scrollTop, clientHeight } = box;
        if (above < scrollTop || above + option.offsetHeight > scrollTop + clientHeight)
            box.scrollTop = above - clientHeight / 2;
    };
    box.addEventListener('click', (event) => {
        const option = event.target.closest('[role=option][id]');
        if (option) listed.open(listed.kinds[listed.kind].items[Number(option.id.split('-')[1])]);
    });
    return { box, fill, mark };
}

// Links to matches of the search in other lists.
function elsewhereLinks(listed, fill) {
    const { more, others } = listed.elsewhere();
    const link = (words, kind) => {
        const onclick = () => {
            listed.onlyFailing = false;
            listed.turnTo(kind);
            fill();
        };
        return html('button', { class: 'link', onclick }, words);
    };
    return [
        more > 0 && link(`${count(more, listed.kind)} more that ${more === 1 ? 'does' : 'do'} not fail`, listed.kind),
        others > 0 && link(count(others, listed.other()), listed.other()),
    ].filter(Boolean);
}

// The controls above the box: search by name, tiles or seams, only those that fail.
function makeTools(listed, fill, onSearch) {
    const search = html('input', {
        type: 'search',
        placeholder: 'Search by name',
        'aria-label': 'Search by name',
        autocomplete: 'off',
        spellcheck: 'false',
        oninput: () => {
            listed.wanted = search.value.trim().toLowerCase();
            fill();
            onSearch(listed.wanted);
        },
        onkeydown: (event) => event.key === 'Enter' && listed.open(listed.shown[0]),
    });
    const failingBox = html('input', {
        type: 'checkbox',
        id: 'only-failing',
        onchange: () => {
            listed.onlyFailing = failingBox.checked;
            fill();
        },
    });
    const show = (kind) => {
        listed.turnTo(kind);
        fill();
    };
    const tabs = Object.entries(listed.kinds).map(([id, { name, items }]) =>
        html('button', { class: 'tab', 'data-kind': id, onclick: () => show(id) }, `${name} ${items.length}`),
    );
    const elements = [
        search,
        html('div', { class: 'tabs', role: 'group', 'aria-label': 'List of' }, tabs),
        listed.hasFailing &&
            html('label', { for: 'only-failing', class: 'only' }, failingBox, ' only those that fail'),
    ];
    const tell = () => {
        for (const tab of tabs) tab.setAttribute('aria-pressed', String(tab.dataset.kind === listed.kind));
        failingBox.checked = listed.onlyFailing;
    };
    return { elements, tell, show };
}

// Goes to the next of the shown entries.
function makeStep(listed, state) {
    return (by) => {
        const { chosen } = state.now;
        const { shown } = listed;
        const at = chosen?.kind === listed.kind ? shown.findIndex((item) => item.index === chosen.index) : -1;
        if (at < 0) return listed.open(shown[by > 0 ? 0 : shown.length - 1]);
        return listed.open(shown[Math.min(shown.length - 1, Math.max(0, at + by))]);
    };
}

export function makeList(model, state, { onTile, onSeam, onSearch }) {
    const listed = makeListed(model, { onTile, onSeam });
    const { box, fill: fillBox, mark } = makeBox(listed);
    const elsewhere = html('p', { class: 'elsewhere', 'aria-live': 'polite' });
    const fill = () => {
        listed.fill();
        fillBox();
        elsewhere.replaceChildren(...elsewhereLinks(listed, fill));
        tools.tell();
        mark(state.now.chosen);
    };
    const tools = makeTools(listed, fill, onSearch);
    const step = makeStep(listed, state);
    box.addEventListener('keydown', (event) => {
        const far = listed.shown.length;
        const steps = { ArrowDown: 1, ArrowUp: -1, PageDown: 12, PageUp: -12, Home: -far, End: far };
        if (!(event.key in steps)) return;
        event.preventDefault();
        step(steps[event.key]);
    });
    state.listen(({ chosen }, before) => {
        if (chosen === before.chosen) return;
        if (chosen && chosen.kind !== listed.kind) tools.show(chosen.kind);
        if (chosen && !listed.shown.some((item) => item.index === chosen.index)) {
            listed.onlyFailing = false;
            fill();
        }
        mark(chosen);
    });
    fill();
    const label = { class: 'finder', 'aria-label': 'Tiles and seams' };
    return { step, element: html('nav', label, tools.elements, box, elsewhere) };
}
