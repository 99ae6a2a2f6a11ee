// Prints the contours that dxf-parser finds, one per line: block, layer, x and y of the lower corner, area,
// perimeter, number of polylines, and whether they close. Polylines that begin where the one before ends form one
// contour.
import { readFileSync } from 'node:fs';
import DxfParser from 'dxf-parser';

const drawing = new DxfParser().parseSync(readFileSync(process.argv[2], 'latin1'));
const near = (a, b) => Math.hypot(a.x - b.x, a.y - b.y) <= 0.001;

function contours(entities) {
    const found = [];
    for (const entity of entities) {
        if (entity.type !== 'POLYLINE') continue;
        const points = entity.vertices.map(({ x, y }) => ({ x, y }));
        const last = found[found.length - 1];
        const goesOn = last && !last.closed && last.layer === entity.layer && !entity.shape &&
            near(last.points[last.points.length - 1], points[0]);
        if (goesOn) {
            last.points.push(...points.slice(1));
            ++last.parts;
        } else {
            found.push({ layer: entity.layer, points, parts: 1, closed: Boolean(entity.shape) });
        }
        const contour = found[found.length - 1];
        if (!contour.closed && contour.points.length > 2 && near(contour.points[0], contour.points.at(-1))) {
            contour.points.pop();
            contour.closed = true;
        }
    }
    return found;
}

function print(name, { layer, points, parts, closed }) {
    let area = 0, perimeter = 0;
    points.forEach((p, i) => {
        const q = points[(i + 1) % points.length];
        area += (p.x * q.y - p.y * q.x) / 2;
        perimeter += Math.hypot(q.x - p.x, q.y - p.y);
    });
    const x = Math.min(...points.map((p) => p.x)), y = Math.min(...points.map((p) => p.y));
    console.log(name, layer, x, y, area, perimeter, parts, closed ? 1 : 0);
}

for (const contour of contours(drawing.entities)) print('-', contour);
for (const insert of drawing.entities.filter((entity) => entity.type === 'INSERT')) {
    if (insert.position.x !== 0 || insert.position.y !== 0) throw new Error(`${insert.name} is not inserted at the origin`);
    for (const contour of contours(drawing.blocks[insert.name].entities)) print(insert.name, contour);
}
