// The envelope in 3D, by WebGL: drawn when something changes and not otherwise.
import {
    BufferAttribute, BufferGeometry, DataTexture, DoubleSide, GLSL3, Group, LineBasicMaterial, LineSegments, Mesh, PerspectiveCamera,
    RawShaderMaterial, Raycaster, Scene, Sphere, Vector2, Vector3, WebGLRenderer,
} from 'three';
import { OrbitControls } from 'three/addons/controls/OrbitControls.js';
import { LineMaterial } from 'three/addons/lines/LineMaterial.js';
import { LineSegments2 } from 'three/addons/lines/LineSegments2.js';
import { LineSegmentsGeometry } from 'three/addons/lines/LineSegmentsGeometry.js';
import { outlineOf, pointedAt, proposalLine, seamLine, shadesOf } from './envelope_shape.js';
import { paletteTable, places } from './palette.js';

const vertexShader = `
precision highp float;
uniform mat4 modelViewMatrix, projectionMatrix;
in vec3 position;
in float shade, tile;
flat out float vShade, vTile;
out vec3 vView;
void main() {
    vec4 view = modelViewMatrix * vec4(position, 1.0);
    vShade = shade;
    vTile = tile;
    vView = view.xyz;
    gl_Position = projectionMatrix * view;
}`;

// A little light from the viewer, so that shape can be seen and colours can still be read.
const fragmentShader = `
precision highp float;
uniform sampler2D palette;
uniform vec2 focus;
flat in float vShade, vTile;
in vec3 vView;
out vec4 colour;
void main() {
    vec3 normal = normalize(cross(dFdx(vView), dFdy(vView)));
    vec3 cloth = texelFetch(palette, ivec2(int(vShade + 0.5), 0), 0).rgb;
    if (focus.x >= 0.0 && vTile != focus.x && vTile != focus.y) cloth = mix(cloth, vec3(0.93), 0.5);
    colour = vec4(cloth * (0.76 + 0.24 * abs(normal.z)), 1.0);
}`;

function paletteTexture(id) {
    const texture = new DataTexture(paletteTable(id), places.count, 1);
    texture.needsUpdate = true;
    return texture;
}

function clothMesh(positions, ids, uniforms, sphere, offset) {
    const geometry = new BufferGeometry();
    geometry.setAttribute('position', new BufferAttribute(positions, 3));
    geometry.setAttribute('tile', new BufferAttribute(ids, 1));
    geometry.setAttribute('shade', new BufferAttribute(new Uint16Array(ids.length), 1));
    geometry.boundingSphere = sphere;
    const material = new RawShaderMaterial({
        glslVersion: GLSL3, vertexShader, fragmentShader, uniforms, side: DoubleSide,
        polygonOffset: true, polygonOffsetFactor: offset, polygonOffsetUnits: offset,
    });
    return new Mesh(geometry, material);
}

function setShades(mesh, shades) {
    mesh.visible = shades !== null;
    if (!shades) return;
    mesh.geometry.attributes.shade.array.set(shades);
    mesh.geometry.attributes.shade.needsUpdate = true;
}

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
    const points = new Float32Array(model.tiles.flatMap(outlineOf));
    const geometry = new BufferGeometry();
    geometry.setAttribute('position', new BufferAttribute(points, 3));
    return new LineSegments(geometry, new LineBasicMaterial({ color: 0x1f2933, transparent: true, opacity: 0.42 }));
}

