// One drawing for each rule of SVG and CSS that decides where a line is or whether it is visible: a name, and the
// body of a drawing of 100 mm by 100 mm in units of a millimetre, or a whole drawing.
const page = (body) =>
    '<svg xmlns="http://www.w3.org/2000/svg" xmlns:xlink="http://www.w3.org/1999/xlink" width="100mm" height="100mm" ' +
    `viewBox="0 0 100 100" font-size="10">\n${body}\n</svg>\n`;

const line = '<path id="a" d="M10 10h30v20"/>';
const styled = (css, body = line) => page(`<style>${css}</style>${body}`);
const own = (style, more = '') => page(`<path id="a" style="${style}" d="M10 10h30v20"${more}/>`);

const paths = {
    'numbers without blanks': 'M10 10.5.5-5e1+6-2l1.5.5-.5-.5',
    'numbers with exponents': 'M1e1 1E+1l2e-1.5e1+3e0-1E1',
    'numbers between commas and ends of lines': 'M 10,10\n\t,20 , 30\r\nL40,50',
    'signs before every number': 'M+10+10l+5-5',
    'moves that go on as lines': 'M10 10 20 20 30 10m5 5 5 5-5 5',
    'a relative move at the start': 'm10 10 5 5z m20 0 5 5z',
    'lines after the end of a run': 'M10 10h20v20zl5 5h5z',
    'an arc after the end of a run': 'M10 10h20v20Zm30 0a5 5 0 1 1 5 5z',
    'flags of arcs without blanks': 'M10 30a10 10 0 0120 0a5 8 30 1140 10a3 3 0 1015 5',
    'arcs with a radius of nothing': 'M10 10A0 5 0 0 1 30 30a5 0 0 1 1 20 5',
    'arcs with radii below nothing': 'M10 30a-10-8 20 0 1 15 5',
    'arcs that are too short for their chord': 'M10 50a1 2 30 0 1 60 10a2 1 0 1 0-30 20',
    'arcs that end where they begin': 'M10 10a5 5 0 1 1 0 0h20',
    'arcs turned more than once about': 'M20 50a20 10 765 1 0 30 10A20 10-45 0 1 20 60',
    'smooth cubics after other commands': 'M10 10h10s10 10 20 0S50 30 60 10q5 5 9 0s5-5 9 0',
    'smooth quadratics after other commands': 'M10 10h10t10 10q5-20 20 0t20 5T80 40c1 1 5 5 5 9t5 5',
    'several groups of numbers after a command': 'M10 10c5 5 10 5 15 0 5-5 10-5 15 0h5 5-3v5 5 5',
    'a lone move after others': 'M20 20h5M30 30',
    'a run of no length that is closed': 'M10 10h10M20 20z',
    'a path with blanks alone': '  ',
};
const attributes = {
    'a rectangle with one radius': '<rect x="10" y="10" width="40" height="20" rx="5"/>',
    'a rectangle with its other radius': '<rect x="10" y="10" width="40" height="20" ry="8"/>',
    'a rectangle with radii beyond its sides': '<rect x="10" y="10" width="40" height="20" rx="35" ry="15"/>',
    'a rectangle with one radius beyond a side': '<rect x="10" y="10" width="40" height="20" rx="15"/>',
    'a rectangle with a radius of nothing': '<rect x="10" y="10" width="40" height="20" rx="0" ry="8"/>',
    'a rectangle with a radius below nothing': '<rect x="10" y="10" width="40" height="20" rx="-3" ry="8"/>',
    'a rectangle with radii in per cent': '<rect x="10" y="10" width="40" height="20" rx="5%" ry="40%"/>',
    'rectangles without a side': '<rect width="40"/><rect width="0" height="4"/><rect width="-4" height="4"/>' + line,
    'an ellipse with one radius': '<ellipse cx="50" cy="50" rx="20"/><ellipse cx="50" cy="50" ry="20"/>',
    'an ellipse with a radius of nothing': '<ellipse cx="50" cy="50" rx="20" ry="0"/>' + line,
    'a circle without a radius': '<circle cx="50" cy="50"/><circle r="-5"/>' + line,
    'points with one number too many': '<polyline points="10,10 20 20,30"/><polygon points="10-10 20.5.5 30 10"/>',
    'one point': '<polygon points="10,10"/><polyline points=""/>' + line,
    'units of every kind':
        '<rect x="1mm" y=".1cm" width="1in" height="36pt"/><rect x="2pc" y="9Q" width="20px" height="1.5em"/>' +
        '<rect x="1rem" y="1e1" width="5E0MM" height="1IN"/>',
    'per cent along, across and of both': '<circle cx="50%" cy="25%" r="10%"/><line x1="1%" y1="9%" x2="99%" y2="8%"/>',
    'blanks around lengths': '<rect x=" 10 " y="\n10mm\t" width="+40" height="2e1" />',
    'transforms between commas': '<g transform=" translate(5,5),scale( 2 , 1.5 ) rotate(10 5,5)">' + line + '</g>',
    'transforms joined': '<g transform="translate(5-3)scale(.5.75)skewX(-10)skewY(5)">' + line + '</g>',
    'a transform of nothing': '<g transform="">' + line + '</g>',
    'a mirrored matrix': '<g transform="matrix(-1 .2-.1 1 60 5)">' + line + '</g>',
    'an svg within':
        '<svg x="10" y="20%" width="50" height="50%" viewBox="-5 0 30 20" overflow="visible">' + line + '</svg>',
    'an svg within without a size': '<svg x="5" overflow="visible"><rect width="50%" height="50%"/></svg>',
    'an svg within with a transform': '<svg x="5" transform="rotate(10)" overflow="visible">' + line + '</svg>',
    'an svg without area': '<svg width="0" overflow="visible">' + line + '</svg><path d="M1 1h5"/>',
    'an svg with a viewBox without area':
        '<svg viewBox="0 0 0 5" overflow="visible">' + line + '</svg><path d="M1 1h5"/>',
    'an svg with a viewBox that is none': '<svg viewBox="0 0 5" overflow="visible">' + line + '</svg>',
    'lists of x and y of letters': '<text x="10 12 14" y="20,21">abc</text>',
    'shifts of text': '<text x="10" y="20" dx="1 2" dy="2mm">abc</text><text dx="5" y="9">d</text>',
    'spans with places':
        '<text x="10" y="20"><tspan x="12" y="30">ab</tspan><tspan x="15" dy="1.2em">cd</tspan></text>',
    'a transformed text': '<text transform="rotate(30) scale(2)" x="10" y="20" font-size="150%">abc</text>',
};
const uses = {
    'a use of a shape': '<use id="u" href="#p" x="10" y="10%"/>',
    'a use with a transform': '<use id="u" href="#p" x="10" transform="rotate(20)"/>',
    'a use of a use': '<use id="u" href="#pp" x="3" y="2" transform="scale(1.5)"/>',
    'a use of a group': '<use id="u" xlink:href="#g" y="20"/>',
    'a use of a symbol': '<use id="u" href="#s" x="5" width="60" height="30"/>',
    'a use of a symbol without a size': '<use id="u" href="#s" x="5"/>',
    'a use of a symbol with a width': '<use id="u" href="#s" x="5" width="50%"/>',
    'a use of a symbol with a place of its own': '<use id="u" href="#s2" x="5" width="50" height="50"/>',
    'a use of an svg': '<use id="u" href="#v" x="5" width="40" height="60"/>',
    'a use of an svg with its own size': '<use id="u" href="#v" y="5"/>',
    'a use that hides': '<use id="u" href="#p" visibility="hidden"/><use id="w" href="#q" visibility="hidden"/>' + line,
    'a use of what is not displayed': '<use id="u" href="#none"/>' + line,
    'a use of what stands in something hidden': '<use id="u" href="#inner"/>',
    'a use with both kinds of href': '<use id="u" xlink:href="#g" href="#p" x="9"/>',
    'a use of a symbol in per cent': '<use id="u" href="#s3" width="50" height="40"/>',
};
const defs =
    '<defs><path id="p" d="M1 1h20v10"/><use id="pp" href="#p" x="7" transform="rotate(5)"/>' +
    '<path id="q" visibility="visible" d="M2 2h9"/><rect id="none" display="none" width="5" height="5"/>' +
    '<g id="g" transform="translate(3 4)"><use href="#pp" y="2"/><circle r="3"/></g>' +
    '<symbol id="s" viewBox="0 0 40 10" overflow="visible"><path d="M0 0h40v10"/></symbol>' +
    '<symbol id="s2" x="9" y="3" width="10" height="10" viewBox="0 0 10 10" overflow="visible">' +
    '<path d="M0 0h10v10"/></symbol>' +
    '<symbol id="s3" overflow="visible"><rect width="50%" height="25%"/></symbol>' +
    '<svg id="v" x="2" width="20" height="20" viewBox="0 0 10 10" overflow="visible"><path d="M0 0h10v5"/></svg>' +
    '</defs>' +
    '<g display="none"><path id="inner" d="M5 5h9v9"/></g>';

