// A chart of the distance between the two sides along a seam.
import { html, svg } from '../view/dom.js';
import { figure, millimetres } from '../view/format.js';

// A line from notch to notch over a band that shows the limit.
export function driftChart(seam) {
    const { said } = seam;
    const points = [{ at_mm: 0, drift_mm: 0 }, ...said.notches, { at_mm: said.length_mm, drift_mm: said.mismatch_mm }];
    const top = 1.15 * Math.max(said.limit_mm, ...points.map((point) => Math.abs(point.drift_mm)), said.drift_max_mm);
    const x = (at) => 52 + (at / said.length_mm) * 340,
        y = (drift) => 50 - (drift / top) * 42;
    const worst = points.reduce((most, point) =>
        Math.abs(point.drift_mm) > Math.abs(most.drift_mm) ? point : most,
    );
    const number = (text, at, height, anchor) => svg('text', { x: at, y: height, 'text-anchor': anchor }, text);
    return html(
        'figure',
        { class: 'drift' },
        svg(
            'svg',
            {
                viewBox: '0 0 400 112',
                role: 'img',
                'aria-label': `The sides are at most ${figure(said.drift_max_mm, 2)} mm apart`,
            },
            svg('rect', {
                class: 'allowed',
                x: 52,
                width: 340,
                y: y(said.limit_mm),
                height: y(-said.limit_mm) - y(said.limit_mm),
            }),
            svg('line', { class: 'axis', x1: 52, x2: 392, y1: 50, y2: 50 }),
            y(0) - y(said.limit_mm) > 11
                ? [
                      number(figure(said.limit_mm, 2, true), 48, y(said.limit_mm) + 3, 'end'),
                      number('0', 48, 53, 'end'),
                      number(`${figure(-said.limit_mm, 2)} mm`, 48, y(-said.limit_mm) + 3, 'end'),
                  ]
                : number(`±${millimetres(said.limit_mm, 2)}`, 48, 53, 'end'),
            number('start', 52, 109, 'middle'),
            number(millimetres(said.length_mm, 0), 392, 109, 'end'),
            svg('polyline', {
                class: said.ok ? 'ok' : 'bad',
                points: points.map((point) => `${x(point.at_mm)},${y(point.drift_mm)}`).join(' '),
            }),
            points.slice(1, -1).map((point) => svg('circle', { cx: x(point.at_mm), cy: y(point.drift_mm), r: 2.5 })),
            svg('circle', { class: 'start', cx: x(0), cy: 50, r: 4 }),
            !said.ok &&
                number(
                    `${figure(worst.drift_mm, 2, true)} mm`,
                    Math.min(392, Math.max(90, x(worst.at_mm))),
                    y(worst.drift_mm) + (worst.drift_mm > 0 ? 14 : -8),
                    'end',
                ),
        ),
        html(
            'figcaption',
            {},
            `How far ${said.tile_a === said.tile_b ? 'the second side' : said.tile_b} is ahead along the seam, ` +
                `from its start (the ring, on both pieces too) on, from notch to notch; ` +
                `the band is what is allowed, ±${millimetres(said.limit_mm, 2)}.`,
        ),
    );
}
