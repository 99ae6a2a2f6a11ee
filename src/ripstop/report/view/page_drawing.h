#pragma once

#include <string>
#include <vector>

#include "ripstop/geometry/types.h"
#include "ripstop/report/view/drawing.h"
#include "ripstop/report/view/map_view.h"

/// What the PNG pictures have in common, as SVG; places in units of the page, y down. Ink and colours are the page's.
namespace ripstop {

inline constexpr const char* page_ink = "#1f2933";
inline constexpr const char* page_soft = "#4a5763";
inline constexpr const char* page_good = "#126b44";
inline constexpr const char* page_bad = "#a50f2d";
inline constexpr const char* page_chosen = "#00734f";

/// The drawing `content` as a whole document of this size.
std::string page_svg(const Eigen::Vector2i& size, const std::string& content);

/// About how wide a text is in letters of this size: a little more than it is in Latin ones.
double text_width(const std::string& text, double size, bool is_bold = false);

/// A text that ends before `width`, with an ellipsis where it had to be cut.
std::string text_within(const Vec2& at, const std::string& content, double width, const TextStyle& style = {});

/// Lines below one another from `at` on, at most `most`; the last says how many more there are.
std::string text_lines(const Vec2& at, const std::vector<std::string>& lines, std::size_t most, double width,
                       const TextStyle& style = {});
inline constexpr double line_step = 1.4;  ///< from line to line, in sizes of their letters

/// A green dot, or a red lozenge where something is wrong, left of a text at `at`.
std::string verdict_mark(const Vec2& at, bool is_good);

/// The colours of a map, in the scale it is shown in, with their numbers and words; `at`: the upper middle.
/// `legend_size` of the page.
std::string map_legend(const Vec2& at, const MapView& view);
inline const Vec2 legend_size(640, 84);

/// `M x y L x y …`, closed if asked for.
std::string path_of(const std::vector<Vec2>& points, bool is_closed = false);

}  // namespace ripstop