const styles = {
    'a style attribute': own('display:none'),
    'display in capitals': own('DISPLAY: None'),
    'display as an attribute in capitals': page('<path d="M1 1h5" display="NONE"/>' + line),
    'visibility in capitals': own('visibility:HIDDEN'),
    'a visibility that is none': page(`<g visibility="hidden">${line}</g><g visibility="never"><path d="M1 1h3"/></g>`),
    'visibility collapsed': own('visibility:collapse'),
    'visibility by its first value': page('<g visibility="hidden"><path d="M1 1h3" visibility="initial"/></g>'),
    'visibility unset': page('<g visibility="hidden"><path d="M1 1h3" style="visibility:unset"/></g>' + line),
    'visibility reverted': page('<g visibility="hidden"><path d="M1 1h3" style="visibility:revert"/></g>' + line),
    'display inherited': page('<g style="display:inline"><path d="M1 1h3" display="inherit"/></g>'),
    'a display that is none of CSS': own('display: nothing'),
    'contents without their group': page(`<g display="contents" transform="translate(9)">${line}</g>`),
    'a shape of contents alone': page('<path d="M1 1h3" display="contents"/>' + line),
    'visible in what is hidden': page(
        '<g visibility="hidden"><path d="M1 1h3"/><path id="b" style="visibility:visible" d="M2 2h5"/></g>',
    ),
    'a later rule': styled('.c{display:none} .c{display:inline}', '<path class="c" d="M1 1h5"/>'),
    'an id above a class': styled('#a{display:inline} .c{display:none}', '<path id="a" class="c" d="M1 1h5"/>'),
    'what is important': styled('path{display:none!important} #a{display:inline}'),
    'important above the style attribute': page(
        '<style>.c{display:none ! important}</style><path class="c" style="display:inline" d="M1 1h5"/>' + line,
    ),
    'a rule above an attribute': page(
        '<style>*{visibility:hidden} #a{visibility:visible}</style><path visibility="visible" d="M1 1h5"/>' + line,
    ),
    'geometry in a rule': styled(
        'rect{x:10px;y:5mm;width:20%;height:1em;rx:2px} circle{cx:50%;cy:20px;r:10%} ellipse{rx:5px;ry:3px}',
        '<rect x="1"/><circle r="3"/><ellipse cx="9" cy="9" rx="4"/>',
    ),
    'geometry in a rule without a unit': styled('rect{width:20;height:30px}', '<rect width="5" height="5"/>'),
    'geometry of nothing without a unit': styled('rect{rx:0;x:0}', '<rect x="5" width="5" height="5" rx="1"/>'),
    'geometry below nothing in a rule': styled('circle{r:-3px}', '<circle cx="20" cy="20" r="5"/>'),
    'radii auto in a rule': styled(
        'rect,ellipse{rx:auto}',
        '<rect width="9" height="5" ry="2" rx="1"/><ellipse rx="1" ry="4"/>',
    ),
    'a path in a rule': styled('path{d:path("M5 5h20v20")}', '<path d="M1 1h3"/>'),
    'no path in a rule': styled('.n{d:none}', '<path class="n" d="M1 1h3"/>' + line),
    'a transform in a style': own('transform: translate(5px, 10px) rotate(10deg) scale(1.5)'),
    'a transform in a style without units': own('transform: translate(5 10)'),
    'a turn in a style without a unit': own('transform: rotate(20)', ' transform="translate(3 3)"'),
    'a transform in a style above the attribute': own('transform: scale(2)', ' transform="translate(30 3)"'),
    'no transform in a style': own('transform: none', ' transform="translate(30 3)"'),
    'a transform by a matrix in a style': own('transform: matrix(1, .2, -.1, 1.5, 6, 7)'),
    'a transform in millimetres': own('transform: translate(5mm, 1cm)'),
    'a transform in per cent': own('transform: translate(5%, 10%)'),
    'an origin of a transform': own('transform: rotate(30deg); transform-origin: 20px 10px'),
    'an origin of a transform as an attribute': page(
        '<path d="M10 10h30v20" transform="rotate(30)" transform-origin="20 10"/>',
    ),
    'an origin in words': own('transform: rotate(30deg); transform-origin: center'),
    'an origin of one number': own('transform: rotate(30deg); transform-origin: 20px'),
    'a turn about the page': own('transform: rotate(30deg); transform-origin: 50% 25%'),
    'a turn about the box': own('transform: rotate(30deg); transform-origin: center; transform-box: fill-box'),
    'a comment in a style': own('/* display:none */ visibility: visible'),
    'a semicolon in a string': own("font-family:'a;display:none'; fill: none; stroke: red"),
    'a declaration that is none': own('display none; visibility:hidden'),
    'media of other kinds': styled(
        '@media print{path{display:none}} @media screen{#b{display:none}}',
        line + '<path id="b" d="M1 1h3"/>',
    ),
    'a sheet for print': page('<style media="print">path{display:none}</style>' + line),
    'children and neighbours': styled(
        'g > path{display:none} path + rect{visibility:hidden} path ~ circle{display:none}',
        '<g><path d="M1 1h3"/><rect width="3" height="3"/><circle r="3"/><a><path d="M2 2h3"/></a></g>',
    ),
    'attributes as selectors': styled(
        '[data-k]{display:none} [id^="b"]{visibility:hidden} path[d$="7"]{display:none}',
        line + '<path data-k="1" d="M1 1h3"/><path id="bb" d="M1 1h3"/><path d="M1 1h7"/>',
    ),
    'first and last children': styled(
        'path:first-child{display:none} path:last-child{visibility:hidden}',
        '<g><path d="M1 1h3"/><path d="M2 2h5"/><path d="M2 2h4"/></g>',
    ),
    'names with marks': styled(
        '.a\\.b{display:none} #\\31 x{visibility:hidden}',
        '<path class="a.b" d="M1 1h3"/><path id="1x" d="M2 2h5"/>' + line,
    ),
    'sizes of letters': styled(
        'text{font-size:6px} .big{font-size:2em} tspan{font-size:50%}',
        '<text y="20">ab</text><text class="big" y="30" x="5">cd</text>' +
            '<g font-size="20"><text y="40" style="font-size:inherit">ef</text></g>',
    ),
    'a size of letters without a unit': page(
        '<text style="font-size:25" y="20">ab</text><text font-size="25" y="20">ab</text>',
    ),
    'a size of letters in words': page(
        '<text style="font-size:X-Large" y="20">ab</text>' +
            '<g font-size="20"><text font-size="larger" y="30">b</text></g>',
    ),
    'lengths in letters': page(
        '<g font-size="5"><rect x="1em" width="2em" height="1rem"/>' +
            '<g style="font:italic 3px/2 serif"><rect x="1em" width="2em" height="1em"/></g></g>',
    ),
    'a style of the page': page('<path d="M10 10h3"/>')
        .replace('font-size="10"', 'style="font-size:20px; visibility:hidden"')
        .replace('<path', '<rect width="1em" height="1em" visibility="visible"/><path'),
};

