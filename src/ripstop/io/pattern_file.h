#pragma once

#include <filesystem>

#include "ripstop/model/piece/pattern_drawing.h"

namespace ripstop {

/// Reads a pattern file from any program, .dxf or .svg by its extension. Throws InputError as `read_dxf` and
/// `read_svg` do, for another extension, and for a file that cannot be opened.
PatternDrawing read_pattern_file(const std::filesystem::path& path);

}  // namespace ripstop
