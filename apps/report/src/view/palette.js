// Colours pinned to the tolerance: -1 to 1 is within it, beyond has colours of its own. A colour is a place in a table of 263:
// below, 256 steps, above, flipped, nothing known; then the states of cloth in flight.
export const places = {
    below: 0,
    first: 1,
    steps: 256,
    above: 257,
    flipped: 258,
    unknown: 259,
    taut: 260,
    wrinkled: 261,
    slack: 262,
    count: 263,
};

// Three that are told apart by lightness alone, in every palette.
const states = { taut: '#f7f5ef', wrinkled: '#e8923a', slack: '#2f3f8f' };

const palettes = {
    // Told apart by lightness and by blue against orange, which nearly everyone sees.
    safe: {
        name: 'Colour-blind safe',
        stops: ['#1f5fbf', '#8fbbe8', '#f7f5ef', '#f6b26b', '#e06c00'],
        below: '#101c4a',
        above: '#5c0a1e',
    },
    // The paper's: by size alone, whatever the sign; only what is beyond the tolerance is red.
    paper: {
        name: 'Rainbow, red beyond',
        stops: ['#f08c28', '#f6d646', '#56ba78', '#38a6d6', '#2c5cc8', '#38a6d6', '#56ba78', '#f6d646', '#f08c28'],
        below: '#ce1826',
        above: '#ce1826',
    },
};

export const paletteNames = Object.entries(palettes).map(([id, palette]) => ({ id, name: palette.name }));

const channels = (colour) => [1, 3, 5].map((at) => parseInt(colour.slice(at, at + 2), 16));

function between(stops, share) {
    const at = Math.min(Math.max(share, 0), 1) * (stops.length - 1);
    const i = Math.min(Math.floor(at), stops.length - 2);
    const low = channels(stops[i]),
        high = channels(stops[i + 1]);
    return low.map((value, k) => Math.round(value + (at - i) * (high[k] - value)));
}

// The table as bytes, red, green, blue and 255 each.
export function paletteTable(id) {
    const { stops, below, above } = palettes[id];
    const table = new Uint8Array(4 * places.count);
    const set = (place, rgb) => table.set([...rgb, 255], 4 * place);
    set(places.below, channels(below));
    for (let i = 0; i < places.steps; ++i) set(places.first + i, between(stops, i / (places.steps - 1)));
    set(places.above, channels(above));
    set(places.flipped, [0, 0, 0]);
    set(places.unknown, [230, 233, 237]);
    for (const [state, colour] of Object.entries(states)) set(places[state], channels(colour));
    return table;
}

export function placeOf(value) {
    if (Number.isNaN(value)) return places.flipped;
    if (value < -1) return places.below;
    if (value > 1) return places.above;
    return places.first + Math.min(places.steps - 1, Math.floor(((value + 1) / 2) * places.steps));
}

export function cssColour(table, place) {
    return `rgb(${table[4 * place]} ${table[4 * place + 1]} ${table[4 * place + 2]})`;
}

// Up to 1, 2 or 5 times a power of ten: where a scale ends that nothing pins.
export function roundedUp(largest) {
    const decade = 10 ** Math.floor(Math.log10(largest));
    return [1, 2, 5, 10].map((factor) => factor * decade).find((limit) => limit >= largest * (1 - 1e-9)) ?? largest;
}