// Features that are reported as not understood, and no others; what Chromium hides or moves because of them may be
// drawn.
const named = {
    'children by number': styled(
        'path:nth-child(2){display:none} path:nth-child(2n+3){visibility:hidden} :nth-last-child(1){visibility:hidden}',
        '<g><path d="M1 1h3"/><path d="M2 2h5"/><path d="M2 2h4"/><path d="M2 2h6"/><path d="M2 2h7"/></g>',
    ),
    'children of a type': styled(
        'path:first-of-type{display:none} rect:last-of-type{display:none} path:nth-of-type(odd){visibility:hidden}',
        '<g><rect width="1" height="2"/><path d="M1 1h3"/><path d="M2 2h5"/>' +
            '<path d="M2 2h4"/><rect width="3" height="2"/></g>',
    ),
    'all but some': styled(
        'path:not(.c, #d){display:none} :is(#e, .c):not([id]){visibility:hidden}',
        '<path d="M1 1h3"/><path class="c" d="M2 2h5"/><path id="d" d="M2 2h4"/><path id="e" class="c" d="M3 2h4"/>',
    ),
    'where without weight': styled(':where(#a){display:none} path{display:inline}'),
    'groups that are empty': styled(
        'g:empty + path{display:none} g:not(:empty) + rect{display:none}',
        '<g/><path d="M1 1h3"/><g><path d="M2 2h5"/></g><rect width="2" height="2"/>',
    ),
    'variables': styled(':root{--k:none} #a{display:var(--k)}', line + '<path d="M1 1h3"/>'),
    'sums': styled('rect{width:calc(10px + 5%);height:calc(2 * 4px)}', '<rect/>'),
    'rules in rules': styled(
        'g{&amp; path{display:none} rect{visibility:hidden}}',
        '<g><path d="M1 1h3"/><rect width="2" height="2"/></g>' + line,
    ),
    'a group within that has another origin': page(
        '<g style="transform: rotate(9deg); transform-box: fill-box">' + line + '</g>',
    ),
    'a link in a link': page(`<a><a>${line}</a></a>`),
    'lengths of the window': page('<rect width="3vw" height="2vh"/>'),
    'an svg of contents alone': page(`<svg display="contents" x="5">${line}</svg>`),
};

