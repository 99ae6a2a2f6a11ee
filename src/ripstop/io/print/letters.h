#pragma once

#include <string>
#include <vector>

#include "ripstop/model/piece/pattern_piece.h"

// of cairo.h, which only what draws needs
typedef struct _cairo cairo_t;

namespace ripstop {

/// DejaVu Sans, or what the system has in its place; shapes and widths unhinted, so that they scale.
void choose_letters(cairo_t* context);

/// What of a text the letters of `context` can write: UTF-8 without control characters; ASCII where no font is
/// installed, for then cairo draws with its own that knows no more.
std::string writable(cairo_t* context, const std::string& text);

/// Sets the size at which capitals are `height` high, in the units of `context`.
void set_letter_height(cairo_t* context, double height);

/// The label as lines for a pen, the outlines of its letters, in metres where it stands: each closed by its first
/// point. A curve is kept within 1/200 of the letters' height.
std::vector<Points2> letter_outlines(const Label& label);

}  // namespace ripstop
