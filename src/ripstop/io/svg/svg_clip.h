#pragma once

#include <Eigen/Geometry>
#include <memory>
#include <vector>

#include "ripstop/io/svg/style/svg_style.h"
#include "ripstop/io/svg/values/svg_length.h"

namespace ripstop {

/// How much of a line is visible through a clip.
enum class SvgSeen { all, part, nothing };

/// A clip in the numbers of the drawing: the union of its outlines, or unknown.
class SvgClip {
  public:
    /// The rectangle of a viewport, with a corner at the origin.
    static SvgClip viewport(const Vec2& size, const Eigen::Affine2d& motion);
    /// A `clipPath` of shapes in user space. Any other content (text, clipped clips, units of the clipped
    /// element's bounding box) makes the clip unknown.
    static SvgClip path(const SvgDocument& document, const SvgStyles& styles, const pugi::xml_node& clip_path,
                        const Eigen::Affine2d& motion, const SvgBasis& basis);
    static SvgClip unknown() { return {}; }

    /// How much of a line is visible, judged by its points: `all` if every point lies within the same outline, to
    /// 1e-6 of the outline's size. So a line between two points counts as `all` even if it leaves an outline that
    /// is not convex.
    SvgSeen seen(const Points2& line) const;

  private:
    bool is_known_ = false;
    std::vector<Points2> outlines_ = {};
};

using SvgClips = std::vector<std::shared_ptr<const SvgClip>>;

}  // namespace ripstop