const aligned = ['Min', 'Mid', 'Max'].flatMap((x) => ['Min', 'Mid', 'Max'].map((y) => `x${x}Y${y}`));
const fits = [
    'none',
    '',
    ...aligned,
    ...aligned.map((fit) => fit + ' slice'),
    'xMidYMid meet',
    'xmidymid',
    'defer xMinYMin',
];
const roots = {
    'a page in px': 'width="300" height="200"',
    'a page in px with a viewBox': 'width="300px" height="200px" viewBox="0 0 150 100"',
    'a page of a width alone': 'width="300mm" viewBox="0 0 150 100"',
    'a page of a height alone': 'height="200mm" viewBox="0 0 150 100"',
    'a page in per cent': 'width="100%" height="100%" viewBox="0 0 150 100"',
    'a page with a place': 'x="50" y="50" width="300mm" height="200mm" viewBox="20 10 150 100"',
    'a page by its style': 'style="width:300mm;height:200mm" viewBox="0 0 150 100"',
    'a page in inches without a viewBox': 'width="10in" height="8in"',
    'a page in letters': 'width="30em" height="20em" viewBox="0 0 150 100"',
};
const root = (given, body = line) => `<svg xmlns="http://www.w3.org/2000/svg" ${given}>${body}</svg>`;

