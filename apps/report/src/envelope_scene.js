// The envelope in 3D, by WebGL: drawn when something changes and not otherwise.
import {
    BufferAttribute,
    BufferGeometry,
    Group,
    LineBasicMaterial,
    LineSegments,
    PerspectiveCamera,
    Raycaster,
    Scene,
    Vector2,
    Vector3,
    WebGLRenderer,
} from 'three';
import { OrbitControls } from 'three/addons/controls/OrbitControls.js';
import { LineMaterial } from 'three/addons/lines/LineMaterial.js';
import { LineSegments2 } from 'three/addons/lines/LineSegments2.js';
import { LineSegmentsGeometry } from 'three/addons/lines/LineSegmentsGeometry.js';
import { clothArrays, clothMesh, paletteTexture, rimArrays, setShades, turnFacings } from './cloth_mesh.js';
import { coarseMesh } from './coarse_mesh.js';
import { edgesDrawnOnce, outlineOf, pointedAt, proposalLine, seamLine, shadesOf } from './envelope_shape.js';

class WideLines {
    constructor(parent, colour, width, order, options = {}) {
        this.material = new LineMaterial({ color: colour, linewidth: width, ...options });
        this.parent = parent;
        this.order = order;
        this.lines = null;
    }

    show(points) {
        if (this.lines) {
            this.parent.remove(this.lines);
            this.lines.geometry.dispose();
            this.lines = null;
        }
        if (points.length === 0) return;
        const geometry = new LineSegmentsGeometry();
        geometry.setPositions(points);
        this.lines = new LineSegments2(geometry, this.material);
        this.lines.renderOrder = this.order;
        if (this.material.dashed) this.lines.computeLineDistances();
        this.parent.add(this.lines);
    }
}

function thinLines(model) {
    const points = () => new Float32Array(model.tiles.flatMap(edgesDrawnOnce));
    const geometry = new BufferGeometry();
    geometry.setAttribute('position', new BufferAttribute(points(), 3));
    const lines = new LineSegments(geometry, new LineBasicMaterial({ color: 0x6f7a85 }));
    lines.frustumCulled = false;
    const place = () => {
        geometry.attributes.position.array.set(points());
        geometry.attributes.position.needsUpdate = true;
    };
    return { lines, place };
}

