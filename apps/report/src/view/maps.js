// The colour maps: what each shows of the cloth's triangles and of the edges, as shares of what is allowed.
import { figure } from './format.js';
import { flightLegend, flightMaps, tapePlaces } from './flight_maps.js';
import { placeOf, places, roundedUp } from './palette.js';

const flipped = -32768;
const degree = Math.PI / 180;

const strainLimit = (tile) => tile.limits.strain;
const inPercent = (value) => `${figure(value * 100, 2, true)}\u00a0%`;

function legendPercent(limits) {
    const [least, most] = [Math.min(...limits), Math.max(...limits)].map((limit) => +(limit * 100).toPrecision(6));
    return least === most
        ? { low: `−${most} %`, high: `+${most} %` }
        : { low: '− limit', high: `+ limit (${least} to ${most} %)` };
}

export const maps = [
    {
        id: 'warp',
        name: 'Strain along the warp',
        cloth: 'warp',
        limit: strainLimit,
        words: inPercent,
        negative: 'cloth shrinks',
        positive: 'cloth stretches',
    },
    {
        id: 'weft',
        name: 'Strain along the weft',
        cloth: 'weft',
        limit: strainLimit,
        words: inPercent,
        negative: 'cloth shrinks',
        positive: 'cloth stretches',
    },
    {
        id: 'shear',
        name: 'Shear between the threads',
        cloth: 'shear',
        limit: (tile) => tile.limits.shear,
        words: (value) => `${figure(value / degree, 2, true)}°`,
        negative: 'threads open',
        positive: 'threads close',
    },
    {
        id: 'area',
        name: 'Area',
        cloth: 'area',
        limit: (_, model) => model.report.tolerances.area_pct / 100,
        words: inPercent,
        negative: 'piece too small',
        positive: 'piece too large',
    },
    {
        id: 'edges',
        name: 'Edge error',
        cloth: 'edges',
        limit: strainLimit,
        words: inPercent,
        rim: 'edgeError',
        negative: '',
        positive: 'mean of the edges of each triangle',
        unsigned: true,
    },
    {
        id: 'mismatch',
        name: 'Seam mismatch',
        rim: 'mismatch',
        negative: 'this edge is shorter',
        positive: 'this edge is longer',
    },
    { id: 'tension', name: 'Tension along the seams', rim: 'tension', negative: 'pushed', positive: 'pulled' },
    ...flightMaps,
];

export const mapOf = (id) => maps.find((map) => map.id === id);

// The maps there is something to show of.
export function mapsOf(model) {
    const has = (key) => model.tiles.some((tile) => tile.maps[key]);
    return maps.filter((map) => {
        if (map.isThere) return map.isThere(model);
        if (map.cloth) return has(map.cloth);
        return map.rim === 'mismatch' ? model.seams.length > 0 : model.tiles.some((tile) => tile.tension);
    });
}

// What is shown first: how far an inflated envelope that can be made is off; else what may be wrong with the pieces.
export function firstMap(model, available) {
    const good = model.tiles.every((tile) => tile.ok);
    const seams = model.seams.every((seam) => seam.ok);
    const preferred = good && seams && model.report.inflated ? 'deviation' : good && !seams ? 'mismatch' : 'warp';
    return available.find((map) => map.id === preferred) ?? available[0] ?? mapOf('edges');
}

export function clothValue(tile, key, triangle) {
    const map = tile.maps[key];
    if (!map) return undefined;
    const value = map.values[triangle];
    return value === flipped ? NaN : value * map.step;
}

// The place in the palette of every triangle of a tile.
export function clothPlaces(model, tile, map) {
    const count = tile.triangles.length / 3;
    const shades = new Uint16Array(count).fill(places.unknown);
    const values = map.cloth && tile.maps[map.cloth];
    if (!values) return shades;
    if (map.kinds) return Uint16Array.from(values.values, (value) => places[map.kinds[value]]);
    const scale = values.step / map.limit(tile, model);
    for (let t = 0; t < count; ++t)
        shades[t] = values.values[t] === flipped ? places.flipped : placeOf(values.values[t] * scale);
    return shades;
}

