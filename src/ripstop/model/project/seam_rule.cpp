#include "ripstop/model/project/seam_rule.h"

#include "ripstop/base/text/glob.h"

namespace ripstop {
namespace {

bool fits(const std::string& pattern, const std::string& name) {
    return pattern == name || glob_match(pattern, name);
}

bool is_pattern(const std::string& name) {
    return name.find_first_of("*?") != std::string::npos;
}

}  // namespace

bool SeamRule::is_in_order(const std::string& a, const std::string& b) const {
    return mate && fits(tile, a) && fits(*mate, b);
}

bool SeamRule::fits_seam(const std::string& a, const std::string& b) const {
    return is_in_order(a, b) || is_in_order(b, a);
}

bool SeamRule::fits_free(const std::string& tile_name) const {
    return !mate && fits(tile, tile_name);
}

bool SeamRule::is_exact() const {
    return !is_pattern(tile) && !(mate && is_pattern(*mate));
}

}  // namespace ripstop
