#include "ripstop/geometry/predicates.h"

#include <array>
#include <cmath>

namespace ripstop {
namespace {

int sign(double value) {
    return (value > 0) - (value < 0);
}

/// An exact sum of doubles: a floating-point expansion of non-overlapping parts, smallest first.
class ExactSum {
  public:
    void add(double value) {
        for (std::size_t i = 0; i < size_; ++i) {
            const double part = parts_[i];
            const double sum = value + part;
            const double of_part = sum - value;
            parts_[i] = (value - (sum - of_part)) + (part - of_part);
            value = sum;
        }
        parts_[size_++] = value;
    }
    void add_product(double x, double y) {
        const double product = x * y;
        add(std::fma(x, y, -product));
        add(product);
    }
    int sign_of() const {
        for (std::size_t i = size_; i-- > 0;)
            if (parts_[i] != 0) return sign(parts_[i]);
        return 0;
    }

  private:
    std::array<double, 12> parts_{};
    std::size_t size_ = 0;
};

}  // namespace

int orient2d(const Vec2& a, const Vec2& b, const Vec2& c) {
    const double left = (a.x() - c.x()) * (b.y() - c.y());
    const double right = (a.y() - c.y()) * (b.x() - c.x());
    constexpr double rounding = 0x1p-53;
    constexpr double bound = (3 + 16 * rounding) * rounding;
    if (std::abs(left - right) > bound * (std::abs(left) + std::abs(right))) return sign(left - right);
    ExactSum sum;
    sum.add_product(a.x(), b.y());
    sum.add_product(-a.y(), b.x());
    sum.add_product(b.x(), c.y());
    sum.add_product(-b.y(), c.x());
    sum.add_product(c.x(), a.y());
    sum.add_product(-c.y(), a.x());
    return sum.sign_of();
}

}  // namespace ripstop
