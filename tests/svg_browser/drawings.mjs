// Generates random SVG drawings: every element that draws lines, every unit, every transform, groups, uses,
// symbols, nested viewports and style sheets. The same seed gives the same drawings.

function randomFrom(seed) {
    let state = seed >>> 0;
    const next = () => {
        // mulberry32
        state = (state + 0x6d2b79f5) >>> 0;
        let t = Math.imul(state ^ (state >>> 15), state | 1);
        t ^= t + Math.imul(t ^ (t >>> 7), t | 61);
        return ((t ^ (t >>> 14)) >>> 0) / 4294967296;
    };
    return {
        next,
        between: (low, high) => low + (high - low) * next(),
        whole: (low, high) => low + Math.floor((high - low + 1) * next()),
        one: (list) => list[Math.floor(list.length * next())],
        is: (share) => next() < share,
    };
}

const perMm = 96 / 25.4;
const sizes = { '': 1, px: 1, mm: perMm, cm: 10 * perMm, in: 96, pt: 96 / 72, pc: 16, Q: perMm / 4, em: 20 };

const attributes = (values) =>
    Object.entries(values)
        .map(([key, value]) => ` ${key}="${value}"`)
        .join('');

class Maker {
    constructor(seed) {
        this.random = randomFrom(seed);
        this.ids = 0;
        this.defs = [];
        this.rules = [];
        this.targets = [];
    }

    number(value) {
        const { random } = this;
        const text = value.toFixed(random.whole(1, 4));
        if (random.is(0.1)) {
            const exponential = Number(value.toPrecision(5)).toExponential();
            return random.is(0.5) ? exponential : exponential.replace('e', 'E');
        }
        if (random.is(0.05) && value > 0) return '+' + text;
        return random.is(0.3) ? text.replace(/^(-?)0\./, '$1.') : text;
    }

    // A length of about `value` user units, in a random unit.
    length(value, whole) {
        const { random } = this;
        if (whole && random.is(0.15)) return this.number((100 * value) / whole) + '%';
        const unit = random.is(0.4) ? '' : random.one(Object.keys(sizes));
        return this.number(value / sizes[unit]) + unit;
    }

    transform(share = 0.5) {
        const { random } = this;
        if (!random.is(share)) return '';
        const far = this.size / 8;
        const parts = Array.from({ length: random.whole(1, 3) }, () =>
            random.one([
                () => `translate(${this.number(random.between(-far, far))} ${this.number(random.between(-far, far))})`,
                () => `translate(${this.number(random.between(-far, far))})`,
                () => `scale(${this.number(random.between(0.5, 1.6))})`,
                () => `scale(${this.number(random.between(0.5, 1.6))},${this.number(-random.between(0.5, 1.6))})`,
                () => `rotate(${this.number(random.between(-180, 180))})`,
                () => `rotate(${this.number(random.between(-90, 90))},${this.number(far)},${this.number(far)})`,
                () => `skewX(${this.number(random.between(-30, 30))})`,
                () => `skewY(${this.number(random.between(-30, 30))})`,
                () => {
                    const [a, b, c, d] = [1, 0.2, -0.3, 1].map((mean) => mean + random.between(-0.3, 0.3));
                    return `matrix(${[a, b, c, d, random.between(-far, far), 3].map((n) => this.number(n)).join(' ')})`;
                },
            ])(),
        );
        return ` transform="${parts.join(random.one([' ', ', ', '']))}"`;
    }

