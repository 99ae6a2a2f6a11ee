#pragma once

#include <string>
#include <vector>

#include "ripstop/geometry/types.h"
#include "ripstop/report/view/drawing.h"
#include "ripstop/report/view/map_view.h"

/// Common parts of the PNG pictures, as SVG; positions in page units, y down. Ink and colours are the page's.
namespace ripstop {

inline constexpr const char* page_ink = "#1f2933";
inline constexpr const char* page_soft = "#4a5763";
inline constexpr const char* page_good = "#126b44";
inline constexpr const char* page_bad = "#a50f2d";
inline constexpr const char* page_chosen = "#00734f";

/// A complete SVG document of this size with the drawing `content`.
std::string page_svg(const Eigen::Vector2i& size, const std::string& content);

/// The approximate width of a text in letters of this size; slightly too large for Latin letters.
double text_width(const std::string& text, double size, bool is_bold = false);

/// A text no wider than `width`, cut with an ellipsis if necessary.
std::string text_within(const Vec2& at, const std::string& content, double width, const TextStyle& style = {});

/// Lines of text below each other from `at` on, at most `most`; the last one states how many more there are.
std::string text_lines(const Vec2& at, const std::vector<std::string>& lines, std::size_t most, double width,
                       const TextStyle& style = {});
inline constexpr double line_step = 1.4;  ///< distance between lines, in letter sizes

/// A mark to the left of a text at `at`: a green dot, or a red lozenge for a fault.
std::string verdict_mark(const Vec2& at, bool is_good);

/// The legend of a map in its first scale, with numbers and words; `at`: the middle of its top edge. Its size is
/// `legend_size`.
std::string map_legend(const Vec2& at, const MapView& view);
inline const Vec2 legend_size(640, 84);

/// The path `M x y L x y …`, optionally closed.
std::string path_of(const std::vector<Vec2>& points, bool is_closed = false);

}  // namespace ripstop
