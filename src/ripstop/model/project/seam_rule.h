#pragma once

#include <optional>
#include <string>

#include "ripstop/model/tile/seam_type.h"

namespace ripstop {

/// The direction of an edge on the cloth: within 45 degrees of the warp, or not.
enum class EdgeDirection { any, along_warp, across_warp };

/// A project's choice of the seam type for some seams, or of the finish for some free edges.
struct SeamRule {
    std::string tile;                 ///< name or pattern of one side, or of the tile of a free edge
    std::optional<std::string> mate;  ///< name or pattern of the other side, in either order; none: the rule is
                                      ///< for free edges
    EdgeDirection direction = EdgeDirection::any;
    SeamType type;
    std::optional<double> mate_allowance = {};  ///< on the side of `mate`, if it differs from the type's [m]

    /// Whether the rule applies to a seam between these tiles, or to a free edge of this tile.
    bool fits_seam(const std::string& a, const std::string& b) const;
    bool fits_free(const std::string& tile_name) const;
    /// Whether `a` matches `tile` and `b` matches `mate`, in this order.
    bool is_in_order(const std::string& a, const std::string& b) const;
    /// Whether the rule gives its tiles' full names, without a pattern.
    bool is_exact() const;
};

}  // namespace ripstop
