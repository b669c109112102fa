// SPDX-License-Identifier: BSD-3-Clause
#include "methods/splitting/free_flow.hpp"

#include <Eigen/LU>

#include "lie/so3.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

FreeFlow::FreeFlow(const System& system)
    : group_(system.group()), inertias_(system), u_(static_cast<std::size_t>(system.velocities())) {
    bodies_.reserve(static_cast<std::size_t>(inertias_.bodies()));
}

void FreeFlow::weigh(const Real* q) {
    if (!inertias_.weigh(q)) return;
    bodies_.clear();
    for (int i = 0; i < inertias_.bodies(); ++i) {
        const Mat3 J = inertias_.of(i);
        bodies_.push_back({FreeRotor(J), J, J.inverse()});
    }
}

/// omega+ = omega + J^{-1} (exp(-w) - 1) J omega, w the rotation: the closed form of omega+ would multiply the momentum
/// by 1 + O(eps) of the same sign at every step, since axes are orthogonal and J J^{-1} is 1 to round-off only.
void FreeFlow::advance(const Real& t, Real* q, Real* v) {
    Real* u = u_.data();
    for (const auto& [rotor, J, J_inverse] : bodies_) {
        if (inertias_.in_space()) {
            store(Vec3(t * vec3(v)), u);
            u += 3, v += 3;
        }
        const Vec3 omega = vec3(v), m = J * omega, w = SO3::log(rotor.after(Mat3::Identity(), omega, t).R);
        const Vec3 wm = w.cross(m);
        const Real s = w.squaredNorm();
        store(Vec3(omega + J_inverse * (cosc(s) * w.cross(wm) - sinc(s) * wm)), v);
        store(w, u);
        u += 3, v += 3;
    }
    group_.append_exp(q, u_.data(), q);
}

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
