// The slider from drawn to inflated.
import { html } from '../view/dom.js';

// The slider, and the factor that enlarges differences. Null if nothing was inflated.
export function poseTools(shape, state) {
    if (!shape.hasFlight) return null;
    const words = () => poseWords(state.now) || 'as drawn';
    const slider = html('input', {
        type: 'range',
        id: 'pose',
        min: '0',
        max: '100',
        step: '1',
        value: String(100 * state.now.pose),
        'aria-label': 'From drawn to inflated',
        'aria-valuetext': words(),
        oninput: () => {
            state.change({ pose: Number(slider.value) / 100 });
            slider.setAttribute('aria-valuetext', words());
        },
    });
    const times = html(
        'select',
        { onchange: () => state.change({ times: Number(times.value) }) },
        [1, 5, 20].map((factor) => html('option', { value: String(factor) }, `${factor}×`)),
    );
    return html(
        'div',
        { class: 'pose' },
        html(
            'label',
            { class: 'choice', for: 'pose' },
            html('span', {}, 'Drawn'),
            slider,
            html('span', {}, 'inflated'),
        ),
        html('label', { class: 'choice' }, html('span', {}, 'Differences'), times),
    );
}

// The caption of the pose, unless it is the drawing itself.
export function poseWords({ pose, times }) {
    if (pose === 0) return '';
    const way =
        pose === 1 ? 'Shown as inflated' : `Shown ${Math.round(100 * pose)} % of the way from drawn to inflated`;
    return times === 1 ? way : `${way}, what differs enlarged ${times} times`;
}
