import './style.css';
import { readModel } from './data.js';
import { html } from './dom.js';
import { makeEnvelopeScene } from './envelope_scene.js';
import { makeEnvelopeShape, placeOfChosen } from './envelope_shape.js';
import { makeEnvelopePlain } from './envelope_plain.js';
import { degrees, percent } from './format.js';
import { legendView } from './legend.js';
import { makeList } from './list.js';
import { clothValue, mapOf, mapsOf } from './maps.js';
import { paletteNames } from './palette.js';
import { panelContent, spoken } from './panel.js';
import { pieceView } from './piece_view.js';
import { makeState } from './state.js';
import { basis, seamTable, tileTable } from './tables.js';
import { failingSeams, failingTiles, verdictView } from './verdict.js';

// WebGL where there is some, else pixel by pixel. A canvas that was asked for one cannot give the other.
function envelopeView(shape, holder) {
    const make = (maker) => {
        const canvas = html('canvas', {
            class: 'envelope',
            tabindex: '0',
            role: 'application',
            'aria-label':
                'The envelope in space. Arrow keys go from tile to tile, with shift they turn it, plus and minus zoom, Home shows all, Escape lets go.',
        });
        holder.replaceChildren(canvas);
        return { canvas, ...maker(shape, canvas), isPlain: maker === makeEnvelopePlain };
    };
    if (!document.createElement('canvas').getContext('webgl2')) return make(makeEnvelopePlain);
    try {
        return make(makeEnvelopeScene);
    } catch {
        return make(makeEnvelopePlain);
    }
}

function selectBox(label, options, onchange) {
    const box = html(
        'select',
        { onchange: () => onchange(box.value) },
        options.map(({ id, name }) => html('option', { value: id }, name)),
    );
    return html('label', { class: 'choice' }, html('span', {}, label), box);
}

function hoverWords({ tile, triangle, seam }) {
    const value = (key) => clothValue(tile, key, triangle);
    const words = [html('b', {}, tile.name)];
    if (seam) words.push(html('div', {}, `Seam ${seam.id}: ${seam.said.tile_a} – ${seam.said.tile_b}`));
    if (Number.isNaN(value('warp'))) words.push(html('div', {}, 'turned over on the cloth'));
    else if (value('warp') !== undefined)
        words.push(
            html('div', {}, `warp ${percent(value('warp') * 100)}, weft ${percent(value('weft') * 100)}`),
            html(
                'div',
                {},
                `shear ${degrees((value('shear') * 180) / Math.PI, 2)}, area ${percent(value('area') * 100)}`,
            ),
        );
    return words;
}