export const cases = [
    ...Object.entries(paths).map(([name, d]) => [name, page(`<path id="a" d="${d}"/>`)]),
    ...Object.entries(attributes).map(([name, body]) => [name, page(body)]),
    ...Object.entries(uses).map(([name, body]) => [name, page(defs + body)]),
    ...Object.entries(styles),
    ...fits.map((fit) => [
        `a page fitted by "${fit}"`,
        root(`width="80mm" height="50mm" viewBox="3 4 30 40" preserveAspectRatio="${fit}"`),
    ]),
    ...fits.map((fit) => [
        `an svg within fitted by "${fit}"`,
        page(
            `<svg x="5" width="80" height="50" viewBox="3 4 30 40" preserveAspectRatio="${fit}" ` +
                `overflow="visible">${line}</svg>`,
        ),
    ]),
    ...fits.map((fit) => [
        `a symbol fitted by "${fit}"`,
        page(
            `<symbol id="s" viewBox="3 4 30 40" preserveAspectRatio="${fit}" overflow="visible">${line}</symbol>` +
                '<use id="u" href="#s" x="5" width="80" height="50"/>',
        ),
    ]),
    ...Object.entries(roots).map(([name, given]) => [name, root(given)]),
    ...Object.entries(named).map(([name, text]) => [name, text, true]),
].map(([name, text, isNamed = false]) => ({ name, text, isNamed }));
