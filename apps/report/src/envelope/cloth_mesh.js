// The cloth as a WebGL mesh: one colour and one normal per triangle, with the palette as a texture.
import { BufferAttribute, BufferGeometry, DataTexture, DoubleSide, GLSL3, Mesh, RawShaderMaterial } from 'three';
import { places } from '../view/palette.js';
import { withOwnCorners } from './shared_corners.js';

const vertexShader = `
precision highp float;
uniform mat4 modelViewMatrix, projectionMatrix;
uniform sampler2D palette;
in vec3 position, facing;
in float shade;
flat out vec3 vColour;
void main() {
    vec4 view = modelViewMatrix * vec4(position, 1.0);
    vec3 normal = mat3(modelViewMatrix) * facing;
    vec3 cloth = texelFetch(palette, ivec2(int(shade + 0.5), 0), 0).rgb;
    // A little light from the viewer: it shows the shape and leaves the colours readable.
    vColour = cloth * (0.76 + 0.24 * abs(dot(normal, normalize(view.xyz))));
    gl_Position = projectionMatrix * view;
}`;

const fragmentShader = `
precision mediump float;
flat in vec3 vColour;
out vec4 colour;
void main() {
    colour = vec4(vColour, 1.0);
}`;

export function paletteTexture(table) {
    const texture = new DataTexture(table, places.count, 1);
    texture.needsUpdate = true;
    return texture;
}

// The outward normals of triangles, in steps of 1/127, at their last corners. Allocates no array per triangle, because
// it runs again whenever the slider moves.
export function turnFacings({ attributes, index: { array: index } }) {
    const p = attributes.position.array,
        facing = attributes.facing.array;
    for (let t = 0; t < index.length; t += 3) {
        const a = 3 * index[t],
            b = 3 * index[t + 1],
            c = 3 * index[t + 2];
        const ex = p[b] - p[a],
            ey = p[b + 1] - p[a + 1],
            ez = p[b + 2] - p[a + 2];
        const fx = p[c] - p[a],
            fy = p[c + 1] - p[a + 1],
            fz = p[c + 2] - p[a + 2];
        const x = ey * fz - ez * fy,
            y = ez * fx - ex * fz,
            z = ex * fy - ey * fx;
        const scale = 127 / (Math.sqrt(x * x + y * y + z * z) || 1);
        facing[c] = Math.round(scale * x);
        facing[c + 1] = Math.round(scale * y);
        facing[c + 2] = Math.round(scale * z);
    }
    attributes.position.needsUpdate = attributes.facing.needsUpdate = true;
}

// The colour and the normal of a triangle are stored at its last corner.
export function clothMesh({ positions, index }, uniforms, offset) {
    const geometry = new BufferGeometry();
    const count = positions.length / 3;
    geometry.setAttribute('position', new BufferAttribute(positions, 3));
    geometry.setAttribute('shade', new BufferAttribute(new Uint16Array(count), 1));
    geometry.setIndex(new BufferAttribute(index, 1));
    geometry.setAttribute('facing', new BufferAttribute(new Int8Array(3 * count), 3, true));
    turnFacings(geometry);
    const material = new RawShaderMaterial({
        glslVersion: GLSL3,
        vertexShader,
        fragmentShader,
        uniforms,
        side: DoubleSide,
        polygonOffset: true,
        polygonOffsetFactor: offset,
        polygonOffsetUnits: offset,
    });
    const mesh = new Mesh(geometry, material);
    mesh.frustumCulled = false; // it is what there is to see, wherever its corners go
    return mesh;
}

export function clothArrays(shape) {
    const { tiles } = shape.model;
    const parts = tiles.map((tile) => withOwnCorners(tile.triangles, tile.space.length / 3));
    const positions = new Float32Array(3 * parts.reduce((sum, part) => sum + part.copies.length, 0));
    const place = () => {
        let at = 0;
        parts.forEach(({ copies }, i) => {
            const { space } = tiles[i];
            for (const vertex of copies) for (let k = 0; k < 3; ++k) positions[at++] = space[3 * vertex + k];
        });
    };
    place();
    const index = new Uint32Array(3 * shape.triangleCount);
    let first = 0;
    parts.forEach((part, i) => {
        const { firstTriangle } = tiles[i];
        part.index.forEach((vertex, k) => {
            index[3 * firstTriangle + k] = first + vertex;
        });
        first += part.copies.length;
    });
    return { positions, index, place };
}

export const rimArrays = ({ positions }) => ({
    positions,
    index: Uint32Array.from({ length: positions.length / 3 }, (_, i) => i),
});

export function setShades(mesh, shades) {
    mesh.visible = shades !== null;
    if (!shades) return;
    const { index, attributes } = mesh.geometry;
    for (let t = 0; t < shades.length; ++t) attributes.shade.array[index.array[3 * t + 2]] = shades[t];
    attributes.shade.needsUpdate = true;
}
