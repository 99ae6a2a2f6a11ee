// The chosen item, whatever was clicked, and the next failing one.
import { failingSeams, failingTiles } from '../tables/verdict.js';

export function makeChooser(model, state) {
    const chooser = {
        // Called with the chosen item, and whether it was clicked in the 3D view.
        onChosen: () => {},
        choose(kind, item, isSeen = false) {
            state.change({ chosen: { kind, index: item.index } });
            chooser.onChosen(kind, item, isSeen);
        },
        chooseNothing: () => state.change({ chosen: null }),
        onTile: (tile) => chooser.choose('tile', tile),
        onSeam: (seam) => chooser.choose('seam', seam),
        onFound(found) {
            if (found?.seam) chooser.choose('seam', found.seam, true);
            else if (found) chooser.choose('tile', found.tile, true);
            else chooser.chooseNothing();
        },
        nextFailing() {
            const failing = [
                ...failingTiles(model).map((item) => ['tile', item]),
                ...failingSeams(model).map((item) => ['seam', item]),
            ];
            const { chosen } = state.now;
            const at = failing.findIndex(([kind, item]) => chosen?.kind === kind && chosen.index === item.index);
            chooser.choose(...failing[(at + 1) % failing.length]);
        },
        // The chosen tiles, and the chosen seam.
        chosen() {
            const { chosen } = state.now;
            if (!chosen) return [[], null];
            if (chosen.kind === 'tile') return [[model.tiles[chosen.index]], null];
            const seam = model.seams[chosen.index];
            return [seam.sides.map((side) => model.tiles[side.tile]), seam];
        },
    };
    return chooser;
}
