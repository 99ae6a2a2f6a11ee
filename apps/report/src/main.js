import './style.css';
import { readModel } from './data.js';
import { html } from './dom.js';
import { makeEnvelopeScene } from './envelope_scene.js';
import { makeEnvelopeShape, placeOfChosen } from './envelope_shape.js';
import { makeEnvelopePlain } from './envelope_plain.js';
import { flightView, poseTools, poseWords } from './flight_view.js';
import { legendView } from './legend.js';
import { makeList } from './list.js';
import { firstMap, mapOf, mapsOf } from './maps.js';
import { paletteNames } from './palette.js';
import { panelContent, spoken } from './panel.js';
import { printWhole } from './paper.js';
import { rollView } from './roll_view.js';
import { makeState } from './state.js';
import { steer } from './steering.js';
import { basis, seamTable, tileTable } from './tables.js';
import { hoverWords, makeTip } from './tip.js';
import { failingSeams, failingTiles, verdictView } from './verdict.js';

// WebGL where there is some, else pixel by pixel. A canvas that was asked for one cannot give the other.
function envelopeView(shape, holder) {
    const make = (maker) => {
        const canvas = html('canvas', {
            class: 'envelope',
            tabindex: '0',
            role: 'application',
            'aria-label':
                'The envelope in space. Arrow keys go from tile to tile, with shift they turn it, plus and minus zoom, Home shows all, Escape chooses nothing.',
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

const optionElement = ({ id, name }) => html('option', { value: id }, name);

// The maps of the pieces and those of the flight apart, where there are both.
function mapGroups(available) {
    const groups = [
        { name: 'As cut', options: available.filter((map) => !map.inFlight) },
        { name: 'In flight', options: available.filter((map) => map.inFlight) },
    ];
    return groups.every((group) => group.options.length > 0) ? groups : available;
}

function selectBox(label, options, onchange) {
    const box = html(
        'select',
        { onchange: () => onchange(box.value) },
        options.map((option) =>
            option.options
                ? html('optgroup', { label: option.name }, option.options.map(optionElement))
                : optionElement(option),
        ),
    );
    return html('label', { class: 'choice' }, html('span', {}, label), box);
}

function start(model) {
    const shape = makeEnvelopeShape(model);
    const available = mapsOf(model);
    const first = firstMap(model, available);
    const pose = first.inFlight ? 1 : 0;
    const state = makeState({ map: first.id, palette: 'safe', chosen: null, pose, times: 1 });
    shape.pose(state.now.pose);

    // What was clicked is shown in the panel, which may be off the screen: on a telephone, or from the tables.
    let isByKey = false;
    for (const type of ['keydown', 'pointerdown'])
        window.addEventListener(type, () => (isByKey = type === 'keydown'), { capture: true });
    const reveal = () => {
        const { top, bottom } = panel.getBoundingClientRect();
        if (!isByKey && (top > 0.8 * window.innerHeight || bottom < 0.3 * window.innerHeight))
            panel.scrollIntoView({ block: 'start' });
    };
    const choose = (kind, item, isSeen) => {
        state.change({ chosen: { kind, index: item.index } });
        reveal();
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
    const posePlace = html('p', { class: 'pose-words' });
    const panel = html('section', { class: 'panel', 'aria-label': 'The piece', tabindex: '0' });
    const tip = makeTip();
    const live = html('p', { class: 'unseen', role: 'status' });
    const printed = html('section', { class: 'print-only' });
    const hint = html(
        'p',
        { class: 'hint' },
        'Click a tile or a seam. Drag turns; once clicked, the wheel zooms (before, with Ctrl). Keys: arrows go from tile to tile, with shift they turn; + and − zoom; Home shows all.',
    );
    const mapChoice = selectBox('Colours show', mapGroups(available), (map) => state.change({ map }));
    mapChoice.querySelector('select').value = state.now.map;
    const tools = html(
        'div',
        { class: 'tools' },
        mapChoice,
        selectBox('Palette', paletteNames, (palette) => state.change({ palette })),
        html('button', { onclick: () => view.home() }, 'Whole envelope'),
        html('button', { onclick: () => state.change({ chosen: null }) }, 'Choose nothing'),
        failingTiles(model).length + failingSeams(model).length > 0 &&
            html('button', { class: 'next', onclick: nextFailing }, 'Next that fails'),
    );

    const roll = rollView(model, state, onTile);
    const verdict = verdictView(model, { onTile, onSeam });
    document
        .getElementById('page')
        .replaceChildren(
            verdict,
            html(
                'main',
                {},
                html(
                    'div',
                    { class: 'work' },
                    list.element,
                    html(
                        'section',
                        { class: 'space', 'aria-label': 'The envelope' },
                        tools,
                        poseTools(shape, state),
                        legendPlace,
                        holder,
                        posePlace,
                        hint,
                    ),
                    panel,
                ),
                printed,
                flightView(model, onTile),
                roll?.element,
                tiles.element,
                model.seams.length > 0 && seams.element,
                basis(model),
            ),
            tip.element,
            live,
        );
    const view = envelopeView(shape, holder);
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
    const showPanel = () => {
        const { chosen } = state.now;
        const tile = chosen?.kind === 'tile' ? model.tiles[chosen.index] : null;
        const hover =
            tile && ((triangle, event) => tip.show(triangle < 0 ? null : hoverWords({ tile, triangle }), event));
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
    // Once a picture, however often the slider says that it was moved.
    let isPosing = false;
    const repose = () => {
        posePlace.textContent = poseWords(state.now);
        if (isPosing) return;
        isPosing = true;
        requestAnimationFrame(() => {
            isPosing = false;
            shape.pose(state.now.pose * state.now.times);
            view.repose();
        });
    };
    state.listen((now, before) => {
        if (now.pose !== before.pose || now.times !== before.times) return repose();
        if (now.map !== before.map || now.palette !== before.palette) recolour();
        if (now.chosen !== before.chosen) showChosen();
        showPanel();
    });

    steer(view, {
        step: list.step,
        showTip: tip.show,
        onFound: (found) => {
            if (found?.seam) choose('seam', found.seam, true);
            else if (found) choose('tile', found.tile, true);
            else state.change({ chosen: null });
        },
    });
    panel.addEventListener('pointerleave', () => tip.show(null));
    printWhole(shape, view, [tiles, seams, roll].filter(Boolean), printed, context);

    view.mark(failingTiles(model), failingSeams(model));
    recolour();
    showPanel();
    posePlace.textContent = poseWords(state.now);
    new ResizeObserver(() => {
        if (holder.clientWidth > 0 && !matchMedia('print').matches)
            view.resize(holder.clientWidth, holder.clientHeight);
    }).observe(holder);
    new ResizeObserver(() =>
        document.documentElement.style.setProperty('--verdict', `${verdict.offsetHeight}px`),
    ).observe(verdict);
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
