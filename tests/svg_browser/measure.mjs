// Measures Chromium's geometry of the drawing on its page; runs in the page. Replaces every use by the group that
// SVG says it stands for, requires that Chromium gives both the same box, and then measures every visible shape in
// file order.
export function measure(count) {
    const root = document.documentElement;
    const space = 'http://www.w3.org/2000/svg';
    const undrawn = 'defs,symbol,clipPath,mask,pattern,marker';
    const boxOf = (element) => {
        const box = element.getBBox();
        return [box.x, box.y, box.x + box.width, box.y + box.height];
    };
    const wrong = [];

    for (let use; (use = [...root.querySelectorAll('use')].find((each) => !each.closest(undrawn)));) {
        const href = use.getAttribute('href') ?? use.getAttribute('xlink:href');
        const target = root.querySelector(href);
        const before = boxOf(use);
        const group = document.createElementNS(space, 'g');
        for (const { name, value } of use.attributes)
            if (!/^(xlink:)?href$|^(x|y|width|height)$/.test(name)) group.setAttribute(name, value);
        const moved = document.createElementNS(space, 'g');
        moved.setAttribute('transform', `translate(${use.x.baseVal.value} ${use.y.baseVal.value})`);
        let copy = target.cloneNode(true);
        if (target.localName === 'symbol') {
            copy = document.createElementNS(space, 'svg');
            for (const { name, value } of target.attributes) copy.setAttribute(name, value);
            copy.append(...[...target.childNodes].map((child) => child.cloneNode(true)));
            copy.setAttribute('width', use.getAttribute('width') ?? '100%');
            copy.setAttribute('height', use.getAttribute('height') ?? '100%');
        }
        if (target.localName === 'svg')
            for (const side of ['width', 'height'])
                if (use.hasAttribute(side)) copy.setAttribute(side, use.getAttribute(side));
        moved.append(copy);
        group.append(moved);
        use.replaceWith(group);
        // The box of the group is in the space around x and y, that of the use inside it.
        const after = boxOf(group);
        const size = Math.max(...before.map(Math.abs), 1);
        if (before.some((value, i) => Math.abs(value - after[i]) > 1e-4 * size))
            wrong.push(`${use.id}: a use of ${href} has the box ${before}, its group ${after}`);
    }

    // The number of lines of a path: from M to M with anything between, and after Z without M.
    const linesOf = (element) => {
        const style = getComputedStyle(element).d;
        const data = style?.startsWith('path') ? style : element.getAttribute('d');
        const runs = data?.match(/m[^mz]*z?|(?<=z[\s,]*)[a-ln-y][^mz]*z?/gi) ?? [''];
        return runs.filter((run) => !/^m[^a-df-z]*$/i.test(run) || run.match(/[\d.]+/g)?.length > 2).length;
    };
    // An svg draws nothing if its width, its height or the area of its viewBox is zero.
    const isFlat = (element) => {
        if (element.localName !== 'svg' || element === root) return false;
        const box = element.viewBox.baseVal;
        const isWithoutArea =
            element
                .getAttribute('viewBox')
                ?.trim()
                .split(/[\s,]+/).length === 4 && box?.width * box?.height === 0;
        return isWithoutArea || element.width.baseVal.value * element.height.baseVal.value === 0;
    };
    // checkVisibility alone accepts elements in a group that is not displayed.
    const isDrawn = (element) => {
        if (!element.checkVisibility({ visibilityProperty: true })) return false;
        if (getComputedStyle(element).display === 'contents') return false;
        for (let around = element; around instanceof Element; around = around.parentNode)
            if (getComputedStyle(around).display === 'none' || isFlat(around)) return false;
        return true;
    };
    const page = root.getScreenCTM();
    const origin = new DOMPoint(0, 0).matrixTransform(page);
    const shapes = [],
        texts = [];
    const onPage = (point, matrix) => {
        const at = new DOMPoint(point.x, point.y).matrixTransform(matrix);
        return [at.x - origin.x, at.y - origin.y];
    };
    // From one given place to the next.
    const linesOfText = (element, matrix) => {
        const found = [];
        const walker = document.createTreeWalker(element, NodeFilter.SHOW_TEXT);
        for (let at = 0; walker.nextNode();) {
            const { parentNode: own, data } = walker.currentNode;
            if (found.length === 0 || own.hasAttribute('x') || own.hasAttribute('y'))
                found.push({
                    text: '',
                    at: onPage(element.getStartPositionOfChar(at), matrix),
                    height: parseFloat(getComputedStyle(own).fontSize) * Math.hypot(matrix.c, matrix.d),
                });
            found.at(-1).text += data;
            at += data.length;
        }
        return found;
    };
    for (const element of root.querySelectorAll('path,rect,circle,ellipse,line,polyline,polygon,text')) {
        if (element.closest(undrawn) || !isDrawn(element)) continue;
        const matrix = element.getScreenCTM();
        const box = element.getBBox();
        if (element.localName === 'text') {
            texts.push(...linesOfText(element, matrix));
            continue;
        }
        const total = element.getTotalLength();
        if (total === 0 && box.width === 0 && box.height === 0) continue;
        // With a side or radius of 0 it is not drawn.
        if (/rect|circle|ellipse/.test(element.localName) && box.width * box.height === 0) continue;
        const points = Array.from({ length: count + 1 }, (_, i) =>
            onPage(element.getPointAtLength((i / count) * total), matrix),
        );
        const { a, b, c, d } = matrix;
        shapes.push({
            id: element.id,
            entity: element.localName,
            lines: linesOf(element),
            hasArcs: /a/i.test(element.getAttribute('d') ?? ''),
            total,
            points,
            corners: [onPage(box, matrix), onPage({ x: box.x + box.width, y: box.y + box.height }, matrix)],
            isUpright: b === 0 && c === 0,
            // The matrix as a scale, if it is one, times a rotation.
            scale:
                Math.min(Math.hypot(a - d, b + c), Math.hypot(a + d, b - c)) < 1e-6 * Math.hypot(a, b)
                    ? Math.hypot(a, b)
                    : null,
        });
    }
    return { shapes, texts, wrong, unit: { x: page.a, y: page.d } };
}