    pathData() {
        const { random } = this;
        const n = () => this.number(random.between(0, this.size));
        const step = () => this.number(random.between(-this.size / 4, this.size / 4));
        const radius = () => this.number(random.between(this.size / 50, this.size / 4));
        const flag = () => random.whole(0, 1);
        const commands = [
            () => `L${n()} ${n()}`,
            () => `l${step()},${step()} ${step()} ${step()}`,
            () => `H${n()}`,
            () => `h${step()} ${step()}`,
            () => `V${n()}`,
            () => `v${step()}`,
            () => `C${n()} ${n()} ${n()} ${n()} ${n()} ${n()}`,
            () => `c${step()} ${step()} ${step()} ${step()} ${step()} ${step()}`,
            () => `S${n()} ${n()} ${n()} ${n()}`,
            () => `s${step()} ${step()} ${step()} ${step()}`,
            () => `Q${n()} ${n()} ${n()} ${n()}`,
            () => `q${step()} ${step()} ${step()} ${step()} ${step()} ${step()} ${step()} ${step()}`,
            () => `T${n()} ${n()}`,
            () => `t${step()} ${step()}`,
            () => `A${radius()} ${radius()} ${step()} ${flag()} ${flag()} ${n()} ${n()}`,
            () => `a${radius()} ${radius()} ${step()} ${flag()}${flag()}${step()} ${step()}`,
        ];
        let data = `M${n()} ${n()}`;
        const count = random.whole(2, 7);
        for (let i = 0; i < count; ++i) data += random.one(['', ' ', '\n']) + random.one(commands)();
        if (random.is(0.4)) data += random.one(['z', 'Z']);
        if (random.is(0.2)) data += `m${step()} ${step()} ${step()} ${step()}` + random.one(commands)();
        // A minus needs no blank before it.
        return random.is(0.5) ? data.replace(/ -/g, '-') : data;
    }

    shape() {
        const { random } = this;
        const [w, h] = this.viewport;
        const both = Math.hypot(w, h) / Math.SQRT2;
        const at = () => random.between(0, this.size * 0.7);
        const extent = () => random.between(this.size / 20, this.size / 3);
        const kind = random.one([
            'path',
            'path',
            'path',
            'rect',
            'rect',
            'circle',
            'ellipse',
            'line',
            'polyline',
            'polygon',
        ]);
        const is = this.look();
        if (random.is(0.05))
            this.rules.push(
                `#e${this.ids} { ` +
                    `transform-origin: ${random.one(['9px 5mm', 'center', '20% bottom', 'right', 'TOP LEFT'])}; ` +
                    `transform-box: ${random.one(['view-box', 'fill-box'])} }`,
            );
        if (kind === 'path') return `<path${is} d="${this.pathData()}"/>`;
        if (kind === 'rect') {
            const rounded = random.one([
                () => '',
                () => ` rx="${this.length(extent() / 3, w)}"`,
                () => ` ry="${this.length(extent() / 3, h)}"`,
                () => ` rx="${this.length(extent(), w)}" ry="${this.length(extent() / 4, h)}"`,
            ])();
            return (
                `<rect${is} x="${this.length(at(), w)}" y="${this.length(at(), h)}" ` +
                `width="${this.length(extent(), w)}" height="${this.length(extent(), h)}"${rounded}/>`
            );
        }
        if (kind === 'circle')
            return `<circle${is}${attributes({
                cx: this.length(at(), w),
                cy: this.length(at(), h),
                r: this.length(extent() / 2, both),
            })}/>`;
        if (kind === 'ellipse')
            return (
                `<ellipse${is} cx="${this.length(at(), w)}" cy="${this.length(at(), h)}" ` +
                `rx="${this.length(extent() / 2, w)}"` +
                `${random.is(0.2) ? '' : attributes({ ry: this.length(extent() / 2, h) })}/>`
            );
        if (kind === 'line')
            return (
                `<line${is} x1="${this.length(at(), w)}" y1="${this.length(at(), h)}" ` +
                `x2="${this.length(at(), w)}" y2="${this.length(at(), h)}"/>`
            );
        const points = Array.from({ length: random.whole(2, 6) }, () => `${this.number(at())},${this.number(at())}`);
        return `<${kind}${is} points="${points.join(' ')}"/>`;
    }

    // The name and the visibility of an element.
    look() {
        const { random } = this;
        const id = `e${++this.ids}`;
        let text = ` id="${id}"` + this.transform(0.4);
        if (random.is(0.3)) text += ` class="${random.one(['cut', 'sew', 'cut fold'])}"`;
        const hidden = [
            ' display="none"',
            ' style="display: none"',
            ' style="visibility:hidden"',
            ' visibility="hidden"',
        ];
        const shown = [' style="fill:none; stroke : red"', ' visibility="visible"'];
        if (random.is(0.15)) text += random.one(random.is(0.5) ? hidden : shown);
        if (random.is(0.05))
            this.rules.push(`#${id} { ${random.one(['display: none', 'visibility: hidden', 'display:inline'])} }`);
        if (random.is(0.05))
            this.rules.push(
                `#${id} { transform: ` +
                    `${random.one(['rotate(0.1turn)', 'translateX(3mm) scale(1.2)', 'skew(10deg, 0.1rad)'])}; }`,
            );
        return text;
    }

