#pragma once

#include <Eigen/Core>

namespace ripstop::testing {

/// The derivative of f: R^n -> R^m at x (m x n) by central differences. Its error is about f''' step² / 6 plus
/// 1e-16 |f| / step.
template <class Function>
Eigen::MatrixXd jacobian(Function&& f, const Eigen::VectorXd& x, double step = 1e-5) {
    Eigen::MatrixXd result;
    for (Eigen::Index i = 0; i < x.size(); ++i) {
        Eigen::VectorXd up = x, down = x;
        up[i] += step;
        down[i] -= step;
        const Eigen::VectorXd change = (f(up) - f(down)) / (up[i] - down[i]);
        if (i == 0) result.resize(change.size(), x.size());
        result.col(i) = change;
    }
    return result;
}

}  // namespace ripstop::testing