// How far side b is ahead of side a at `at` along a seam [mm], in proportion between the notches.
export function driftAt(seam, at) {
    let before = { at_mm: 0, drift_mm: 0 };
    for (const notch of [...seam.said.notches, { at_mm: seam.said.length_mm, drift_mm: seam.said.mismatch_mm }]) {
        if (at <= notch.at_mm) {
            const step = notch.at_mm - before.at_mm;
            return step > 0
                ? before.drift_mm + ((at - before.at_mm) / step) * (notch.drift_mm - before.drift_mm)
                : notch.drift_mm;
        }
        before = notch;
    }
    return seam.said.mismatch_mm;
}

function mismatchPlaces(tile) {
    const shades = new Uint16Array(tile.loop.length).fill(places.unknown);
    for (const side of tile.sides) {
        const { length_mm: length, limit_mm: limit } = side.seam.said;
        const isB = side.name === 'b';
        for (let i = 0; i < side.count; ++i) {
            const along = ((i + 0.5) / side.count) * length;
            const drift = driftAt(side.seam, isB ? length - along : along);
            shades[(side.first + i) % shades.length] = placeOf((isB ? drift : -drift) / limit);
        }
    }
    return shades;
}

function steppedPlaces(map, limit, length) {
    if (!map) return new Uint16Array(length).fill(places.unknown);
    return Uint16Array.from(map.values, (value) => placeOf((value * map.step) / limit));
}

// The largest tension of all seams, rounded up: nothing says what a seam may bear.
export function tensionLimit(model) {
    model.tensionLimit ??= (() => {
        let largest = 1e-9;
        for (const tile of model.tiles)
            for (const value of tile.tension?.values ?? [])
                largest = Math.max(largest, Math.abs(value) * tile.tension.step);
        return roundedUp(largest);
    })();
    return model.tensionLimit;
}

// The place in the palette of every boundary edge of a tile; nothing for a map of the cloth alone.
export function rimPlaces(model, tile, map) {
    if (!map.rim) return null;
    if (map.rim === 'mismatch') return mismatchPlaces(tile);
    if (map.rim === 'tapes') return tapePlaces(model, tile);
    if (map.rim === 'tension') return steppedPlaces(tile.tension, tensionLimit(model), tile.loop.length);
    return steppedPlaces(tile.edgeError, model.report.tolerances.length_pct / 100, tile.loop.length);
}

// What stands beside the colours.
export function legend(model, map) {
    if (map.inFlight) return flightLegend(model, map);
    if (map.id === 'mismatch') {
        const most = +(model.report.tolerances.length_pct * 10).toPrecision(4);
        return {
            low: `−${most} mm`,
            high: `+${most} mm`,
            note: 'how far the two sides are apart, for each metre of seam',
            pinned: true,
        };
    }
    if (map.id === 'tension') {
        const most = +tensionLimit(model).toPrecision(4);
        return {
            low: `−${most} N`,
            high: `+${most} N`,
            note: 'the force that holds each edge at its length; scale: the largest there is',
            pinned: false,
        };
    }
    if (map.id === 'shear') {
        const limits = model.tiles.map((tile) => tile.limits.shear / degree);
        const [least, most] = [Math.min(...limits), Math.max(...limits)].map((limit) => +limit.toPrecision(4));
        return {
            low: `−${most}°`,
            high: `+${most}°`,
            note: least === most ? '' : `limits of the fabrics: ${least} to ${most}°`,
            pinned: true,
        };
    }
    const ends = legendPercent(model.tiles.map((tile) => map.limit(tile, model)));
    const note =
        map.id === 'edges'
            ? `band along the seams: pinned to ±${+model.report.tolerances.length_pct.toPrecision(4)} % of length`
            : '';
    return { ...ends, note, pinned: true };
}
