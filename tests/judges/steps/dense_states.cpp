// SPDX-License-Identifier: BSD-3-Clause
#include "tests/judges/steps/dense_states.hpp"

#include <Eigen/LU>

#include "mechanics/actions/acted_upon.hpp"
#include "tests/judges/families/dense_step.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

DenseStates::DenseStates(RecordedRun& run)
    : run_(run), n_(run.system().velocities()), acted_(action_on(run.system())), group_(matrix_cotangent_so3()) {
    if (acted_) J_O_ = run.mass(run.states[0].q);
}

/// In space axes: R, and R m as a translation.
MatX DenseStates::matrix(const RecordedState& y) const { return group_.matrix(joined(y.q, J_O_ * Vec3(y.v)).data()); }

VecX DenseStates::increment(const RecordedState& y, const RecordedState& next) const {
    if (!acted_) return joined(run_.bodies.increment(y.q, next.q), next.v - y.v);
    return group_.vee(dense_log(MatX(matrix(y).partialPivLu().solve(matrix(next)))));
}

VecX DenseStates::pulled_back(const VecX& u, const VecX& z) const {
    if (acted_) return dense_dexpinv_left(group_, u, z);
    return joined(run_.bodies.pulled_back(u.head(n_), z.head(n_)), z.tail(n_));
}

RecordedState DenseStates::moved(const RecordedState& y, const VecX& u, const Real& t) const {
    if (!acted_) return {.t = t, .q = run_.bodies.moved(y.q, u.head(n_)), .v = y.v + u.tail(n_), .lambda = {}};
    const MatX g = matrix(y) * dense_exp(group_.hat(u));
    const Mat3 R = g.topLeftCorner(3, 3);
    const Vec3 momentum = R.transpose() * Vec3(g.topRightCorner(3, 1));
    return {.t = t, .q = Eigen::Map<const VecX>(R.data(), 9), .v = J_O_.inverse() * momentum, .lambda = {}};
}

VecX DenseStates::slope(const RecordedState& y) const {
    return acted_ ? slope_on_cotangent(y) : joined(y.v, run_.index1_rate(y));
}

VecX DenseStates::slope_on_cotangent(const RecordedState& y) const {
    VecX torque(3);
    run_.system().applied_force(y.t, y.q.data(), y.v.data(), torque.data());
    return joined(y.v, torque);
}

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
