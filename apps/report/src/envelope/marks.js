// Marks drawn over the cloth with WebGL: faults, proposed seams, the chosen item.
import { outlineOf, proposalLine, seamLine } from './lines.js';
import { WideLines } from './wide_lines.js';

export function makeMarks(shape, group) {
    const { model } = shape;
    const failing = new WideLines(group, 0xa50f2d, 2.5, 1, { depthWrite: false });
    const proposed = new WideLines(group, 0x111111, 3, 2, {
        dashed: true,
        dashSize: shape.radius / 60,
        gapSize: shape.radius / 110,
    });
    const casing = new WideLines(group, 0xffffff, 8, 3, { depthWrite: false }),
        chosen = new WideLines(group, 0x00734f, 4.5, 4);
    let showChosen = () => {},
        showFailing = () => {};
    return {
        // Call after the tiles have moved.
        place() {
            showChosen();
            showFailing();
        },
        choose(tiles, seam) {
            // A chosen seam is short, so it is drawn through the cloth too.
            casing.material.depthTest = chosen.material.depthTest = !seam;
            showChosen = () => {
                const line = seam ? seamLine(model, seam) : tiles.flatMap(outlineOf);
                casing.show(line);
                chosen.show(line);
            };
            showChosen();
        },
        mark(tiles, seams) {
            showFailing = () =>
                failing.show([...tiles.flatMap(outlineOf), ...seams.flatMap((seam) => seamLine(model, seam))]);
            showFailing();
            proposed.show(tiles.flatMap((tile) => proposalLine(shape, tile)));
        },
    };
}
