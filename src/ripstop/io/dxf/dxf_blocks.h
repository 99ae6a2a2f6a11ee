#pragma once

#include <vector>

#include "ripstop/io/dxf/dxf.h"
#include "ripstop/io/dxf/dxf_dialect.h"
#include "ripstop/io/dxf/dxf_entities.h"

namespace ripstop {

/// The layers of the dialects with blocks, with what each is for.
std::vector<DxfLayer> numbered_layers();

/// The sections BLOCKS and ENTITIES: each piece in a BLOCK, where it is in the drawing, inserted at the origin; then
/// the texts of the style, beginning at `corner`.
void write_blocks(DxfEntities& out, const DxfDialect& dialect, const std::vector<PatternPiece>& placed_pieces,
                  const Vec2& corner, const DxfOptions& options);

}  // namespace ripstop
