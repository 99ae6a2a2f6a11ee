#pragma once

#include <Eigen/Geometry>
#include <memory>
#include <vector>

#include "ripstop/io/svg/style/svg_style.h"
#include "ripstop/io/svg/values/svg_length.h"

namespace ripstop {

/// What of a drawing is seen through an opening.
enum class SvgSeen { all, part, nothing };

/// An opening, in the numbers of the drawing: within any of its outlines, or not known.
class SvgClip {
  public:
    /// The rectangle of a viewport from the origin.
    static SvgClip viewport(const Vec2& size, const Eigen::Affine2d& motion);
    /// A `clipPath` of shapes in user space; one of anything else (text, clips of clips, parts of the box of what is
    /// clipped) is not known.
    static SvgClip path(const SvgDocument& document, const SvgStyles& styles, const pugi::xml_node& clip_path,
                        const Eigen::Affine2d& motion, const SvgBasis& basis);
    static SvgClip unknown() { return {}; }

    /// By its points: all where each lies within one and the same outline, to 1e-6 of the outline's size. Of a line
    /// between two points that leaves an outline which is not convex it says all as well.
    SvgSeen seen(const Points2& line) const;

  private:
    bool is_known_ = false;
    std::vector<Points2> outlines_ = {};
};

using SvgClips = std::vector<std::shared_ptr<const SvgClip>>;

}  // namespace ripstop
