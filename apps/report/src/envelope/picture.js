// Keeps the picture of the envelope up to date with the state: the chosen item, the colours, the pose.
import { legendView } from '../view/legend.js';
import { lookOf } from '../view/maps.js';
import { poseWords } from './pose.js';
import { isSeenFromHome, placeOfChosen } from './shape.js';
import { makeEnvelopeView } from './view.js';

// At most once per picture, however often the slider fires.
function makeRepose(shape, view, state, place) {
    let isPosing = false;
    return () => {
        place.textContent = poseWords(state.now);
        if (isPosing) return;
        isPosing = true;
        requestAnimationFrame(() => {
            isPosing = false;
            shape.pose(state.now.pose * state.now.times);
            view.repose();
        });
    };
}

// `places`: from makePlaces; `chosen()` returns [tiles, seam].
export function makePicture(shape, state, places, chosen) {
    const view = makeEnvelopeView(shape, places.holder);
    if (view.isPlain) places.hint.prepend('This browser has no WebGL: the envelope is drawn more plainly. ');
    const repose = makeRepose(shape, view, state, places.pose);
    const recolour = () => {
        const look = lookOf(shape.model, state.now);
        view.recolour(look);
        places.legend.replaceChildren(legendView(look));
    };
    const lookAtChosen = () => view.lookAt(placeOfChosen(shape.model, ...chosen()));
    // The first chosen item is visible, unless it is the only one of its kind and at the back.
    const [[first]] = chosen();
    let showFirst = () => {
        if (first && !isSeenFromHome(first)) lookAtChosen();
        showFirst = () => {};
    };
    state.listen((now, before) => {
        if (now.pose !== before.pose || now.times !== before.times) repose();
        if (['map', 'scale', 'palette'].some((key) => now[key] !== before[key])) recolour();
        if (now.chosen !== before.chosen) view.choose(...chosen());
    });
    recolour();
    view.choose(...chosen());
    places.pose.textContent = poseWords(state.now);
    new ResizeObserver(() => {
        const { clientWidth, clientHeight } = places.holder;
        if (clientWidth > 0 && !matchMedia('print').matches) view.resize(clientWidth, clientHeight);
        showFirst();
    }).observe(places.holder);
    return { ...view, lookAtChosen };
}