// Throws where the browser has no WebGL 2.
export function makeEnvelopeScene(shape, canvas) {
    const { model } = shape;
    const renderer = new WebGLRenderer({ canvas, antialias: false, preserveDrawingBuffer: true });
    renderer.setClearColor(0xffffff);
    const scene = new Scene(),
        group = new Group();
    scene.add(group);
    const uniforms = { palette: { value: null }, focus: { value: new Vector2(-1, -1) } };
    const arrays = clothArrays(shape);
    const cloth = clothMesh(arrays, uniforms, 4);
    const rim = clothMesh(rimArrays(shape.rim), uniforms, 1);
    const thin = thinLines(model);
    const coarseShape = coarseMesh(shape);
    const coarseCloth = coarseShape && clothMesh(rimArrays(coarseShape), uniforms, 4);
    group.add(cloth, rim, thin.lines, ...(coarseCloth ? [coarseCloth] : []));
    const failing = new WideLines(group, 0xa50f2d, 2.5, 1, { depthWrite: false });
    const proposed = new WideLines(group, 0x111111, 3, 2, {
        dashed: true,
        dashSize: shape.radius / 60,
        gapSize: shape.radius / 110,
    });
    const casing = new WideLines(group, 0xffffff, 8, 3, { depthWrite: false }),
        chosen = new WideLines(group, 0x00734f, 4.5, 4);
    const camera = new PerspectiveCamera(32, 1, shape.radius / 100, shape.radius * 20);
    const controls = new OrbitControls(camera, canvas);
    controls.enableDamping = false;
    controls.minDistance = shape.radius / 20;
    controls.maxDistance = shape.radius * 10;

    // Coarse while it moves, at four times the pixels once it rests: smooth edges at no price in speed.
    // Where even that is slow, as without a graphics card, coarser.
    let waiting = false,
        tween = null,
        resting = 0,
        last = 0,
        coarse = 1,
        isMoving = false;
    const render = (share) => {
        isMoving = share < 2;
        cloth.visible = !(isMoving && coarseCloth);
        if (coarseCloth) coarseCloth.visible = isMoving;
        const ratio = Math.min(3, window.devicePixelRatio * share);
        if (renderer.getPixelRatio() !== ratio) renderer.setPixelRatio(ratio);
        renderer.render(scene, camera);
    };
    const draw = (now) => {
        waiting = false;
        if (now - last > 45 && now - last < 300) coarse = Math.max(0.5, coarse - 0.125);
        last = now;
        if (tween) tween();
        render(coarse);
        clearTimeout(resting);
        resting = setTimeout(() => render(2), 200);
    };
    const request = () => {
        if (!waiting) requestAnimationFrame(draw);
        waiting = true;
    };
    // For what changes while nothing moves: to coarse pixels and back would take longer.
    const refresh = () => {
        if (isMoving) return request();
        requestAnimationFrame(() => !waiting && !isMoving && render(2));
    };
    controls.addEventListener('change', request);

    // Turns to look at a place from a direction; at once where motion is not wanted.
    const flyTo = (target, direction, distance, isInstant) => {
        const end = {
            target: new Vector3(...target),
            place: new Vector3(...target).addScaledVector(new Vector3(...direction).normalize(), distance),
        };
        const start = { target: controls.target.clone(), offset: camera.position.clone().sub(controls.target) };
        const endOffset = end.place.clone().sub(end.target);
        const began = performance.now(),
            lasting = isInstant || matchMedia('(prefers-reduced-motion: reduce)').matches ? 0 : 350;
        tween = () => {
            const share = lasting ? Math.min(1, (performance.now() - began) / lasting) : 1;
            const eased = share * share * (3 - 2 * share);
            controls.target.lerpVectors(start.target, end.target, eased);
            const offset = start.offset.clone().lerp(endOffset, eased);
            offset.setLength(start.offset.length() + eased * (endOffset.length() - start.offset.length()));
            camera.position.copy(controls.target).add(offset);
            if (share >= 1) tween = null;
            controls.update();
            if (tween) setTimeout(request);
        };
        request();
    };
    const wholeDistance = () =>
        (shape.radius * 1.08) / Math.sin(((camera.fov / 2) * Math.PI) / 180) / Math.min(1, camera.aspect);
    const flyHome = (isInstant) => flyTo(shape.centre, [0.55, 0.28, 1], wholeDistance(), isInstant);

    const ray = new Raycaster();
    const projected = new Vector3();
    const project = (point) => {
        projected.set(...point).project(camera);
        return [((projected.x + 1) / 2) * canvas.clientWidth, ((1 - projected.y) / 2) * canvas.clientHeight];
    };

    let showChosen = () => {},
        showMarked = () => {};
    return {
        // After `shape.pose`.
        repose() {
            arrays.place();
            coarseShape?.place();
            thin.place();
            for (const mesh of [cloth, rim, coarseCloth]) if (mesh) turnFacings(mesh.geometry);
            showChosen();
            showMarked();
            request();
        },
        recolour(map, palette) {
            uniforms.palette.value?.dispose();
            uniforms.palette.value = paletteTexture(palette);
            const shades = shadesOf(shape, map);
            setShades(cloth, shades.cloth);
            setShades(rim, shades.rim);
            if (coarseCloth)
                setShades(
                    coarseCloth,
                    coarseShape.of.map((t) => shades.cloth[t]),
                );
            refresh();
        },
        choose(tiles, seam) {
            uniforms.focus.value.set(tiles[0]?.index ?? -1, tiles[1]?.index ?? tiles[0]?.index ?? -1);
            // Seams are short: they are seen through the cloth too.
            casing.material.depthTest = chosen.material.depthTest = !seam;
            showChosen = () => {
                const line = seam ? seamLine(model, seam) : tiles.flatMap(outlineOf);
                casing.show(line);
                chosen.show(line);
            };
            showChosen();
            refresh();
        },
        mark(failingTiles, failingSeams) {
            showMarked = () =>
                failing.show([
                    ...failingTiles.flatMap(outlineOf),
                    ...failingSeams.flatMap((seam) => seamLine(model, seam)),
                ]);
            showMarked();
            proposed.show(failingTiles.flatMap((tile) => proposalLine(shape, tile)));
            refresh();
        },
        lookAt({ middle, normal, radius }) {
            flyTo(
                middle,
                [normal[0], normal[1] * 0.8 + 0.05, normal[2]],
                Math.min(wholeDistance(), Math.max(6 * radius, 1.6 * shape.radius)),
                false,
            );
        },
        home: () => flyHome(false),
        turn(right, up) {
            const offset = camera.position.clone().sub(controls.target);
            const reach = offset.length();
            const azimuth = Math.atan2(offset.x, offset.z) + right;
            const height = Math.min(1.5, Math.max(-1.5, Math.asin(offset.y / reach) + up));
            camera.position
                .set(Math.sin(azimuth) * Math.cos(height), Math.sin(height), Math.cos(azimuth) * Math.cos(height))
                .multiplyScalar(reach)
                .add(controls.target);
            controls.update();
            request();
        },
        zoom(factor) {
            camera.position.sub(controls.target).multiplyScalar(factor).add(controls.target);
            controls.update();
            request();
        },
        pointed(x, y) {
            ray.setFromCamera(new Vector2((x / canvas.clientWidth) * 2 - 1, 1 - (y / canvas.clientHeight) * 2), camera);
            return pointedAt(
                shape,
                { origin: ray.ray.origin.toArray(), direction: ray.ray.direction.toArray() },
                [x, y],
                project,
            );
        },
        resize(width, height) {
            const isFirst = camera.position.lengthSq() === 0;
            renderer.setSize(width, height, false);
            camera.aspect = width / height;
            camera.updateProjectionMatrix();
            if (isFirst) flyHome(true);
            request();
        },
        drawNow: () => render(2),
    };
}
