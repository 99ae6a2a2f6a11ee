// The entries of the list: tiles or seams, all or only those that fail, filtered by a part of their names.
import { sewnTiles } from '../view/format.js';

export function makeListed(model, { onTile, onSeam }) {
    const kinds = {
        tile: { name: 'Tiles', items: model.tiles, label: (tile) => tile.name, open: onTile },
        seam: {
            name: 'Seams',
            items: model.seams,
            label: (seam) => `${seam.id}  ${sewnTiles(seam.said)}`,
            open: onSeam,
        },
    };
    const failing = { tile: model.tiles.some((tile) => !tile.ok), seam: model.seams.some((seam) => !seam.ok) };
    const kind = failing.seam && !failing.tile ? 'seam' : 'tile';
    const called = (id) =>
        kinds[id].items.filter((item) => kinds[id].label(item).toLowerCase().includes(listed.wanted));
    const listed = {
        kinds,
        hasFailing: failing.tile || failing.seam,
        kind,
        onlyFailing: failing[kind],
        wanted: '',
        shown: [],
        fill() {
            listed.shown = called(listed.kind).filter((item) => !listed.onlyFailing || !item.ok);
        },
        turnTo(next) {
            listed.kind = next;
            if (!failing[next]) listed.onlyFailing = false;
        },
        other: () => (listed.kind === 'tile' ? 'seam' : 'tile'),
        // The number of matches that do not fail and, if there is none, of matches of the other kind.
        elsewhere() {
            const { wanted, onlyFailing, shown } = listed;
            const more = wanted && onlyFailing ? called(listed.kind).filter((item) => item.ok).length : 0;
            return { more, others: wanted && shown.length + more === 0 ? called(listed.other()).length : 0 };
        },
        open: (item) => item && kinds[listed.kind].open(item),
    };
    return listed;
}
