// Tables of all tiles and seams.
import { degrees, figure, percent, signedMillimetres } from '../view/format.js';
import { sortedTable } from './sorted_table.js';
import { meaning } from './verdict.js';

const largest = (...values) => values.reduce((worst, value) => (Math.abs(value) > Math.abs(worst) ? value : worst), 0);
const codes = (model, tile) => [...new Set(tile.findings.map(({ code }) => meaning(model, code)))].join(', ');
const worstEdge = (tile) => largest(...tile.said.chains.map((chain) => chain.error_pct ?? NaN));

const tileColumns = (model) => [
    { name: 'Tile', value: (tile) => tile.name, isName: true },
    {
        name: 'Verdict',
        value: (tile) => (tile.ok ? 'can be made' : codes(model, tile) || 'not judged'),
        isVerdict: true,
    },
    {
        name: 'Cut like',
        value: (tile) => tile.said.equal_to ?? (tile.said.mirror_of ? `${tile.said.mirror_of}, turned over` : ''),
    },
    { name: 'Area m²', value: (tile) => tile.said.area_m2, show: (value) => figure(value, 3) },
    { name: 'Area error', value: (tile) => tile.said.area_error_pct, show: (value) => percent(value) },
    { name: 'Worst edge', value: worstEdge, show: (value) => percent(value) },
    {
        name: 'Warp strain',
        value: (tile) => largest(tile.said.strain.warp_min_pct, tile.said.strain.warp_max_pct),
        show: (value) => percent(value),
    },
    {
        name: 'Weft strain',
        value: (tile) => largest(tile.said.strain.weft_min_pct, tile.said.strain.weft_max_pct),
        show: (value) => percent(value),
    },
    { name: 'Shear', value: (tile) => tile.said.strain.shear_max_deg, show: (value) => degrees(value, 2) },
];

const seamColumns = [
    { name: 'Seam', value: (seam) => seam.id, isName: true },
    {
        name: 'Verdict',
        value: (seam) => (seam.ok ? (seam.said.certain ? 'fits' : 'fits, not certain') : 'does not fit'),
        isVerdict: true,
    },
    { name: 'Between', value: (seam) => seam.said.tile_a },
    { name: 'and', value: (seam) => seam.said.tile_b },
    { name: 'As drawn mm', value: (seam) => seam.said.length_mm, show: (value) => figure(value, 1) },
    { name: 'On the first', value: (seam) => seam.said.flat_a_mm, show: (value) => figure(value, 1) },
    { name: 'On the second', value: (seam) => seam.said.flat_b_mm, show: (value) => figure(value, 1) },
    { name: 'Mismatch', value: (seam) => seam.said.mismatch_mm, show: (value) => signedMillimetres(value) },
    { name: 'Farthest apart mm', value: (seam) => seam.said.drift_max_mm, show: (value) => figure(value, 2) },
    { name: 'Allowed mm', value: (seam) => seam.said.limit_mm, show: (value) => figure(value, 2) },
];

const flightColumns = [
    {
        name: 'Off drawn mm',
        value: (tile) => tile.said.inflated.deviation_max_mm,
        show: (value) => signedMillimetres(value, 1),
    },
    { name: 'Tension N/m', value: (tile) => tile.said.inflated.stress_max_n_per_m, show: (value) => figure(value, 1) },
];
const tapeColumns = [
    { name: 'Tape cut mm', value: (seam) => seam.said.tape_cut_mm ?? 0, show: (value) => figure(value || NaN, 1) },
    {
        name: 'Tape bears N',
        value: (seam) => seam.said.tape_force_max_n ?? -1,
        show: (value) => figure(value < 0 ? NaN : value, 0),
    },
];

export function tileTable(model, onTile) {
    const columns = model.report.inflated ? [...tileColumns(model), ...flightColumns] : tileColumns(model);
    return sortedTable({ id: 'tiles', title: 'Tiles', one: 'tile', items: model.tiles, columns, onItem: onTile });
}

export function seamTable(model, onSeam) {
    const hasTapes = model.seams.some((seam) => seam.said.tape_cut_mm !== undefined);
    const columns = hasTapes ? [...seamColumns, ...tapeColumns] : seamColumns;
    return sortedTable({ id: 'seams', title: 'Seams', one: 'seam', items: model.seams, columns, onItem: onSeam });
}
