#pragma once

#include <vector>

#include "ripstop/io/dxf/dxf.h"
#include "ripstop/io/dxf/dxf_dialect.h"
#include "ripstop/io/dxf/dxf_entities.h"

namespace ripstop {

/// The layers of the dialects with blocks, and their purposes.
std::vector<DxfLayer> numbered_layers();

/// Writes the sections BLOCKS and ENTITIES: each piece as a BLOCK at its place in the drawing, inserted at the
/// origin; then the style's texts, starting at `corner`.
void write_blocks(DxfEntities& out, const DxfDialect& dialect, const std::vector<PatternPiece>& placed_pieces,
                  const Vec2& corner, const DxfOptions& options);

}  // namespace ripstop