function start(model) {
    const shape = makeEnvelopeShape(model);
    const available = mapsOf(model);
    const preferred = failingTiles(model).length === 0 && failingSeams(model).length > 0 ? 'mismatch' : 'warp';
    const first = available.find((map) => map.id === preferred) ?? available[0] ?? mapOf('edges');
    const state = makeState({ map: first.id, palette: 'safe', chosen: null });

    const choose = (kind, item, isSeen) => {
        state.change({ chosen: { kind, index: item.index } });
        if (isSeen) return;
        if (kind === 'tile') view.lookAt(placeOfChosen(model, [item], null));
        else
            view.lookAt(
                placeOfChosen(
                    model,
                    item.sides.map((side) => model.tiles[side.tile]),
                    item,
                ),
            );
    };
    const onTile = (tile) => choose('tile', tile);
    const onSeam = (seam) => choose('seam', seam);

    const tiles = tileTable(model, onTile),
        seams = seamTable(model, onSeam);
    const onSearch = (text) => [tiles, seams].forEach((table) => table.search(text));
    const list = makeList(model, state, { onTile, onSeam, onSearch });
    const holder = html('div', { class: 'holder' });
    const legendPlace = html('div', { class: 'legend-place' });
    const panel = html('section', { class: 'panel', 'aria-label': 'The piece', tabindex: '0' });
    const tip = html('div', { class: 'tip', hidden: true, 'aria-hidden': 'true' });
    const live = html('p', { class: 'unseen', role: 'status' });
    const printed = html('section', { class: 'print-only' });
    const hint = html(
        'p',
        { class: 'hint' },
        'Click a tile or a seam. Drag turns, the wheel zooms. Keys: arrows go from tile to tile, with shift they turn; + and − zoom; Home shows all.',
    );
    const mapChoice = selectBox('Colours show', available, (map) => state.change({ map }));
    mapChoice.querySelector('select').value = state.now.map;
    const tools = html(
        'div',
        { class: 'tools' },
        mapChoice,
        selectBox('Palette', paletteNames, (palette) => state.change({ palette })),
        html('button', { onclick: () => view.home() }, 'Whole envelope'),
        html('button', { onclick: () => state.change({ chosen: null }) }, 'Let go'),
        failingTiles(model).length + failingSeams(model).length > 0 &&
            html('button', { class: 'next', onclick: nextFailing }, 'Next that fails'),
    );

    document
        .getElementById('page')
        .replaceChildren(
            verdictView(model, { onTile, onSeam }),
            html(
                'main',
                {},
                html(
                    'div',
                    { class: 'work' },
                    list.element,
                    html('section', { class: 'space', 'aria-label': 'The envelope' }, tools, holder, legendPlace, hint),
                    panel,
                ),
                printed,
                tiles.element,
                model.seams.length > 0 && seams.element,
                basis(model),
            ),
            tip,
            live,
        );
    const view = envelopeView(shape, holder);
    const { canvas } = view;
    if (view.isPlain) hint.prepend('This browser has no WebGL: the envelope is drawn more plainly. ');

    function nextFailing() {
        const failing = [
            ...failingTiles(model).map((item) => ['tile', item]),
            ...failingSeams(model).map((item) => ['seam', item]),
        ];
        const { chosen } = state.now;
        const at = failing.findIndex(([kind, item]) => chosen?.kind === kind && chosen.index === item.index);
        choose(...failing[(at + 1) % failing.length]);
    }

    const context = () => ({
        map: mapOf(state.now.map),
        palette: state.now.palette,
        onTile,
        onSeam,
        hover: null,
    });
    function showTip(words, event) {
        tip.hidden = !words;
        if (!words) return;
        tip.replaceChildren(...words);
        tip.style.left = `${Math.min(event.clientX + 14, window.innerWidth - tip.offsetWidth - 8)}px`;
        tip.style.top = `${Math.min(event.clientY + 14, window.innerHeight - tip.offsetHeight - 8)}px`;
    }
    const showPanel = () => {
        const { chosen } = state.now;
        const tile = chosen?.kind === 'tile' ? model.tiles[chosen.index] : null;
        const hover =
            tile && ((triangle, event) => showTip(triangle < 0 ? null : hoverWords({ tile, triangle }), event));
        panel.replaceChildren(
            ...[panelContent(shape, state.now, { ...context(), hover })].flat(Infinity).filter(Boolean),
        );
    };
    const showChosen = () => {
        const { chosen } = state.now;
        if (chosen?.kind === 'seam') {
            const seam = model.seams[chosen.index];
            view.choose(
                seam.sides.map((side) => model.tiles[side.tile]),
                seam,
            );
        } else view.choose(chosen ? [model.tiles[chosen.index]] : [], null);
        live.textContent = spoken(model, chosen);
    };
    const recolour = () => {
        view.recolour(mapOf(state.now.map), state.now.palette);
        legendPlace.replaceChildren(legendView(model, state.now));
    };
    state.listen((now, before) => {
        if (now.map !== before.map || now.palette !== before.palette) recolour();
        if (now.chosen !== before.chosen) showChosen();
        showPanel();
    });

    let pressed = null,
        hovered = null;
    const place = (event) => {
        const box = canvas.getBoundingClientRect();
        return [event.clientX - box.left, event.clientY - box.top];
    };
    canvas.addEventListener('pointerdown', (event) => {
        pressed = [event.clientX, event.clientY];
    });
    canvas.addEventListener('pointerup', (event) => {
        const wasDrag = !pressed || Math.hypot(event.clientX - pressed[0], event.clientY - pressed[1]) > 4;
        pressed = null;
        if (wasDrag) return;
        const found = view.pointed(...place(event));
        if (found?.seam) choose('seam', found.seam, true);
        else if (found) choose('tile', found.tile, true);
        else state.change({ chosen: null });
    });
    canvas.addEventListener('pointermove', (event) => {
        if (event.buttons) return showTip(null);
        if (!hovered)
            requestAnimationFrame(() => {
                const found = view.pointed(...place(hovered));
                canvas.style.cursor = found ? 'pointer' : 'grab';
                showTip(found && hoverWords(found), hovered);
                hovered = null;
            });
        hovered = event;
    });
    canvas.addEventListener('pointerleave', () => {
        tip.hidden = true;
    });
    panel.addEventListener('pointerleave', () => {
        tip.hidden = true;
    });
    canvas.addEventListener('keydown', (event) => {
        const turns = { ArrowLeft: [-0.15, 0], ArrowRight: [0.15, 0], ArrowUp: [0, 0.15], ArrowDown: [0, -0.15] };
        const keys = {
            ArrowRight: () => list.step(1),
            ArrowDown: () => list.step(1),
            ArrowLeft: () => list.step(-1),
            ArrowUp: () => list.step(-1),
            '+': () => view.zoom(0.85),
            '=': () => view.zoom(0.85),
            '-': () => view.zoom(1 / 0.85),
            Home: () => view.home(),
            Escape: () => state.change({ chosen: null }),
        };
        if (event.ctrlKey || event.metaKey || event.altKey) return;
        if (event.shiftKey && event.key in turns) view.turn(...turns[event.key]);
        else if (event.key in keys) keys[event.key]();
        else return;
        event.preventDefault();
    });

    // On paper: every row, and the pieces of the tiles that fail.
    window.addEventListener('beforeprint', () => {
        for (const table of [tiles, seams]) table.showWhole(true);
        for (const details of document.querySelectorAll('details')) details.open = true;
        const failing = failingTiles(model)
            .filter((tile) => tile.flat)
            .slice(0, 24);
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
        view.drawNow();
    });
    window.addEventListener('afterprint', () => {
        for (const table of [tiles, seams]) table.showWhole(false);
        printed.replaceChildren();
    });

    view.mark(failingTiles(model), failingSeams(model));
    recolour();
    showPanel();
    new ResizeObserver(() => {
        if (holder.clientWidth > 0 && !matchMedia('print').matches)
            view.resize(holder.clientWidth, holder.clientHeight);
    }).observe(holder);
    requestAnimationFrame(() => requestAnimationFrame(() => performance.mark('first-picture')));
}

readModel()
    .then(start)
    .catch((error) => {
        document
            .getElementById('page')
            .replaceChildren(
                html(
                    'p',
                    { role: 'alert', class: 'starting' },
                    `The report cannot be shown by this browser (${error.message}). The figures are in report.json, tiles.csv and seams.csv beside this page.`,
                ),
            );
        throw error;
    });
