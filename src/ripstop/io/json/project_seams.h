#pragma once

#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

#include "ripstop/model/tile/seam_type.h"

namespace ripstop {

/// Which way an edge runs on the cloth: within 45 degrees of the warp, or not.
enum class EdgeDirection { any, along_warp, across_warp };

/// How a project wants some seams sewn, or some edges without mate finished.
struct SeamRule {
    std::string tile;                 ///< the name or pattern of one side, or of the tile of a free edge
    std::optional<std::string> mate;  ///< of the other side, either way round; none: free edges
    EdgeDirection direction = EdgeDirection::any;
    SeamType type;
    std::optional<double> mate_allowance = {};  ///< on the side of `mate`, where it is not the type's [m]

    /// For messages: `seam between "A" and "B"`, `free edge of "A"`.
    std::string text() const;
    /// Whether the rule is for a seam of these tiles; for a free edge of this one.
    bool fits_seam(const std::string& a, const std::string& b) const;
    bool fits_free(const std::string& tile_name) const;
    /// Whether `a` fits `tile` and `b` fits `mate`, in this order.
    bool is_in_order(const std::string& a, const std::string& b) const;
    /// No pattern: names its tiles in full.
    bool is_exact() const;
};

/// The types of the program with those of a project, `seam_types`, in place of or behind them. Throws InputError that
/// begins with `place`.
std::vector<SeamType> read_seam_types(const nlohmann::json& value, const std::string& place);

/// The rules of a project, `seams`, their types looked up among `types`. Throws InputError that begins with `place`.
std::vector<SeamRule> read_seam_rules(const nlohmann::json& value, const std::vector<SeamType>& types,
                                      const std::string& place);

}  // namespace ripstop
