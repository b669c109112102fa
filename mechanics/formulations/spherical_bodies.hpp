// SPDX-License-Identifier: BSD-3-Clause
//
// Bodies that hang by spherical joints, from the ground or from each other, without loops: the kinematics are those of
// ConstrainedBodies, the solve is a recursion from the tips (articulated bodies [featherstone2008, Ch. 7], with a point
// in place of a body at each joint). In each body d leads from the joint to its parent to the mass centre, s_c to the
// joint with child c, and J is the inertia about the joint to the parent, all in body axes. Child c resists the
// acceleration a_c of its joint with the force M_c a_c + f_c. With X = R hat(d)^T, Z_c = R hat(s_c)^T,
// c_r = R (omega x (omega x r)), force F (space axes) and torque tau (body axes) from outside,
//   x'' = a + X omega' + c_d,   a_c = a + Z_c omega' + c_s,   D omega' = -B^T a - h,
//   D = J + sum Z_c^T M_c Z_c,   B = m X + sum M_c Z_c,
//   h = omega x J omega - tau - X^T F + sum Z_c^T (M_c c_s + f_c),
// and seen from the joint to the parent
//   M = m I + sum M_c - B D^{-1} B^T,   f = m c_d - F + sum (M_c c_s + f_c) - B D^{-1} h.
// M and f are in space axes, X and Z map from body to space: no vector is rotated from one body to the next. D is
// positive definite, so there is no singular position. A body without a parent is taken at its mass centre, where
// M a + f = 0. Where every body hangs on the ground by at most one joint and carries no load, D is constant, and the
// bodies are AnchoredBodies.
#pragma once

#include <algorithm>
#include <optional>

#include "mechanics/formulations/anchored_bodies.hpp"
#include "mechanics/formulations/articulated_solve.hpp"
#include "mechanics/formulations/constrained_bodies.hpp"
#include "mechanics/solve/forest.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

template <class Coordinates>
class SphericalBodies final : public ConstrainedBodies<Coordinates> {
  public:
    /// Whether a model has only spherical joints and no loops.
    static bool fits(const Model& model) { return all_spherical(model) && is_forest(model); }
    explicit SphericalBodies(Model model);

    /// Bodies apart are solved in this function itself, without a further call.
    KREISEL_HOT Status accelerations(const Real& t, const Real* q, const Real* v, Real* dv, Real* lambda) override {
        if (anchored_ && !lambda) return anchored_->accelerations(this->model().gravity, t, q, v, dv);
        return forest_accelerations(t, q, v, dv, lambda);
    }
    Status solve_kkt(const Real&, const Real* q, const Real* f, const Real* c, Real* a, Real* lambda) override {
        if (anchored_) return anchored_->solve(q, f, c, a, lambda);
        solve_.prepare(q);
        return solve_.solve(q, f, c, a, lambda);
    }
    Status prepare_kkt(const Real&, const Real* q) override {
        if (!anchored_) solve_.prepare(q);  // else nothing depends on the configuration
        return Status::ok;
    }
    Status solve_prepared(const Real&, const Real* q, const Real* f, const Real* c, Real* a, Real* lambda) override {
        return anchored_ ? anchored_->solve(q, f, c, a, lambda) : solve_.solve(q, f, c, a, lambda);
    }

  private:
    using Base = ConstrainedBodies<Coordinates>;
    using Layout = BodyLayout<Coordinates>;

    [[gnu::noinline]] Status forest_accelerations(const Real& t, const Real* q, const Real* v, Real* dv, Real* lambda);
    /// What loads and springs exert on each body, into wrenches_.
    void gather_wrenches(const Real& t, const Real* q, const Real* v);

    ArticulatedAccelerations<Coordinates> accelerations_;
    ArticulatedSolve<Coordinates> solve_;
    std::optional<AnchoredBodies<Coordinates>> anchored_;  // where they are such
    std::vector<Wrench> wrenches_;                         // by body: force in space axes, torque in body axes
    bool forces_;                                          // whether anything but gravity acts
};

template <class Coordinates>
SphericalBodies<Coordinates>::SphericalBodies(Model data)
    : Base(std::move(data)),
      accelerations_(this->model()),
      solve_(accelerations_.bodies()),
      wrenches_(this->model().bodies.size()),
      forces_(has_forces(this->model())) {
    const auto& bodies = accelerations_.bodies();
    const bool apart = std::all_of(bodies.begin(), bodies.end(), [](const TreeNode& node) { return node.rooted; });
    if (apart && !forces_ && !bodies.empty()) anchored_.emplace(this->model());
}

template <class Coordinates>
void SphericalBodies<Coordinates>::gather_wrenches(const Real& t, const Real* q, const Real* v) {
    std::fill(wrenches_.begin(), wrenches_.end(), Wrench());
    this->each_wrench(t, q, v, [&](int body, const Wrench& wrench) {
        wrenches_[static_cast<std::size_t>(body)].force += Layout::rotation(q, body) * wrench.force;
        wrenches_[static_cast<std::size_t>(body)].torque += wrench.torque;
    });
}

template <class Coordinates>
KREISEL_HOT Status SphericalBodies<Coordinates>::forest_accelerations(const Real& t, const Real* q, const Real* v,
                                                                      Real* dv, Real* lambda) {
    const Vec3 g = this->model().gravity.at(t);
    const bool forces = forces_;
    if (forces) gather_wrenches(t, q, v);
    const auto act = [&](const ArticulatedBody& body) {
        Action action{Layout::angular(v, body.body), body.mass * g, Vec3::Zero()};
        if (forces) {
            const Wrench& wrench = wrenches_[static_cast<std::size_t>(body.body)];
            action.force += wrench.force, action.torque = wrench.torque;
        }
        return action;
    };
    Real sum = 0;
    accelerations_.evaluate(q, act, [&](const ArticulatedBody& body, const auto& R, const Vec3& x, const Vec3& dw) {
        const Vec3 w = Layout::angular(v, body.body);
        const Vec3 a = Coordinates::rate(Coordinates::from_space(R, x), w, Layout::linear(v, body.body));
        sum += a.sum() + dw.sum();
        store(a, dv + 6 * body.body), store(dw, dv + 6 * body.body + 3);
    });
    if (lambda) accelerations_.multipliers(lambda);
    return isfinite(sum) ? this->turns().status() : Status::non_finite;
}

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
