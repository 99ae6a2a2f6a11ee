#pragma once

#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

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

    /// For messages: `seam between "A" and "B"`, `free edge of "A"`.
    std::string text() const;
    /// Whether the rule applies to a seam between these tiles, or to a free edge of this tile.
    bool fits_seam(const std::string& a, const std::string& b) const;
    bool fits_free(const std::string& tile_name) const;
    /// Whether `a` matches `tile` and `b` matches `mate`, in this order.
    bool is_in_order(const std::string& a, const std::string& b) const;
    /// Whether the rule gives its tiles' full names, without a pattern.
    bool is_exact() const;
};

/// The program's seam types, replaced and extended by those of a project (`seam_types`). Throws InputError that
/// begins with `place`.
std::vector<SeamType> read_seam_types(const nlohmann::json& value, const std::string& place);

/// The seam rules of a project (`seams`), with their types looked up in `types`. Throws InputError that begins
/// with `place`.
std::vector<SeamRule> read_seam_rules(const nlohmann::json& value, const std::vector<SeamType>& types,
                                      const std::string& place);

}  // namespace ripstop
