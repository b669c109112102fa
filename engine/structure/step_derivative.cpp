// SPDX-License-Identifier: BSD-3-Clause
#include "engine/structure/step_derivative.hpp"

#include <array>

namespace kreisel {
inline namespace KREISEL_PRECISION {

namespace {

/// The fifth root of eps, nearly: there the truncation error of an extrapolated difference, O(e^4), meets eps/e.
const Real widest_difference = ldexp(Real(1), KREISEL_QUAD ? -20 : -8);

/// y_1^{-1} times the state that a step leads to from y exp(e X), in the algebra.
class Displacement {
  public:
    Displacement(const ObservedStep& at, const std::vector<Real>& y1)
        : at_(at), group_(at.system.state_group()), y_(y1.size()), inverse_(y1.size()) {
        group_.inverse(y1.data(), inverse_.data());
    }

    Status find(const VecX& eX, VecX& u) {
        group_.append_exp(at_.y, eX.data(), y_.data());
        if (const Status status = at_.step(at_.t, at_.h, y_.data()); status != Status::ok) return status;
        group_.multiply(inverse_.data(), y_.data(), y_.data());
        group_.log(y_.data(), u.data());
        return Status::ok;
    }
    /// (u(e) - u(-e)) / 2e.
    Status difference(const VecX& X, const Real& e, VecX& derivative) {
        VecX back(X.size());
        Status status = find(e * X, derivative);
        if (status == Status::ok) status = find(-e * X, back);
        derivative = ((derivative - back) / (2 * e)).eval();
        return status;
    }

  private:
    const ObservedStep& at_;
    const TangentGroup& group_;
    std::vector<Real> y_, inverse_;
};

}  // namespace

Real StepDerivative::round_off() { return epsilon * 4 / widest_difference; }

StepDerivative derivative_of(const ObservedStep& at, const MatX& X, MotionUnits& units, const Real& rate) {
    StepDerivative found{{at.y, at.y + at.system.state_group().size()}, X, X};
    if (found.status = at.step(at.t, at.h, found.y1.data()); found.status != Status::ok) return found;
    Displacement displacement(at, found.y1);
    for (Eigen::Index i = 0; i < X.cols(); ++i) {
        const VecX vector = X.col(i);
        const Real* w = at.system.state_group().dv(vector.data());
        const Real e = widest_difference / max(units(at.y, vector.data()), Real(units(at.y, w) / rate));
        std::array<VecX, 3> at_e, pairs;
        for (std::size_t k = 0; k < 3; ++k) {
            at_e[k].resize(X.rows());
            found.status = displacement.difference(vector, ldexp(e, -static_cast<int>(k)), at_e[k]);
            if (found.status != Status::ok) return found;
            if (k > 0) pairs[k] = (4 * at_e[k] - at_e[k - 1]) / 3;
        }
        found.coarse.col(i) = pairs[1], found.fine.col(i) = pairs[2];
    }
    return found;
}

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
