// Formats figures: a true minus sign, fixed decimals, a dash for unknown values.
export function figure(value, decimals = 2, signed = false) {
    if (value === null || value === undefined || !Number.isFinite(value)) return '–';
    const text = Math.abs(value).toFixed(decimals);
    const isZero = !/[1-9]/.test(text);
    const [whole, fraction] = text.split('.');
    const grouped = whole.length > 4 ? whole.replace(/\B(?=(\d{3})+$)/g, '\u202f') : whole;
    const sign = isZero ? '' : value < 0 ? '−' : signed ? '+' : '';
    return sign + grouped + (fraction ? '.' + fraction : '');
}

export const percent = (value, decimals = 2) => figure(value, decimals, true) + '\u00a0%';
export const plainPercent = (value, decimals = 2) => figure(value, decimals) + '\u00a0%';
export const millimetres = (value, decimals = 1) => figure(value, decimals) + '\u00a0mm';
export const signedMillimetres = (value, decimals = 2) => figure(value, decimals, true) + '\u00a0mm';
export const degrees = (value, decimals = 1) => figure(value, decimals) + '°';
export const squareMetres = (value, decimals = 2) => figure(value, decimals) + '\u00a0m²';

// About three significant digits without trailing zeros: 2 and not 2.000.
export function short(value) {
    const text = figure(value, Math.abs(value) >= 100 ? 0 : Math.abs(value) >= 10 ? 1 : Math.abs(value) >= 1 ? 2 : 3);
    return text.includes('.') ? text.replace(/\.?0+$/, '') : text;
}

// The tiles that a seam joins: `LEFT – RIGHT + RIB` with an additional sheet, `RIB – LEFT, into S0001` in that sheet's
// record.
export const sewnTiles = (said) =>
    [`${said.tile_a} – ${said.tile_b}`, ...(said.further_tiles ?? [])].join(' + ') +
    (said.sewn_into ? `, into ${said.sewn_into}` : '');

export const count = (number, one, many = one + 's') => `${figure(number, 0)} ${number === 1 ? one : many}`;
