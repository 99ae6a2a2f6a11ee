#include "ripstop/nest/roll_strip.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace ripstop {

double Joins::after(double x) const {
    if (lengths.empty()) return std::numeric_limits<double>::infinity();
    double end = 0;
    for (const double length : lengths) {
        end += length;
        if (end > x) return end;
    }
    const double past = std::floor((x - end) / lengths.back());
    end += past * lengths.back();
    while (end <= x) end += lengths.back();  // usually once; again only because of rounding
    return end;
}

double Joins::before(double x) const {
    double last = -std::numeric_limits<double>::infinity();
    for (double join = after(0); join <= x; join = after(join)) last = join;
    return last;
}

double Strip::first_free(const std::vector<Interval>& taken, double from, double length) const {
    double at = from;
    for (auto next = taken.begin();;) {
        for (; next != taken.end() && next->lower < at; ++next) at = std::max(at, next->upper);
        const double join = joins.after(at);
        if (at + length <= join) return at;
        at = join;
    }
}

}  // namespace ripstop
