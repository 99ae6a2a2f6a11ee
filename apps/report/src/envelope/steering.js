// Pointer and keys in the picture of the envelope: a click picks an item; dragging is left to the view.
import { hoverWords } from '../view/tip.js';
import { zoomByWheel } from '../view/wheel.js';

export function steer(view, { step, showTip, onFound }) {
    const { canvas } = view;
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
        onFound(view.pointed(...place(event)));
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
    canvas.addEventListener('pointerleave', () => showTip(null));
    zoomByWheel(canvas, view.isPlain ? view.zoom : null);
    canvas.addEventListener('keydown', (event) => {
        const turns = { ArrowLeft: [-0.15, 0], ArrowRight: [0.15, 0], ArrowUp: [0, 0.15], ArrowDown: [0, -0.15] };
        const keys = {
            ArrowRight: () => step(1),
            ArrowDown: () => step(1),
            ArrowLeft: () => step(-1),
            ArrowUp: () => step(-1),
            '+': () => view.zoom(0.85),
            '=': () => view.zoom(0.85),
            '-': () => view.zoom(1 / 0.85),
            Home: () => view.home(),
            Escape: () => onFound(null),
        };
        if (event.ctrlKey || event.metaKey || event.altKey) return;
        if (event.shiftKey && event.key in turns) view.turn(...turns[event.key]);
        else if (event.key in keys) keys[event.key]();
        else return;
        event.preventDefault();
    });
}