    text() {
        const { random } = this;
        const at = () => random.between(0, this.size * 0.7);
        const size = random.one([
            'font-size="1.5em"',
            'font-size="large"',
            'style="font-size:12px"',
            'font-size="80%"',
            'font-size="4mm"',
            '',
        ]);
        const [w, h] = this.viewport;
        const place = attributes({ x: `${this.length(at(), w)} ${this.length(at(), w)}`, y: this.length(at(), h) });
        const span = random.is(0.3)
            ? `<tspan x="${this.length(at(), w)}" dy="1.2em" ` +
              `font-size="${random.one(['70%', '2em', 'smaller'])}">s</tspan>`
            : '';
        return `<text${this.transform(0.4)}${place} ${size}>P${++this.ids}${span}</text>`;
    }

    use() {
        const { random } = this;
        if (this.targets.length === 0) return this.shape();
        const [w, h] = this.viewport;
        const at = () => this.length(random.between(-this.size / 6, this.size / 6), w);
        const target = random.one(this.targets);
        const extent = (whole) => this.length(random.between(this.size / 4, this.size), whole);
        const size = target.startsWith('s') ? attributes({ width: extent(w), height: extent(h) }) : '';
        const key = random.one(['href', 'xlink:href']);
        const place = attributes({ id: `u${++this.ids}`, [key]: `#${target}`, x: at(), y: at() });
        return `<use${place}${random.is(0.7) ? size : ''}${this.transform(0.4)}/>`;
    }

    content(depth, count) {
        const { random } = this;
        let text = '';
        for (let i = 0; i < count; ++i) {
            const kind = random.next();
            if (kind < 0.6 || depth > 3) text += this.shape();
            else if (kind < 0.65) text += this.text();
            else if (kind < 0.75) text += this.use();
            else if (kind < 0.85) text += `<g${this.look()}>${this.content(depth + 1, random.whole(1, 3))}</g>`;
            else if (kind < 0.88) text += `<a${this.transform()}><g>${this.content(depth + 1, 2)}</g></a>`;
            else if (kind < 0.91) text += this.choice(depth);
            else text += this.nested(depth);
            text += '\n';
        }
        return text;
    }

    choice(depth) {
        const other = this.random.is(0.5) ? '<line x1="1" y1="1" x2="9" y2="9" systemLanguage="de"/>' : '';
        return (
            `<switch><rect width="5" height="5" requiredExtensions="http://example.org/none"/>${other}` +
            `<g>${this.content(depth + 1, 1)}</g>${this.shape()}</switch>`
        );
    }

    ratio() {
        const { random } = this;
        if (random.is(0.3)) return '';
        const align = random.is(0.2)
            ? 'none'
            : `x${random.one(['Min', 'Mid', 'Max'])}Y${random.one(['Min', 'Mid', 'Max'])}`;
        return ` preserveAspectRatio="${align}${random.one(['', ' meet', ' slice'])}"`;
    }

    // The content stays inside, or overflow is visible: parts that are cut off would be reported and not drawn.
    nested(depth) {
        const { random } = this;
        const around = this.viewport;
        const [w, h] = around;
        const [width, height] = [random.between(this.size / 4, this.size), random.between(this.size / 4, this.size)];
        const place = attributes({
            overflow: 'visible',
            x: this.length(random.between(0, this.size / 4), w),
            y: this.length(random.between(0, this.size / 4), h),
            width: this.number(width),
            height: this.number(height),
        });
        let text = `<svg${place}`;
        this.viewport = [width, height];
        if (random.is(0.7)) {
            const box = [
                random.between(-20, 20),
                random.between(-20, 20),
                this.size * random.between(0.7, 1.5),
                this.size * random.between(0.7, 1.5),
            ];
            const shown = box.map((n) => Number(n.toFixed(2)));
            text += ` viewBox="${shown.join(random.one([' ', ',']))}"` + this.ratio();
            this.viewport = shown.slice(2);
        }
        text += `>${this.content(depth + 1, 2)}</svg>`;
        this.viewport = around;
        return text;
    }

