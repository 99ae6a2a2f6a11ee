// The camera of the WebGL picture: the pointer turns it, and it flies to the chosen item.
import { PerspectiveCamera, Raycaster, Vector2, Vector3 } from 'three';
import { OrbitControls } from 'three/addons/controls/OrbitControls.js';
import { homeDirection } from './shape.js';

export function makeCamera(shape) {
    return new PerspectiveCamera(32, 1, shape.radius / 100, shape.radius * 20);
}

function makeControls(shape, camera, canvas, onChange) {
    const controls = new OrbitControls(camera, canvas);
    controls.enableDamping = false;
    controls.minDistance = shape.radius / 20;
    controls.maxDistance = shape.radius * 10;
    controls.addEventListener('change', onChange);
    return controls;
}

// Turns to look at a place from a direction; immediately if motion is not wanted. Returns the step to run before each
// picture, null when it has arrived.
function flight(camera, controls, target, direction, distance, isInstant) {
    const end = new Vector3(...target);
    const endOffset = new Vector3(...direction).normalize().multiplyScalar(distance);
    const start = { target: controls.target.clone(), offset: camera.position.clone().sub(controls.target) };
    const began = performance.now(),
        lasting = isInstant || matchMedia('(prefers-reduced-motion: reduce)').matches ? 0 : 350;
    return () => {
        const share = lasting ? Math.min(1, (performance.now() - began) / lasting) : 1;
        const eased = share * share * (3 - 2 * share);
        controls.target.lerpVectors(start.target, end, eased);
        const offset = start.offset.clone().lerp(endOffset, eased);
        offset.setLength(start.offset.length() + eased * (endOffset.length() - start.offset.length()));
        camera.position.copy(controls.target).add(offset);
        return share >= 1;
    };
}

// `frames`: from makeFrames; is told when to draw, and what to run before each picture.
export function makeSteering(shape, camera, canvas, frames) {
    const controls = makeControls(shape, camera, canvas, frames.request);
    const flyTo = (...where) => {
        const fly = flight(camera, controls, ...where);
        frames.step.now = () => {
            const isThere = fly();
            if (isThere) frames.step.now = null;
            controls.update();
            if (!isThere) setTimeout(frames.request);
        };
        frames.request();
    };
    const wholeDistance = () =>
        (shape.radius * 1.02) / Math.sin(((camera.fov / 2) * Math.PI) / 180) / Math.min(1, camera.aspect);
    const ask = () => {
        controls.update();
        frames.request();
    };
    return {
        home: (isInstant = false) => flyTo(shape.centre, homeDirection, wholeDistance(), isInstant),
        lookAt({ middle, normal, radius }) {
            const distance = Math.min(wholeDistance(), Math.max(6 * radius, 1.6 * shape.radius));
            flyTo(middle, [normal[0], normal[1] * 0.8 + 0.05, normal[2]], distance, false);
        },
        turn(right, up) {
            const offset = camera.position.clone().sub(controls.target);
            const reach = offset.length();
            const azimuth = Math.atan2(offset.x, offset.z) + right;
            const height = Math.min(1.5, Math.max(-1.5, Math.asin(offset.y / reach) + up));
            camera.position
                .set(Math.sin(azimuth) * Math.cos(height), Math.sin(height), Math.cos(azimuth) * Math.cos(height))
                .multiplyScalar(reach)
                .add(controls.target);
            ask();
        },
        zoom(factor) {
            camera.position.sub(controls.target).multiplyScalar(factor).add(controls.target);
            ask();
        },
    };
}

// The ray through a place of the canvas, and the place of a point on the canvas.
export function makeSight(camera, canvas) {
    const ray = new Raycaster(),
        projected = new Vector3();
    return {
        rayThrough(x, y) {
            ray.setFromCamera(new Vector2((x / canvas.clientWidth) * 2 - 1, 1 - (y / canvas.clientHeight) * 2), camera);
            return { origin: ray.ray.origin.toArray(), direction: ray.ray.direction.toArray() };
        },
        project(point) {
            projected.set(...point).project(camera);
            return [((projected.x + 1) / 2) * canvas.clientWidth, ((1 - projected.y) / 2) * canvas.clientHeight];
        },
    };
}
