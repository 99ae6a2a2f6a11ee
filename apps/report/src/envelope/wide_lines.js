// Lines of the WebGL picture: wide ones for emphasis, and the thin ones between the tiles.
import { BufferAttribute, BufferGeometry, LineBasicMaterial, LineSegments } from 'three';
import { LineMaterial } from 'three/addons/lines/LineMaterial.js';
import { LineSegments2 } from 'three/addons/lines/LineSegments2.js';
import { LineSegmentsGeometry } from 'three/addons/lines/LineSegmentsGeometry.js';
import { edgesDrawnOnce } from './lines.js';

export class WideLines {
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

// `place` moves them after the tiles have moved.
export function thinLines(model) {
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
