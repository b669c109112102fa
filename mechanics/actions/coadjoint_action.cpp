// SPDX-License-Identifier: BSD-3-Clause
#include "mechanics/actions/coadjoint_action.hpp"

#include <algorithm>

namespace kreisel {
inline namespace KREISEL_PRECISION {

namespace {

constexpr int momentum_at = SO3::size, torque_at = SO3::dim;  // where they begin

/// Reals whose last three are changed by a matrix: (R, omega) to (R, m) by J_O, and (u, J_O^{-1} n) to (u, n).
template <int size>
struct Changed {
    Changed(const Real* from, const Mat3& matrix) {
        std::copy_n(from, size - 3, numbers);
        store(Vec3(matrix * vec3(from + size - 3)), numbers + size - 3);
    }
    operator const Real*() const { return numbers; }  // NOLINT: stands for the array
    Real numbers[static_cast<std::size_t>(size)];
};
using State = Changed<CotangentSO3::size>;
using Slope = Changed<CotangentSO3::dim>;

void change(Real* last, const Mat3& matrix) { store(Vec3(matrix * vec3(last)), last); }

/// J_O^{-1} m, refined once: the round-off of the inverse, the same at every step, would add up.
Vec3 solved(const Vec3& m, const Mat3& J, const Mat3& J_inverse) {
    const Vec3 omega = J_inverse * m;
    return omega + J_inverse * (m - J * omega);
}

/// (R, omega) of (R, m).
void to_velocity(Real* y, const Mat3& J, const Mat3& J_inverse) {
    store(solved(vec3(y + momentum_at), J, J_inverse), y + momentum_at);
}

/// (R, omega) of the (R, m) that has come of `before`, by the change of m: what goes from omega to m and back is
/// rounded to the same side for thousands of steps, and |m| would leave its orbit by a tenth of eps in each.
void to_velocity(const Vec3& omega, const State& before, Real* y, const Mat3& J, const Mat3& J_inverse) {
    const Vec3 change = vec3(y + momentum_at) - vec3(before + momentum_at);
    store(Vec3(omega + solved(change, J, J_inverse)), y + momentum_at);
}

}  // namespace

CoadjointAction::CoadjointAction(const Mat3& J_O, const Mat3& J_O_inverse)
    : StateAction(CotangentSO3::dim, CotangentSO3::size), group_(1), J_(J_O), J_inverse_(J_O_inverse) {}

void CoadjointAction::from_tangent(const Real* y, Real* z) const {
    const Vec3 m = J_ * vec3(y + momentum_at);
    store(Vec3(vec3(z + torque_at) - J_inverse_ * m.cross(vec3(z))), z + torque_at);
}
void CoadjointAction::to_tangent(const Real* y, Real* z) const {
    const Vec3 m = J_ * vec3(y + momentum_at);
    store(Vec3(vec3(z + torque_at) + J_inverse_ * m.cross(vec3(z))), z + torque_at);
}

void CoadjointAction::identity(Real* y) const { group_.identity(y); }
void CoadjointAction::multiply(const Real* a, const Real* b, Real* out) const {
    group_.multiply(State(a, J_), State(b, J_), out);
    to_velocity(out, J_, J_inverse_);
}
void CoadjointAction::inverse(const Real* a, Real* out) const {
    group_.inverse(State(a, J_), out);
    to_velocity(out, J_, J_inverse_);
}
void CoadjointAction::log(const Real* y, Real* z) const {
    group_.log(State(y, J_), z);
    change(z + torque_at, J_inverse_);
}
void CoadjointAction::bracket(const Real* u, const Real* z, Real* out) const {
    group_.bracket(Slope(u, J_), Slope(z, J_), out);
    change(out + torque_at, J_inverse_);
}
void CoadjointAction::Ad(const Real* y, const Real* z, Real* out) const {
    group_.Ad(State(y, J_), Slope(z, J_), out);
    change(out + torque_at, J_inverse_);
}
void CoadjointAction::dexp(const Real* u, const Real* z, Real* out) const {
    group_.dexp(Slope(u, J_), Slope(z, J_), out);
    change(out + torque_at, J_inverse_);
}
void CoadjointAction::append_exp(const Real* y, const Real* u, Real* out) const {
    const State before(y, J_);
    const Vec3 omega = vec3(y + momentum_at);  // out may be y
    group_.append_exp(before, Slope(u, J_), out);
    to_velocity(omega, before, out, J_, J_inverse_);
}
void CoadjointAction::append_cay(const Real* y, const Real* u, Real* out) const {
    const State before(y, J_);
    const Vec3 omega = vec3(y + momentum_at);  // out may be y
    group_.append_cay(before, Slope(u, J_), out);
    to_velocity(omega, before, out, J_, J_inverse_);
}
bool CoadjointAction::in_exp_chart(const Real* u) const { return group_.in_exp_chart(u); }
bool CoadjointAction::dexpinv_left(const Real* u, const Real* z, Real* out) const {
    const bool inside = group_.dexpinv_left(Slope(u, J_), Slope(z, J_), out);
    change(out + torque_at, J_inverse_);
    return inside;
}
void CoadjointAction::dcayinv_left(const Real* u, const Real* z, Real* out) const {
    group_.dcayinv_left(Slope(u, J_), Slope(z, J_), out);
    change(out + torque_at, J_inverse_);
}

/// Covectors change by the transposes, and J_O is its own: p . z = (p_1, J_O^{-1} p_2) . (u, n).
void CoadjointAction::coAd(const Real* y, const Real* p, Real* out) const {
    group_.coAd(State(y, J_), Slope(p, J_inverse_), out);
    change(out + torque_at, J_);
}
bool CoadjointAction::dexpinv_left_transpose(const Real* u, const Real* p, Real* out) const {
    const bool inside = group_.dexpinv_left_transpose(Slope(u, J_), Slope(p, J_inverse_), out);
    change(out + torque_at, J_);
    return inside;
}
void CoadjointAction::dcayinv_left_transpose(const Real* u, const Real* p, Real* out) const {
    group_.dcayinv_left_transpose(Slope(u, J_), Slope(p, J_inverse_), out);
    change(out + torque_at, J_);
}
Real CoadjointAction::orthogonality_defect(const Real* y) const { return group_.orthogonality_defect(y); }

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
