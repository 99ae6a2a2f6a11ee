// Zoom for the drawing of a piece.
import { html } from '../view/dom.js';
import { zoomByWheel } from '../view/wheel.js';

const zoomStep = 1.25;

// The wheel, two fingers, + and - zoom; dragging and the arrow keys move; Home or a double click shows everything
// again.
function addZoom(drawing, home, onFirstZoom) {
    let box = [...home],
        isZoomed = false;
    const fingers = new Map(); // where on the screen each is that is down
    const set = (next) => drawing.setAttribute('viewBox', (box = next).join(' '));
    const at = ({ clientX, clientY }) =>
        new DOMPoint(clientX, clientY).matrixTransform(drawing.getScreenCTM().inverse());
    const zoom = (factor, p = { x: box[0] + box[2] / 2, y: box[1] + box[3] / 2 }) => {
        if (box[2] * factor > 1.5 * home[2] || box[2] * factor < home[2] / 200) return;
        if (!isZoomed) onFirstZoom();
        isZoomed = true;
        set([p.x - (p.x - box[0]) * factor, p.y - (p.y - box[1]) * factor, box[2] * factor, box[3] * factor]);
    };
    const move = (right, down) => set([box[0] + right, box[1] + down, box[2], box[3]]);
    const showAll = () => set([...home]);
    const apart = () => {
        const [one, other] = [...fingers.values()];
        return Math.hypot(one.clientX - other.clientX, one.clientY - other.clientY);
    };
    zoomByWheel(drawing, (factor, event) => zoom(factor, at(event)));
    drawing.addEventListener('pointerdown', (event) => fingers.set(event.pointerId, event));
    for (const type of ['pointerup', 'pointercancel', 'pointerleave'])
        drawing.addEventListener(type, (event) => fingers.delete(event.pointerId));
    drawing.addEventListener('pointermove', (event) => {
        if (!fingers.has(event.pointerId) || !(event.buttons & 1)) return;
        const from = at(fingers.get(event.pointerId)),
            before = fingers.size === 2 ? apart() : 0;
        fingers.set(event.pointerId, event);
        const to = at(event);
        if (fingers.size === 2) zoom(before / Math.max(1, apart()), to);
        else move(from.x - to.x, from.y - to.y);
    });
    drawing.addEventListener('dblclick', showAll);
    const keys = {
        '+': () => zoom(1 / zoomStep),
        '=': () => zoom(1 / zoomStep),
        '-': () => zoom(zoomStep),
        Home: showAll,
        ArrowLeft: () => move(-box[2] / 10, 0),
        ArrowRight: () => move(box[2] / 10, 0),
        ArrowUp: () => move(0, -box[3] / 10),
        ArrowDown: () => move(0, box[3] / 10),
    };
    drawing.addEventListener('keydown', (event) => {
        if (!(event.key in keys) || event.ctrlKey || event.metaKey || event.altKey) return;
        event.preventDefault();
        keys[event.key]();
    });
    return keys;
}

// The drawing with zoom buttons; `onFirstZoom` is called before the first zoom.
export function withButtons(drawing, home, name, onFirstZoom) {
    const keys = addZoom(drawing, home, onFirstZoom);
    const button = (words, label, key) =>
        html('button', { 'aria-label': `${label} ${name}`, title: label, onclick: keys[key] }, words);
    return html(
        'div',
        { class: 'piece-holder' },
        drawing,
        html(
            'span',
            { class: 'zoom' },
            button('+', 'Zoom in on', '+'),
            button('−', 'Zoom out of', '-'),
            button('⤢', 'Show all of', 'Home'),
        ),
    );
}
