// The cloth and the band along its edges with WebGL, in the colours of a map.
import { clothArrays, clothMesh, paletteTexture, rimArrays, setShades, turnFacings } from './cloth_mesh.js';
import { coarseMesh } from './coarse_mesh.js';
import { shadesOf } from './shape.js';

export function makeCloth(shape, group) {
    const uniforms = { palette: { value: null } };
    const arrays = clothArrays(shape);
    const cloth = clothMesh(arrays, uniforms, 4);
    const rim = clothMesh(rimArrays(shape.rim), uniforms, 1);
    const coarseShape = coarseMesh(shape);
    const coarse = coarseShape && clothMesh(rimArrays(coarseShape), uniforms, 4);
    const meshes = [cloth, rim, ...(coarse ? [coarse] : [])];
    group.add(...meshes);
    return {
        // Uses fewer triangles during motion if there are many.
        showCoarse(isCoarse) {
            cloth.visible = !(isCoarse && coarse);
            if (coarse) coarse.visible = isCoarse;
        },
        // Call after the tiles have moved.
        place() {
            arrays.place();
            coarseShape?.place();
            for (const mesh of meshes) turnFacings(mesh.geometry);
        },
        recolour(look) {
            uniforms.palette.value?.dispose();
            uniforms.palette.value = paletteTexture(look.table);
            const shades = shadesOf(shape, look);
            setShades(cloth, shades.cloth);
            setShades(rim, shades.rim);
            if (coarse)
                setShades(
                    coarse,
                    coarseShape.of.map((t) => shades.cloth[t]),
                );
        },
    };
}
