// A parallel projection: maps points to the canvas, and places of the canvas to rays.
export function makeProjection(shape, canvas) {
    let azimuth = 0.5,
        height = 0.25,
        magnified = 1;
    const focus = shape.centre;

    // The data of the projection: asked of the page once per picture, because asking takes longer than drawing.
    let look = null;
    const takeLook = () => {
        const { clientWidth: width, clientHeight: high } = canvas;
        look = {
            sin: Math.sin(azimuth),
            cos: Math.cos(azimuth),
            sinHeight: Math.sin(height),
            cosHeight: Math.cos(height),
            x: width / 2,
            y: high / 2,
            scale: (magnified * 0.47 * Math.min(width, high)) / shape.radius,
        };
    };
    return {
        takeLook,
        // x and y on the canvas, and the depth.
        project(point) {
            const x = point[0] - focus[0],
                y = point[1] - focus[1],
                z = point[2] - focus[2];
            const across = x * look.cos - z * look.sin,
                towards = x * look.sin + z * look.cos;
            const up = y * look.cosHeight - towards * look.sinHeight;
            return [
                look.x + look.scale * across,
                look.y - look.scale * up,
                towards * look.cosHeight + y * look.sinHeight,
            ];
        },
        // The ray's origin in the plane of the screen, far in front.
        rayThrough(x, y) {
            takeLook();
            const { sin, cos, sinHeight, cosHeight } = look;
            const across = (x - look.x) / look.scale,
                up = (look.y - y) / look.scale;
            const right = [cos, 0, -sin],
                towards = [sin * cosHeight, sinHeight, cos * cosHeight],
                upward = [-sin * sinHeight, cosHeight, -cos * sinHeight];
            const origin = focus.map(
                (value, k) => value + across * right[k] + up * upward[k] + 10 * shape.radius * towards[k],
            );
            return { origin, direction: towards.map((value) => -value) };
        },
        turn(right, up) {
            azimuth += right;
            height = Math.min(1.5, Math.max(-1.5, height + up));
        },
        zoom(factor) {
            magnified = Math.min(40, Math.max(0.2, magnified / factor));
        },
        lookAlong(normal) {
            azimuth = Math.atan2(normal[0], normal[2]);
            height = Math.asin(Math.max(-1, Math.min(1, normal[1]))) * 0.8;
        },
        home() {
            [azimuth, height, magnified] = [0.5, 0.25, 1];
        },
    };
}
