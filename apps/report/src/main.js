// Connects the parts of the page.
import './style.css';
import { makePicture } from './envelope/picture.js';
import { poseTools } from './envelope/pose.js';
import { makeEnvelopeShape } from './envelope/shape.js';
import { steer } from './envelope/steering.js';
import { makePanel, spoken } from './piece/panel.js';
import { printWhole } from './piece/paper.js';
import { basis } from './tables/basis.js';
import { flightView } from './tables/flight_view.js';
import { makeList } from './tables/list.js';
import { rollView } from './tables/roll_view.js';
import { seamTable, tileTable } from './tables/tables.js';
import { failingSeams, failingTiles, verdictView } from './tables/verdict.js';
import { makeChooser } from './view/chooser.js';
import { readModel } from './view/data.js';
import { lookOf } from './view/maps.js';
import { layOut, makePlaces, sayItCannotBeShown } from './view/page.js';
import { makeState } from './view/state.js';
import { makeTip } from './view/tip.js';
import { makeTools } from './view/tools.js';

function start(model) {
    const shape = makeEnvelopeShape(model);
    const { map, tile } = model.first;
    const state = makeState({
        map,
        scale: null, // the map's own
        palette: model.palettes[0].id,
        chosen: tile < 0 ? null : { kind: 'tile', index: tile },
        pose: model.maps.find(({ id }) => id === map).in_flight ? 1 : 0, // of the way from drawn to inflated
        times: 1, // by how much what differs is enlarged
    });
    shape.pose(state.now.pose);
    const chooser = makeChooser(model, state);
    const { onTile, onSeam } = chooser;
    const tip = makeTip(),
        places = makePlaces();
    const context = () => ({ look: lookOf(model, state.now), onTile, onSeam, hover: null });
    const panel = makePanel(model, state, tip, context);
    const tiles = tileTable(model, onTile),
        seams = seamTable(model, onSeam),
        roll = rollView(model, state, onTile);
    const onSearch = (text) => [tiles, seams].forEach((table) => table.search(text));
    const list = makeList(model, state, { onTile, onSeam, onSearch });
    layOut(places, {
        verdict: verdictView(model, { onTile, onSeam }),
        list: list.element,
        above: [makeTools(model, state, chooser, () => picture.home()), poseTools(shape, state)],
        panel: panel.element,
        below: [
            flightView(model, onTile),
            roll?.element,
            tiles.element,
            model.seams.length > 0 && seams.element,
            basis(model),
        ],
        tip: tip.element,
    });
    const picture = makePicture(shape, state, places, chooser.chosen);
    picture.mark(failingTiles(model), failingSeams(model));
    chooser.onChosen = (kind, item, isSeen) => {
        panel.reveal();
        if (!isSeen) picture.lookAtChosen();
    };
    state.listen((now, before) => {
        if (now.pose !== before.pose || now.times !== before.times) return;
        if (now.chosen !== before.chosen) places.live.textContent = spoken(model, now.chosen);
        panel.show();
    });
    panel.show();
    steer(picture, { step: list.step, showTip: tip.show, onFound: chooser.onFound });
    printWhole(model, picture, [tiles, seams, roll].filter(Boolean), places.printed, context);
    requestAnimationFrame(() => requestAnimationFrame(() => performance.mark('first-picture')));
}

readModel()
    .then(start)
    .catch((error) => {
        sayItCannotBeShown(error);
        throw error;
    });
