#include "ripstop/report/picture/png_pictures.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

#include "ripstop/base/parallel.h"
#include "ripstop/base/text/lower_case.h"
#include "ripstop/io/text/output_file.h"
#include "ripstop/io/text/png.h"
#include "ripstop/report/figures/figures.h"
#include "ripstop/report/picture/envelope_png.h"
#include "ripstop/report/picture/piece_png.h"
#include "ripstop/report/picture/seam_picture.h"

namespace ripstop {
namespace {

namespace fs = std::filesystem;

/// The piece of each tile; pieces are in the order of their tiles.
std::vector<const PatternPiece*> pieces_of_tiles(const CutPlan& plan, const std::vector<PatternPiece>& pieces) {
    std::vector<const PatternPiece*> found(plan.tiles.size(), nullptr);
    std::size_t tile = 0;
    for (const PatternPiece& piece : pieces) {
        while (tile < plan.tiles.size() && plan.tiles[tile].tile.name != piece.name) ++tile;
        if (tile == plan.tiles.size()) break;
        found[tile++] = &piece;
    }
    return found;
}

std::string picture_stem(const std::string& stem) {
    const std::string small = lower_case(stem);
    const bool is_taken = small.starts_with("envelope") || small.starts_with("seam-") || small.starts_with("tile-");
    return is_taken ? "tile-" + stem : stem;
}

/// Tiles that are cut the same share the first one's picture, unless their verdicts differ.
bool has_picture(const CutPlan& plan, const FlatTile& tile) {
    if (tile.equal_to < 0) return true;
    const FlatTile& first = plan.tiles[static_cast<std::size_t>(tile.equal_to)];
    return tile.verdict.manufacturable() != first.verdict.manufacturable();
}

}  // namespace

std::vector<std::size_t> pictured_seams(const CutPlan& plan) {
    std::vector<std::size_t> failing;
    for (std::size_t i = 0; i < plan.walks.size(); ++i)
        if (!plan.walks[i].ok) failing.push_back(i);
    const auto badness = [&](std::size_t i) {
        const double share = plan.walks[i].drift_max / plan.walks[i].limit;
        return std::isnan(share) ? std::numeric_limits<double>::infinity() : share;
    };
    std::stable_sort(failing.begin(), failing.end(),
                     [&](std::size_t a, std::size_t b) { return badness(a) > badness(b); });
    failing.resize(std::min(failing.size(), most_seam_pictures));
    return failing;
}

void write_png_pictures(const fs::path& folder, const CutPlan& plan, const std::vector<PatternPiece>& pieces,
                        const std::vector<StrainMap>& strains, int threads) {
    const std::vector<const PatternPiece*> of_tiles = pieces_of_tiles(plan, pieces);
    const std::vector<MapView> maps = map_views(plan, strains);
    const PieceSource source{plan, of_tiles, maps};
    const EnvelopeSights drawn = see_envelope(plan, threads);
    const EnvelopeSights inflated = plan.inflated ? see_envelope(plan, threads, true) : EnvelopeSights();
    std::vector<std::function<void()>> tasks;
    const std::string_view first = first_map(plan, strains);
    for (const MapView& map : maps)
        tasks.emplace_back([&] {
            const std::string picture = envelope_png(plan, map.map->is_in_flight ? inflated : drawn, map);
            write_file(folder / ("envelope-" + std::string(map.map->id) + ".png"), picture);
            if (map.map->id == first) write_file(folder / "envelope.png", picture);
        });
    if (!plan.walks.empty())
        tasks.emplace_back([&] { write_file(folder / "seams.png", png_picture(seam_picture(plan))); });
    const std::vector<std::string> stems = file_stems(plan);
    for (std::size_t i = 0; i < plan.tiles.size(); ++i) {
        if (!has_picture(plan, plan.tiles[i])) continue;
        tasks.emplace_back([&, i] { write_file(folder / (picture_stem(stems[i]) + ".png"), tile_png(source, i)); });
    }
    std::vector<std::string> ids;
    for (const Seam& seam : plan.seams) ids.push_back(seam.id);
    const std::vector<std::string> seam_stems = file_stems(ids);
    for (const std::size_t i : pictured_seams(plan))
        tasks.emplace_back([&, i] { write_file(folder / ("seam-" + seam_stems[i] + ".png"), seam_png(source, i)); });
    parallel_for(static_cast<int>(tasks.size()), threads, [&](int i) { tasks[static_cast<std::size_t>(i)](); });
}

}  // namespace ripstop
