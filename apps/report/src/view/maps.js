// The colour maps. The program decides their values, scales and legends (src/ripstop/report/view/map_view.h); here
// values become palette indices.
import { placeOf, places } from './palette.js';

const unknown = -32768; // of a triangle: flipped on the cloth

// The settings for painting: map, scale and palette. Until a scale is chosen, each map uses its own first one.
export function lookOf(model, { map: id, scale: wanted, palette }) {
    const map = model.maps.find((each) => each.id === id);
    const scale = map.scales.find((each) => each.id === wanted) ?? map.scales[0];
    return { map, scale, table: model.palettes.find((each) => each.id === palette).table };
}

export function clothValue(tile, id, triangle) {
    const map = tile.maps[id];
    if (!map) return undefined;
    const value = map.values[triangle];
    return value === unknown ? NaN : value * map.step;
}

// The palette index of every triangle of a tile.
export function clothPlaces(tile, { map, scale }) {
    const values = tile.maps[map.id];
    const count = tile.triangles.length / 3;
    if (!values) return new Uint16Array(count).fill(places.unknown);
    if (map.states.length > 0) return Uint16Array.from(values.values, (value) => places.states + value);
    const end = typeof scale.cloth === 'number' ? scale.cloth : scale.cloth[tile.index];
    const share = values.step / end;
    return Uint16Array.from(values.values, (value) =>
        value === unknown ? places.flipped : placeOf(value * share, scale.beyond),
    );
}

// The palette index of every boundary edge of a tile; null for a map of the cloth alone.
export function rimPlaces(tile, { map, scale }) {
    if (!map.of_edges) return null;
    const { values, step } = tile.edges[map.id];
    const share = step / scale.edges;
    return Uint16Array.from(values, (value) =>
        value === unknown ? places.unknown : placeOf(value * share, scale.beyond),
    );
}