    define() {
        const { random } = this;
        this.defs.push(`<path id="p1" d="${this.pathData()}"/>`);
        this.defs.push(`<g id="g1"${this.transform()}>${this.shape()}${this.shape()}</g>`);
        // Inside a symbol, per cent refer to its own viewBox.
        const around = this.viewport;
        this.viewport = [80, 60];
        const view = 'overflow="visible" viewBox="0 0 80 60"' + this.ratio();
        this.defs.push(
            `<symbol id="s1" x="${random.whole(0, 9)}" ${view}>${this.shape()}` +
                '<circle cx="50%" cy="10" r="10%"/></symbol>',
        );
        this.viewport = around;
        const use = `<use href="#p1" x="${this.number(random.between(0, 20))}"/>`;
        this.defs.push(`<g id="g2">${use}<use xlink:href="#g1" transform="scale(.7)"/></g>`);
        this.targets = ['p1', 'g1', 's1', 'g2'];
    }

    drawing(page) {
        const { random } = this;
        this.size = page.size;
        this.viewport = page.viewport;
        this.define();
        const body = this.content(0, random.whole(5, 10));
        this.rules.push(
            '.fold { stroke: blue; rx: 2px; ry: 5 }',
            'rect.sew { RX: .5em; width: -5px; x: 3% !important }',
            'circle.cut { r: 2mm; cx: 9; Visibility: VISIBLE }',
            'a > .cut { visibility: hidden }',
            'g > .sew { stroke-width: 2 }',
            'svg.page { width: 150mm; height: 100mm }',
            '@media print { path { display: none } }',
        );
        const sheet = `<style><![CDATA[/* <path> */ ${this.rules.join('\n')}]]></style>`;
        const font = random.one(['font-size="20"', 'style="font-size:20px"', 'font-size="15pt"']);
        return (
            '<svg xmlns="http://www.w3.org/2000/svg" xmlns:xlink="http://www.w3.org/1999/xlink" ' +
            `${font} ${page.text}>\n<defs>${sheet}${this.defs.join('\n')}</defs>\n${body}</svg>\n`
        );
    }
}

function pageOf(random) {
    return random.one([
        () => ({ text: 'width="210mm" height="297mm" viewBox="0 0 210 297"', size: 200, viewport: [210, 297] }),
        () => ({ text: 'width="210mm" height="297mm"', size: 700, viewport: [210 * perMm, 297 * perMm] }),
        () => ({
            text: 'width="30cm" height="20cm" viewBox="-1000 -500 30000 20000"',
            size: 19000,
            viewport: [30000, 20000],
        }),
        () => ({ text: 'width="8in" height="8in" viewBox="0 0 80 80"', size: 75, viewport: [80, 80] }),
        () => ({
            text: 'width="100mm" height="150mm" viewBox="10 20 200 150" preserveAspectRatio="none"',
            size: 150,
            viewport: [200, 150],
        }),
        () => ({
            text: 'width="1200mm" height="600mm" viewBox="0 0 300 300" preserveAspectRatio="xMinYMax slice"',
            size: 280,
            viewport: [300, 300],
        }),
        () => ({ text: 'width="400mm" height="300mm" viewBox="0 0 300 300"', size: 280, viewport: [300, 300] }),
        () => ({ text: 'width="500" height="400"', size: 380, viewport: [500, 400] }),
        () => ({ text: 'width="90pt" height="12pc" viewBox="0 0 45 72"', size: 60, viewport: [45, 72] }),
        () => ({ text: 'class="page" viewBox="0 0 300 200" width="3"', size: 190, viewport: [300, 200] }),
        () => ({ text: 'width="40em" height="30em" viewBox="5 5 400 300"', size: 280, viewport: [400, 300] }),
        () => ({ text: 'width="80%" height="100%" viewBox="5 5 400 300"', size: 280, viewport: [400, 300] }),
    ])();
}

export function drawings(count, seed) {
    return Array.from({ length: count }, (_, i) => {
        const maker = new Maker(seed + i);
        return maker.drawing(pageOf(maker.random));
    });
}
