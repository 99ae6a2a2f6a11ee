// Indices of a table of colours, as in the program (src/ripstop/report/view/page_colours.h): below, 256 steps from -1
// to 1 relative to the end of a scale, above, flipped, unknown, then the states of cloth in flight.
export const places = {
    below: 0,
    first: 1,
    steps: 256,
    above: 257,
    flipped: 258,
    unknown: 259,
    states: 260,
    count: 263,
};

// A palette's `rrggbb` entries as bytes: red, green, blue and 255 each.
export function paletteTable(colours) {
    const table = new Uint8Array(4 * places.count).fill(255);
    for (let i = 0; i < places.count; ++i)
        for (let k = 0; k < 3; ++k) table[4 * i + k] = parseInt(colours.substr(6 * i + 2 * k, 2), 16);
    return table;
}

// The index of a value relative to the end of its scale. Without `hasBeyond`, values beyond get the index of the end.
export function placeOf(share, hasBeyond) {
    if (Number.isNaN(share)) return places.flipped;
    if (hasBeyond && share < -1) return places.below;
    if (hasBeyond && share > 1) return places.above;
    const within = Math.min(1, Math.max(-1, share));
    return places.first + Math.min(places.steps - 1, Math.floor(((within + 1) / 2) * places.steps));
}

export function cssColour(table, place) {
    return `rgb(${table[4 * place]} ${table[4 * place + 1]} ${table[4 * place + 2]})`;
}
