#pragma once

#include <string>
#include <vector>

#include "ripstop/model/piece/pattern_piece.h"

// cairo.h itself is only needed by sources that draw
typedef struct _cairo cairo_t;

namespace ripstop {

/// Chooses DejaVu Sans, or the system's substitute for it. Shapes and widths are unhinted, so that they scale.
void choose_letters(cairo_t* context);

/// The part of a text that the font of `context` can write: UTF-8 without control characters. ASCII if no font is
/// installed, because cairo's built-in font has nothing else.
std::string writable(cairo_t* context, const std::string& text);

/// Sets the font size so that capitals are `height` high, in the units of `context`.
void set_letter_height(cairo_t* context, double height);

/// The outlines of a label's letters as lines for a pen, in metres, at the label's place. Each line repeats its
/// first point at the end. Curves are kept within 1/200 of the letters' height.
std::vector<Points2> letter_outlines(const Label& label);

}  // namespace ripstop