// Throws where the browser has no WebGL 2.
export function makeEnvelopeScene(shape, canvas) {
    const { model } = shape;
    const renderer = new WebGLRenderer({ canvas, antialias: true, preserveDrawingBuffer: true });
    renderer.setClearColor(0xffffff);
    const scene = new Scene(), group = new Group();
    scene.add(group);
    const uniforms = { palette: { value: null }, focus: { value: new Vector2(-1, -1) } };
    const sphere = new Sphere(new Vector3(...shape.centre), shape.radius);
    const cloth = clothMesh(shape.positions, shape.ids, uniforms, sphere, 2);
    const rim = clothMesh(shape.rim.positions, shape.rim.ids, uniforms, sphere, -1);
    group.add(cloth, rim, thinLines(model));
    const failing = new WideLines(group, 0xa50f2d, 2.5, 1);
    const proposed = new WideLines(group, 0x111111, 3, 2, { dashed: true, dashSize: shape.radius / 60, gapSize: shape.radius / 110 });
    const casing = new WideLines(group, 0xffffff, 8, 3, { depthWrite: false }), chosen = new WideLines(group, 0x00734f, 4.5, 4);
    const camera = new PerspectiveCamera(32, 1, shape.radius / 100, shape.radius * 20);
    const controls = new OrbitControls(camera, canvas);
    controls.enableDamping = false;
    controls.minDistance = shape.radius / 20;
    controls.maxDistance = shape.radius * 10;

    let waiting = false, tween = null;
    const draw = () => {
        waiting = false;
        if (tween) tween();
        renderer.render(scene, camera);
    };
    const request = () => {
        if (!waiting) requestAnimationFrame(draw);
        waiting = true;
    };
    controls.addEventListener('change', request);

    // Turns to look at a place from a direction; at once where motion is not wanted.
    const flyTo = (target, direction, distance, isInstant) => {
        const end = { target: new Vector3(...target), place: new Vector3(...target).addScaledVector(new Vector3(...direction).normalize(), distance) };
        const start = { target: controls.target.clone(), offset: camera.position.clone().sub(controls.target) };
        const endOffset = end.place.clone().sub(end.target);
        const began = performance.now(), lasting = isInstant || matchMedia('(prefers-reduced-motion: reduce)').matches ? 0 : 350;
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
    const wholeDistance = () => (shape.radius * 1.08) / Math.sin(((camera.fov / 2) * Math.PI) / 180) / Math.min(1, camera.aspect);
    const flyHome = (isInstant) => flyTo(shape.centre, [0.55, 0.28, 1], wholeDistance(), isInstant);

    const ray = new Raycaster();
    const projected = new Vector3();
    const project = (point) => {
        projected.set(...point).project(camera);
        return [((projected.x + 1) / 2) * canvas.clientWidth, ((1 - projected.y) / 2) * canvas.clientHeight];
    };

    return {
        recolour(map, palette) {
            uniforms.palette.value?.dispose();
            uniforms.palette.value = paletteTexture(palette);
            const shades = shadesOf(shape, map);
            setShades(cloth, shades.cloth);
            setShades(rim, shades.rim);
            request();
        },
        choose(tiles, seam) {
            uniforms.focus.value.set(tiles[0]?.index ?? -1, tiles[1]?.index ?? tiles[0]?.index ?? -1);
            const line = seam ? seamLine(model, seam) : tiles.flatMap(outlineOf);
            // Seams are short: they are seen through the cloth too.
            casing.material.depthTest = chosen.material.depthTest = !seam;
            casing.show(line);
            chosen.show(line);
            request();
        },
        mark(failingTiles, failingSeams) {
            failing.show([...failingTiles.flatMap(outlineOf), ...failingSeams.flatMap((seam) => seamLine(model, seam))]);
            proposed.show(failingTiles.flatMap((tile) => proposalLine(shape, tile)));
            request();
        },
        lookAt({ middle, normal, radius }) {
            flyTo(middle, [normal[0], normal[1] * 0.8 + 0.05, normal[2]], Math.max(6 * radius, Math.min(wholeDistance(), 1.6 * shape.radius)), false);
        },
        home: () => flyHome(false),
        turn(right, up) {
            const offset = camera.position.clone().sub(controls.target);
            const reach = offset.length();
            const azimuth = Math.atan2(offset.x, offset.z) + right;
            const height = Math.min(1.5, Math.max(-1.5, Math.asin(offset.y / reach) + up));
            camera.position.set(Math.sin(azimuth) * Math.cos(height), Math.sin(height), Math.cos(azimuth) * Math.cos(height)).multiplyScalar(reach).add(controls.target);
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
            return pointedAt(shape, { origin: ray.ray.origin.toArray(), direction: ray.ray.direction.toArray() }, [x, y], project);
        },
        resize(width, height) {
            const isFirst = camera.position.lengthSq() === 0;
            renderer.setPixelRatio(Math.min(2, window.devicePixelRatio));
            renderer.setSize(width, height, false);
            camera.aspect = width / height;
            camera.updateProjectionMatrix();
            if (isFirst) flyHome(true);
            request();
        },
        drawNow: draw,
    };
}
