// SPDX-License-Identifier: BSD-3-Clause
//
// Steps of a running method on a mechanical system, and the residuals of its published equations: increments by dense
// logarithms body by body, v' from mass matrix, forces and multipliers. Only the steps come from methods/.
#pragma once

#include <string>
#include <vector>

#include "methods/contract/integrator.hpp"
#include "tests/judges/steps/dense.hpp"
#include "tests/judges/steps/scheme_checks.hpp"
#include "tests/methods/stepping.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

/// The group of one body. Throws std::out_of_range for an unknown formulation.
MatrixGroup matrix_group(const std::string& formulation);

/// Block by block of the dimension of the group, block(u) of each part of u.
template <class F>
MatX block_diagonal(const MatrixGroup& group, const VecX& u, F block) {
    const Eigen::Index size = group.group->dim();
    MatX all = MatX::Zero(u.size(), u.size());
    for (Eigen::Index i = 0; i < u.size(); i += size) all.block(i, i, size, size) = block(VecX(u.segment(i, size)));
    return all;
}

/// The configurations of a formulation, each body as a matrix.
class DenseBodies {
  public:
    enum class Side { right, left };
    explicit DenseBodies(const std::string& formulation);

    /// u with next = q exp(u); from the left: next = exp(u) q. NaN if entries lie outside the algebra.
    VecX increment(const VecX& q, const VecX& next, Side side = Side::right) const;
    /// The left-trivialised dexp^{-1}_{-u}(v).
    VecX pulled_back(const VecX& u, const VecX& v) const;
    /// q exp(u), as stored.
    VecX moved(const VecX& q, const VecX& u) const;
    VecX bracket(const VecX& u, const VecX& v) const;  ///< [u, v]

  private:
    MatrixGroup body_;
    Eigen::Index size_, dim_;
};

/// A state and the time and multipliers that belong to it; before the first step there are none.
struct RecordedState {
    Real t;
    VecX q, v, lambda;
};

/// A system, the state in which its model starts at t = 1/3, and the states of a method after steps of h.
class RecordedRun {
  public:
    /// Throws std::domain_error if a step fails.
    RecordedRun(const Method& method, const OptionValues& options, const Model& model, const std::string& formulation,
                const Real& h, int steps);

    const DenseBodies bodies;
    const Real h;
    std::vector<RecordedState> states;  ///< one more than steps

    System& system() { return *system_; }
    /// v' of the index-1 form.
    VecX index1_rate(const RecordedState& state);
    /// Its multipliers.
    VecX index1_multipliers(const RecordedState& state);
    /// v' from M v' = Q - C^T lambda with the multipliers of the state.
    VecX rate(const RecordedState& state);
    /// M, dense.
    MatX mass(const VecX& q);
    /// The rows of C that belong to Phi.
    MatX position_rows(const RecordedState& state);
    VecX position_defect(const RecordedState& state);
    VecX velocity_defect(const RecordedState& state);
    /// rates <- M^{-1} rates, columns alike.
    void solve_mass(const VecX& q, MatX& rates);

  private:
    std::unique_ptr<System> system_;
};

/// One step by -h of a method that is checked against its own scheme.
RecordedState state_before(RecordedRun& run, const RecordedState& state, const std::string& method_name = "rkmk/rk4");

/// The most violated equation.
class Violations {
  public:
    void see(const std::string& equation, const VecX& residual);
    /// The objection to a method with these residuals; empty below the tolerance.
    Objection objection(const Real& tolerance) const;

  private:
    std::string worst_;
    Real largest_ = 0;
};

/// x with S x = r.
VecX solved_square(const MatX& S, const VecX& r);
/// The part of r outside the range of T.
VecX outside_range(const MatX& T, const VecX& r);

/// Round-off of a step whose equations are divided by h, with numbers of order 100.
inline Real equations_tolerance() { return KREISEL_QUAD ? from_text("1e-28") : from_text("1e-12"); }

/// Long, so that C(q) and C(q+) differ and eta is not small.
inline Real long_step() { return Real(1) / 32; }

/// judge(run) on one body with and without a constraint and on two with joints, in all their formulations.
template <class F>
Objection on_models_with_and_without_joints(const Method& method, const OptionValues& options, int steps, F judge) {
    for (const char* name : {"forced_heavy_top", "forced_free_body", "double_pendulum"})
        for (const std::string& formulation : models::applicable(models::standard(name))) {
            if (!stepping::runs_on(method, models::standard(name), formulation)) continue;
            RecordedRun run(method, options, models::standard(name), formulation, long_step(), steps);
            const Objection objection = judge(run).objection(equations_tolerance());
            if (!objection.empty()) return objection + " on " + name + " as " + formulation;
        }
    return "";
}

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
