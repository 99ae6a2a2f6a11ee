#include "ripstop/model/tile/zigzag.h"

namespace ripstop {

std::string Zigzag::seams_text() const {
    if (seams.empty()) return {};
    return " (" + seams.front() + (seams.size() > 1 ? " to " + seams.back() : std::string()) + ")";
}

}  // namespace ripstop
