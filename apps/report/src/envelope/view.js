// The picture of the envelope: with WebGL if available, else pixel by pixel.
import { html } from '../view/dom.js';
import { makeEnvelopePlain } from './plain.js';
import { makeEnvelopeScene } from './scene.js';

const label =
    'The envelope in space. Arrow keys go from tile to tile, with shift they turn it, plus and minus zoom, ' +
    'Home shows all, Escape chooses nothing.';

// A canvas that was asked for WebGL cannot give a 2D context, so each has its own canvas.
export function makeEnvelopeView(shape, holder) {
    const make = (maker) => {
        const canvas = html('canvas', { class: 'envelope', tabindex: '0', role: 'application', 'aria-label': label });
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
