// The envelope in 3D with WebGL, drawn only when something changes.
import { Group, Scene, WebGLRenderer } from 'three';
import { makeCamera, makeSight, makeSteering } from './camera.js';
import { makeCloth } from './cloth.js';
import { makeFrames } from './frames.js';
import { makeMarks } from './marks.js';
import { pointedAt } from './shape.js';
import { thinLines } from './wide_lines.js';

// Throws if the browser has no WebGL 2.
export function makeEnvelopeScene(shape, canvas) {
    const renderer = new WebGLRenderer({ canvas, antialias: false, preserveDrawingBuffer: true });
    renderer.setClearColor(0xffffff);
    const scene = new Scene(),
        group = new Group(),
        camera = makeCamera(shape);
    scene.add(group);
    const cloth = makeCloth(shape, group);
    const thin = thinLines(shape.model);
    group.add(thin.lines);
    const marks = makeMarks(shape, group);
    const frames = makeFrames(renderer, scene, camera, cloth.showCoarse);
    const { home, lookAt, turn, zoom } = makeSteering(shape, camera, canvas, frames);
    const { rayThrough, project } = makeSight(camera, canvas);
    return {
        home,
        lookAt,
        turn,
        zoom,
        drawNow: frames.drawNow,
        // Call after `shape.pose`.
        repose() {
            cloth.place();
            thin.place();
            marks.place();
            frames.request();
        },
        recolour(look) {
            cloth.recolour(look);
            frames.refresh();
        },
        choose(tiles, seam) {
            marks.choose(tiles, seam);
            frames.refresh();
        },
        mark(tiles, seams) {
            marks.mark(tiles, seams);
            frames.refresh();
        },
        pointed: (x, y) => pointedAt(shape, rayThrough(x, y), [x, y], project),
        resize(width, height) {
            const isFirst = camera.position.lengthSq() === 0;
            renderer.setSize(width, height, false);
            camera.aspect = width / height;
            camera.updateProjectionMatrix();
            if (isFirst) home(true);
            frames.request();
        },
    };
}
