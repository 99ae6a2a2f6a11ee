#include "ripstop/pipeline/flatten/strain_maps.h"

#include <limits>

#include "ripstop/base/parallel.h"
#include "ripstop/measure/distortion.h"
#include "ripstop/pattern/piece/pieces.h"
#include "ripstop/tile/targets.h"

namespace ripstop {

std::vector<StrainMap> measure_strain_maps(const CutPlan& plan, int threads) {
    std::vector<StrainMap> maps(plan.tiles.size());
    parallel_for(static_cast<int>(plan.tiles.size()), threads, [&](int i) {
        const FlatTile& tile = plan.tiles[static_cast<std::size_t>(i)];
        if (!tile.is_flat()) return;
        const std::vector<TriangleDistortion> triangles =
            measure_distortion(target_triangles(tile.tile), tile.tile.mesh.triangles, tile.flattening.positions);
        StrainMap& map = maps[static_cast<std::size_t>(i)];
        for (Eigen::VectorXd* values : {&map.warp, &map.weft, &map.shear, &map.area})
            values->setConstant(static_cast<Eigen::Index>(triangles.size()), std::numeric_limits<double>::quiet_NaN());
        for (std::size_t t = 0; t < triangles.size(); ++t) {
            const TriangleDistortion& triangle = triangles[t];
            if (triangle.flipped) continue;
            const auto at = static_cast<Eigen::Index>(t);
            map.warp[at] = triangle.warp_strain;
            map.weft[at] = triangle.weft_strain;
            map.shear[at] = triangle.shear;
            map.area[at] = triangle.area_ratio - 1;
        }
    });
    return maps;
}

}  // namespace ripstop
