#include "ripstop/report/page/packed_arrays.h"

#include <cmath>
#include <limits>

namespace ripstop {
namespace {

template <class Number>
void append(std::string& bytes, Number value) {
    for (std::size_t k = 0; k < sizeof(Number); ++k) bytes += static_cast<char>((value >> (8 * k)) & 0xff);
}

template <class Number>
std::string steps(const std::vector<Number>& values, std::size_t columns) {
    std::string bytes;
    bytes.reserve(values.size() * sizeof(Number));
    for (std::size_t i = 0; i < values.size(); ++i) {
        const Number before = i < columns ? Number(0) : values[i - columns];
        append(bytes, static_cast<Number>(values[i] - before));
    }
    return bytes;
}

}  // namespace

int PackedArrays::add(const std::vector<std::int16_t>& values) {
    std::string bytes;
    bytes.reserve(2 * values.size());
    for (const std::int16_t value : values) append(bytes, static_cast<std::uint16_t>(value));
    return add_bytes(std::move(bytes));
}

int PackedArrays::add_steps(const std::vector<std::uint16_t>& values, std::size_t columns) {
    return add_bytes(steps(values, columns));
}

int PackedArrays::add_steps(const std::vector<std::uint32_t>& values, std::size_t columns) {
    return add_bytes(steps(values, columns));
}

int PackedArrays::add_bytes(std::string bytes) {
    const auto [entry, is_new] = known_.try_emplace(std::move(bytes), static_cast<int>(places_.size()));
    if (!is_new) return entry->second;
    places_.push_back({bytes_.size(), entry->first.size()});
    bytes_ += entry->first;
    bytes_.resize((bytes_.size() + 3) / 4 * 4, '\0');
    return entry->second;
}

SteppedValues stepped(const Eigen::VectorXd& values, double finest) {
    constexpr int most = std::numeric_limits<std::int16_t>::max();
    double largest = 0;
    for (const double value : values)
        if (std::isfinite(value)) largest = std::max(largest, std::abs(value));
    SteppedValues result{finest, {}};
    while (largest / result.step > most) result.step *= 2;
    for (const double value : values)
        result.values.push_back(std::isfinite(value) ? static_cast<std::int16_t>(std::lround(value / result.step))
                                                     : std::numeric_limits<std::int16_t>::min());
    return result;
}

GridPoints on_grid(const Eigen::MatrixXd& points) {
    GridPoints result;
    result.lower = points.colwise().minCoeff();
    const double side = (points.colwise().maxCoeff().transpose() - result.lower).maxCoeff();
    result.step = side > 0 ? side / std::numeric_limits<std::uint16_t>::max() : 1;
    for (Eigen::Index i = 0; i < points.rows(); ++i)
        for (Eigen::Index k = 0; k < points.cols(); ++k)
            result.values.push_back(
                static_cast<std::uint16_t>(std::lround((points(i, k) - result.lower[k]) / result.step)));
    return result;
}

}  // namespace ripstop
