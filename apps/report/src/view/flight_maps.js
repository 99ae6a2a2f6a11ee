// The colour maps of an envelope that was sewn and inflated.
import { figure, percent } from './format.js';
import { placeOf, places, roundedUp } from './palette.js';

const newtons = (value) => `${figure(value, 1)}\u00a0N/m`;
const wasInflated = (model) => Boolean(model.report.inflated);

// The largest value of a map of the cloth, rounded up; once a model.
function largestOf(model, key) {
    model.largest ??= {};
    model.largest[key] ??= (() => {
        let largest = 1e-9;
        for (const tile of model.tiles)
            for (const value of tile.maps[key]?.values ?? [])
                largest = Math.max(largest, Math.abs(value) * tile.maps[key].step);
        return roundedUp(largest);
    })();
    return model.largest[key];
}

// What the cloth of a tile may bear in flight with the safety that is asked for [N/m]; null where nothing was judged.
function allowedTension(tile, model) {
    const judged = model.report.inflated.safety.find((each) => each.part === 'cloth');
    if (!judged) return null;
    const share = tile.fabric.strength_n_per_m / judged.strength_n_per_m;
    return (share * judged.load_n_per_m * judged.factor) / judged.required;
}

// The scales of tension and of both stresses are one, so that they can be compared.
const stressLimit = (tile, model) => allowedTension(tile, model) ?? largestOf(model, 'flightTension');
const stress = (id, name, cloth, positive) => ({
    id,
    name,
    cloth,
    positive,
    limit: stressLimit,
    words: newtons,
    negative: '',
    unsigned: true,
    inFlight: true,
    isThere: wasInflated,
});

const degree = Math.PI / 180;
const strain = (id, name, cloth, negative, positive, limit, words) => ({
    id,
    name,
    cloth,
    negative,
    positive,
    limit,
    words,
    inFlight: true,
    isThere: wasInflated,
    isStrain: true,
});
const inPercent = (value) => percent(100 * value);
const inDegrees = (value) => `${figure(value / degree, 2, true)}°`;
const threadLimit = (tile) => tile.limits.strain,
    shearLimit = (tile) => tile.limits.shear;

export const flightMaps = [
    {
        id: 'deviation',
        name: 'Off the drawn shape',
        cloth: 'flightDeviation',
        limit: (_, model) => model.report.inflated.deviation_limit_mm / 1000,
        words: (value) => `${figure(value * 1000, 1, true)}\u00a0mm`,
        negative: 'inside the drawn shape',
        positive: 'outside',
        inFlight: true,
        isThere: wasInflated,
    },
    stress('flight-tension', 'Tension of the cloth', 'flightTension', 'the larger principal tension'),
    stress('flight-warp', 'Stress along the warp', 'flightWarp', 'pulled'),
    stress('flight-weft', 'Stress along the weft', 'flightWeft', 'pulled'),
    stress('flight-shear', 'Shear stress', 'flightShear', 'either way'),
    strain('flight-strain-warp', 'Warp in flight', 'flightStrainWarp', 'folded', 'stretched', threadLimit, inPercent),
    strain('flight-strain-weft', 'Weft in flight', 'flightStrainWeft', 'folded', 'stretched', threadLimit, inPercent),
    strain('flight-strain-shear', 'Shear in flight', 'flightStrainShear', 'threads open', 'threads close', shearLimit, inDegrees),
    {
        id: 'state',
        name: 'Wrinkles',
        cloth: 'flightState',
        kinds: ['taut', 'wrinkled', 'slack'],
        inFlight: true,
        isThere: wasInflated,
    },
    {
        id: 'tapes',
        name: 'Force in the load tapes',
        rim: 'tapes',
        negative: '',
        positive: 'the largest along each seam',
        unsigned: true,
        inFlight: true,
        isThere: (model) => model.seams.some((seam) => seam.said.tape_force_max_n !== undefined),
    },
];

function tapeLimit(model) {
    model.tapeLimit ??= roundedUp(Math.max(1e-9, ...model.seams.map((seam) => seam.said.tape_force_max_n ?? 0)));
    return model.tapeLimit;
}

// The place in the palette of every boundary edge of a tile.
export function tapePlaces(model, tile) {
    const shades = new Uint16Array(tile.loop.length).fill(places.unknown);
    for (const side of tile.sides) {
        const force = side.seam.said.tape_force_max_n;
        if (force === undefined) continue;
        const place = placeOf(force / tapeLimit(model));
        for (let i = 0; i < side.count; ++i) shades[(side.first + i) % shades.length] = place;
    }
    return shades;
}

function stressLegend(model) {
    const limits = model.tiles.map((tile) => stressLimit(tile, model));
    const [least, most] = [Math.min(...limits), Math.max(...limits)].map((limit) => figure(limit, 0));
    const pinned = allowedTension(model.tiles[0], model) !== null;
    return {
        low: '0',
        high: least === most ? `${most} N/m` : `${least} to ${most} N/m`,
        note: pinned
            ? 'pinned to what is allowed: the strength counted on, less the safety that is asked'
            : 'scale: the largest there is',
        pinned,
    };
}

function strainLegend(model, map) {
    const limits = model.tiles.map((tile) => map.limit(tile, model));
    const [least, most] = [Math.min(...limits), Math.max(...limits)].map((limit) => map.words(limit).replace('+', ''));
    return {
        low: `−${most}`,
        high: `+${most}`,
        note: `from the cloth as cut; pinned to the fabric's limit${least === most ? '' : `, ${least} to ${most}`}`,
        pinned: true,
    };
}

function tapeLegend(model) {
    const judged = model.report.inflated.safety.find((each) => each.part === 'load tapes');
    const allowed = judged ? `; ${figure((judged.load_n * judged.factor) / judged.required, 0)} N are allowed` : '';
    return {
        low: '0',
        high: `${+tapeLimit(model).toPrecision(4)} N`,
        note: `scale: the largest there is${allowed}`,
        pinned: false,
    };
}

export function flightLegend(model, map) {
    const { inflated } = model.report;
    if (map.kinds)
        return {
            kinds: map.kinds,
            note: `${figure(inflated.wrinkled_pct, 1)} % of the cloth is wrinkled: pulled one way and folded across it; ${figure(inflated.slack_pct, 1)} % is slack`,
        };
    if (map.id === 'deviation') {
        const most = figure(inflated.deviation_limit_mm, 1);
        return { low: `−${most} mm`, high: `+${most} mm`, note: 'pinned to 0.3 % of the height', pinned: true };
    }
    if (map.isStrain) return strainLegend(model, map);
    return map.id === 'tapes' ? tapeLegend(model) : stressLegend(model);
}
