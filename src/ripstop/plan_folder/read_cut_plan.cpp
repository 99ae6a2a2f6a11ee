#include "ripstop/plan_folder/read_cut_plan.h"

#include <algorithm>
#include <fstream>

#include "ripstop/base/error.h"
#include "ripstop/io/json/sewing_json.h"
#include "ripstop/io/mesh/mesh_file.h"
#include "ripstop/measure/judge_seams.h"
#include "ripstop/measure/walk_seams.h"
#include "ripstop/mesh/adjacency.h"
#include "ripstop/mesh/disk.h"

namespace ripstop {
namespace {

[[noreturn]] void refuse(const std::filesystem::path& file, const std::string& what) {
    throw InputError(file.string() + ": " + what + "; flatten the envelope again");
}

/// Splits the boundary at the vertices where chains start.
void cut_boundary(Tile& tile, const std::vector<int>& corners, const std::filesystem::path& file) {
    std::vector<int> loop = tile.boundary;
    const auto first = std::find(loop.begin(), loop.end(), corners.front());
    if (first == loop.end()) refuse(file, "a corner of flat/sewing.json is not a vertex of its boundary");
    std::rotate(loop.begin(), first, loop.end());
    loop.push_back(loop.front());
    std::size_t from = 0;
    for (std::size_t c = 0; c < corners.size(); ++c) {
        const bool is_last = c + 1 == corners.size();
        const auto next = is_last
                              ? loop.end() - 1
                              : std::find(loop.begin() + static_cast<std::ptrdiff_t>(from), loop.end(), corners[c + 1]);
        if (next == loop.end()) refuse(file, "the corners of flat/sewing.json do not follow its boundary");
        const std::size_t to = static_cast<std::size_t>(next - loop.begin());
        tile.chains[c].vertices.assign(loop.begin() + static_cast<std::ptrdiff_t>(from),
                                       loop.begin() + static_cast<std::ptrdiff_t>(to) + 1);
        from = to;
    }
}

void read_mesh(const std::filesystem::path& file, const std::vector<int>& corners, FlatTile& flat) {
    CadModel model = read_model(file);
    if (model.surfaces.size() != 1 || !model.surfaces[0].drawn)
        refuse(file, "does not hold one tile with flat positions");
    Tile& tile = flat.tile;
    tile.mesh = std::move(model.surfaces[0].mesh);
    flat.flattening.positions = *model.surfaces[0].drawn;
    tile.boundary = require_disk(tile.mesh, Adjacency(tile.mesh.triangles, tile.mesh.vertex_count()), tile.name);
    cut_boundary(tile, corners, file);
    if (tile.curve_lengths.size() != 0 && tile.curve_lengths.size() != std::ssize(tile.boundary))
        refuse(file, "has a different boundary than flat/sewing.json");
    if (tile.grain.field.rows() != 0 && tile.grain.field.rows() != tile.mesh.triangle_count())
        refuse(file, "has a different number of triangles than flat/sewing.json");
    const Eigen::Index tensions = flat.flattening.seam_tension.size();
    if (tensions != 0 && tensions != std::ssize(tile.boundary))
        refuse(file, "has a different boundary than flat/sewing.json");
}

void require_sides(const CutPlan& plan, const std::filesystem::path& file) {
    for (const Seam& seam : plan.seams)
        for (const SeamSide* side : {&seam.a, &seam.b}) {
            const Tile& tile = plan.tiles[static_cast<std::size_t>(side->tile)].tile;
            if (side->chain >= std::ssize(tile.chains))
                refuse(file, "seam " + seam.id + " is on a chain that does not exist");
            for (const SeamPart& part : side->parts)
                if (part.edge >= std::ssize(tile.boundary))
                    refuse(file, "seam " + seam.id + " is on an edge that does not exist");
        }
}

/// Walks and judges the seams again. The verdicts are kept, because they also cover the input and the pieces.
void walk(CutPlan& plan) {
    std::vector<Finding> findings = plan.findings;
    std::vector<Verdict> verdicts;
    for (const FlatTile& tile : plan.tiles) verdicts.push_back(tile.verdict);
    plan.walks = walk_seams(plan.tiles, plan.seams, plan.tolerances);
    judge_seams(plan);
    plan.findings = std::move(findings);
    for (std::size_t i = 0; i < plan.tiles.size(); ++i) plan.tiles[i].verdict = std::move(verdicts[i]);
}

}  // namespace

CutPlan read_cut_plan(const std::filesystem::path& folder) {
    const std::filesystem::path file = folder / "flat" / "sewing.json";
    std::ifstream in(file, std::ios::binary);
    if (!in)
        throw InputError(
            folder.string() +
            ": cannot be sewn, because it contains no flat/sewing.json; give a folder that `ripstop flatten` "
            "wrote");
    Sewing sewing = read_sewing(in, file.string());
    CutPlan& plan = sewing.plan;
    for (std::size_t i = 0; i < plan.tiles.size(); ++i)
        read_mesh(folder / "flat" / (sewing.files[i] + ".obj"), sewing.corners[i], plan.tiles[i]);
    require_sides(plan, file);
    walk(plan);
    return std::move(plan);
}

}  // namespace ripstop
