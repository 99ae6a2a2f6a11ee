#include "ripstop/io/svg/svg_clip.h"

#include "ripstop/geometry/polygon.h"
#include "ripstop/io/svg/svg_shape.h"
#include "ripstop/io/svg/values/svg_view.h"

namespace ripstop {
namespace {

Points2 outline_of(const SvgRun& run, const Eigen::Affine2d& motion) {
    const std::vector<Vec2> points = sampled(run, motion, {1e9, 1e-5});
    Points2 outline(static_cast<Eigen::Index>(points.size()), 2);
    for (std::size_t i = 0; i < points.size(); ++i) outline.row(static_cast<Eigen::Index>(i)) = points[i];
    return outline;
}

bool is_within(const Points2& outline, const Points2& line) {
    const Vec2 lower = outline.colwise().minCoeff(), upper = outline.colwise().maxCoeff();
    const double slack = 1e-6 * (upper - lower).maxCoeff();
    for (Eigen::Index i = 0; i < line.rows(); ++i) {
        const Vec2 point = line.row(i);
        if ((lower - point).maxCoeff() > slack || (point - upper).maxCoeff() > slack) return false;
        if (!contains(outline, point) && distance_to_outline(outline, point) > slack) return false;
    }
    return true;
}

bool is_apart(const Points2& outline, const Points2& line) {
    const Vec2 lower = outline.colwise().minCoeff(), upper = outline.colwise().maxCoeff();
    const Vec2 low = line.colwise().minCoeff(), high = line.colwise().maxCoeff();
    return (lower - high).maxCoeff() >= 0 || (low - upper).maxCoeff() >= 0;
}

}  // namespace

SvgClip SvgClip::viewport(const Vec2& size, const Eigen::Affine2d& motion) {
    SvgClip clip;
    clip.is_known_ = size.allFinite() && size.minCoeff() > 0;
    if (clip.is_known_) clip.outlines_ = {outline_of(svg_rectangle({0, 0}, size, {0, 0}), motion)};
    return clip;
}

SvgClip SvgClip::path(const SvgDocument& document, const SvgStyles& styles, const pugi::xml_node& clip_path,
                      const Eigen::Affine2d& motion, const SvgBasis& basis) {
    constexpr int most_shapes = 100;
    SvgClip clip;
    const SvgStyle own = styles.of(clip_path);
    if (svg_local_name(clip_path) != "clipPath" || own.is_declared("clip-path")) return clip;
    if (std::string_view(clip_path.attribute("clipPathUnits").value()) == "objectBoundingBox") return clip;
    const Eigen::Affine2d within = motion * svg_transform(own["transform"], basis, document.place_of(clip_path));
    int shapes = 0;
    for (const pugi::xml_node& child : clip_path.children()) {
        if (child.type() != pugi::node_element) continue;
        const SvgStyle style = styles.of(child);
        if (style["display"] == "none") continue;
        const std::string place = document.place_of(child);
        const auto shape = svg_shape(child, style, basis, place);
        if (!shape || !shape->unclear.empty() || style.is_declared("clip-path") || ++shapes > most_shapes) return clip;
        for (const SvgRun& run : shape->runs)
            clip.outlines_.push_back(outline_of(run, within * svg_transform(style["transform"], basis, place)));
    }
    clip.is_known_ = true;
    return clip;
}

SvgSeen SvgClip::seen(const Points2& line) const {
    if (!is_known_) return SvgSeen::part;
    bool is_nowhere = true;
    for (const Points2& outline : outlines_) {
        if (is_within(outline, line)) return SvgSeen::all;
        is_nowhere = is_nowhere && is_apart(outline, line);
    }
    return is_nowhere ? SvgSeen::nothing : SvgSeen::part;
}

}  // namespace ripstop
