#include "ripstop/pipeline/read/seam_rules.h"

#include <Eigen/Geometry>
#include <algorithm>

#include "ripstop/base/index.h"
#include "ripstop/io/json/project_seams.h"
#include "ripstop/io/text/text.h"
#include "ripstop/tile/allowance.h"

namespace ripstop {
namespace {

/// Direction of an edge relative to the warp: sums of squared components.
struct Way {
    double along = 0, across = 0;

    bool fits(EdgeDirection wanted) const {
        return wanted == EdgeDirection::any || (along >= across) == (wanted == EdgeDirection::along_warp);
    }
};

/// The edges of an envelope and their directions.
class Edges {
  public:
    explicit Edges(const Envelope& envelope) : envelope_(envelope) {
        for (const Tile& tile : envelope.tiles) normals_.push_back(area_vector(tile.mesh).normalized());
    }

    Way way(const Seam& seam) const {
        Way sum;
        for (const SeamSide* side : {&seam.a, &seam.b})
            for (const SeamPart& part : side->parts) {
                const std::vector<int>& boundary = tile(side->tile).boundary;
                const auto i = static_cast<std::size_t>(part.edge);
                add(side->tile, boundary[i], boundary[(i + 1) % boundary.size()], sum);
            }
        return sum;
    }

    Way way(int t, const Chain& chain) const {
        Way sum;
        for (std::size_t i = 1; i < chain.vertices.size(); ++i) add(t, chain.vertices[i - 1], chain.vertices[i], sum);
        return sum;
    }

  private:
    const Tile& tile(int t) const { return envelope_.tiles[at(t)]; }

    void add(int t, int from, int to, Way& sum) const {
        const Points3& x = tile(t).mesh.positions;
        const Vec3 edge = x.row(to) - x.row(from), &warp = tile(t).grain.direction;
        const double length = std::max(edge.norm(), 1e-300);
        sum.along += edge.dot(warp) * edge.dot(warp) / length;
        const double across = edge.dot(normals_[at(t)].cross(warp));
        sum.across += across * across / length;
    }

    const Envelope& envelope_;
    std::vector<Vec3> normals_;
};

const std::string& name_of(const Envelope& envelope, const SeamSide& side) {
    return envelope.tiles[at(side.tile)].name;
}

bool fits(const SeamRule& rule, const Seam& seam, const Envelope& envelope, const Edges& edges) {
    return rule.fits_seam(name_of(envelope, seam.a), name_of(envelope, seam.b)) &&
           (rule.direction == EdgeDirection::any || edges.way(seam).fits(rule.direction));
}

bool fits(const SeamRule& rule, int t, const Chain& chain, const Envelope& envelope, const Edges& edges) {
    return rule.fits_free(envelope.tiles[at(t)].name) &&
           (rule.direction == EdgeDirection::any || edges.way(t, chain).fits(rule.direction));
}

/// The rule that applies, null if none does.
template <class Fits>
const SeamRule* deciding_rule(const Project& project, Fits&& fits) {
    const SeamRule* found = nullptr;
    for (const SeamRule& rule : project.seams)
        if ((!found || rule.is_exact() || !found->is_exact()) && fits(rule)) found = &rule;
    return found;
}

const SeamType& known_type(const Project& project, const SeamType& standard) {
    const auto found = std::find_if(project.seam_types.begin(), project.seam_types.end(),
                                    [&](const SeamType& type) { return type.name == standard.name; });
    return found == project.seam_types.end() ? standard : *found;
}

bool is_used(const SeamRule& rule, const Envelope& envelope, const std::vector<Eigen::VectorXd>& left,
             const Edges& edges) {
    if (rule.mate)
        return std::any_of(envelope.seams.begin(), envelope.seams.end(),
                           [&](const Seam& seam) { return fits(rule, seam, envelope, edges); });
    for (std::size_t t = 0; t < envelope.tiles.size(); ++t)
        for (std::size_t c = 0; c < envelope.tiles[t].chains.size(); ++c)
            if (left[t][static_cast<Eigen::Index>(c)] > 0 &&
                fits(rule, static_cast<int>(t), envelope.tiles[t].chains[c], envelope, edges))
                return true;
    return false;
}

bool is_used(const std::string& material, const Envelope& envelope) {
    return std::any_of(envelope.tiles.begin(), envelope.tiles.end(), [&](const Tile& tile) {
        return std::any_of(tile.attributes.begin(), tile.attributes.end(), [&](const auto& attribute) {
            return attribute.second == material && (attribute.first == "material" || attribute.first == "fabric");
        });
    });
}

}  // namespace

void give_seam_types(Envelope& envelope, const Project& project) {
    const Edges edges(envelope);
    const SeamType felled = known_type(project, SeamType{}), hem = known_type(project, default_hem());
    for (Seam& seam : envelope.seams) {
        const SeamRule* rule =
            deciding_rule(project, [&](const SeamRule& one) { return fits(one, seam, envelope, edges); });
        seam.type = rule ? rule->type : seam.into ? envelope.seams[at(seam.into->seam)].type : felled;
        if (!rule || !rule->mate_allowance) continue;
        // if both sides match both names, b is the mate
        const bool a_is_mate = !rule->is_in_order(name_of(envelope, seam.a), name_of(envelope, seam.b));
        (a_is_mate ? seam.a : seam.b).allowance = rule->mate_allowance;
    }
    for (std::size_t t = 0; t < envelope.tiles.size(); ++t)
        for (Chain& chain : envelope.tiles[t].chains) {
            const SeamRule* rule = deciding_rule(
                project, [&](const SeamRule& one) { return fits(one, static_cast<int>(t), chain, envelope, edges); });
            chain.finish = rule ? rule->type : hem;
        }
}

std::vector<std::string> unused_entries(const Project& project, const Envelope& envelope) {
    std::vector<std::string> names, sentences;
    for (const Tile& tile : envelope.tiles) names.push_back(tile.name);
    for (const std::string& name : unused_names(project, names))
        sentences.push_back(project.file + ": no tile is called \"" + name + "\"");
    const Edges edges(envelope);
    const std::vector<Eigen::VectorXd> left = free_lengths(envelope);
    for (const SeamRule& rule : project.seams)
        if (!is_used(rule, envelope, left, edges))
            sentences.push_back(project.file + ": there is no " + seam_rule_text(rule) +
                                (rule.direction == EdgeDirection::any          ? ""
                                 : rule.direction == EdgeDirection::along_warp ? " along the warp"
                                                                               : " across the warp"));
    for (const auto& [material, fabric] : project.materials)
        if (!is_used(material, envelope))
            sentences.push_back(project.file + ": no tile is of the material " + shown(material));
    return sentences;
}

}  // namespace ripstop
