// Lines in space, as consecutive pairs of points.
import { sidePoints } from '../view/data.js';

function pairs(points, isClosed) {
    const result = [];
    for (let i = 0; i + 1 < points.length + (isClosed ? 1 : 0); ++i)
        result.push(...points[i], ...points[(i + 1) % points.length]);
    return result;
}

export const outlineOf = (tile) =>
    pairs(
        Array.from(tile.loop, (vertex) => tile.space.subarray(3 * vertex, 3 * vertex + 3)),
        true,
    );

// The part of the boundary that no other tile draws: the first of the two sides of a seam.
export function edgesDrawnOnce(tile) {
    const isElsewhere = new Uint8Array(tile.loop.length);
    for (const side of tile.sides)
        if (side.name === 'b')
            for (let i = 0; i < side.count; ++i) isElsewhere[(side.first + i) % isElsewhere.length] = 1;
    const at = (i) => 3 * tile.loop[i % tile.loop.length];
    return Array.from(tile.loop).flatMap((_, i) =>
        isElsewhere[i]
            ? []
            : [...tile.space.subarray(at(i), at(i) + 3), ...tile.space.subarray(at(i + 1), at(i + 1) + 3)],
    );
}

export const seamLine = (model, seam) =>
    seam.sides
        .slice(0, 1)
        .flatMap((side) => pairs(sidePoints(model.tiles[side.tile], side, model.tiles[side.tile].space, 3), false));

export function proposalLine(shape, tile) {
    const line = tile.said.proposal?.line_mm ?? [];
    return pairs(
        line.map((point) => shape.turn(point.map((value) => value / 1000))),
        false,
    );
}
