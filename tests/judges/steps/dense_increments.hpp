// SPDX-License-Identifier: BSD-3-Clause
//
// Increments of a step in local coordinates and the differentials of these, dense, for the equations of variational
// methods.
#pragma once

#include <Eigen/LU>

#include "tests/judges/steps/recorded_steps.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

/// The local coordinates u of an increment q+ = q tau(u) from its logarithm, and the transposed inverse differentials.
struct DenseIncrements {
    const MatrixGroup group;
    const bool cayley;

    VecX coordinates(const VecX& logarithm) const {
        if (!cayley) return logarithm;
        VecX u = logarithm;
        const Eigen::Index n = group.group->dim();
        for (Eigen::Index i = 0; i < u.size(); i += n) {
            const MatX g = dense_exp(group.hat(VecX(u.segment(i, n)))), I = MatX::Identity(g.rows(), g.cols());
            u.segment(i, n) = group.vee(MatX(2 * (g - I) * MatX(g + I).partialPivLu().inverse()));
        }
        return u;
    }
    /// (d tau^{-1}_{-u})^T, of the left-trivialised inverse at u.
    MatX transposed(const VecX& u) const {
        return block_diagonal(group, u,
                              [&](const VecX& part) {
                                  MatX columns(part.size(), part.size());
                                  for (Eigen::Index k = 0; k < part.size(); ++k) {
                                      const VecX e = VecX::Unit(part.size(), k);
                                      columns.col(k) = cayley ? dense_dcayinv_left(group, part, e)
                                                              : dense_dexpinv_left(group, part, e);
                                  }
                                  return columns;
                              })
            .transpose();
    }
};

inline VecX force_at_rest(RecordedRun& run, const RecordedState& state) {
    VecX f(state.v.size());
    run.system().applied_force(state.t, state.q.data(), VecX(VecX::Zero(state.v.size())).data(), f.data());
    return f;
}

/// judge(run, increments) in both coordinates on one body with and without a constraint, on others without and on two
/// bodies with joints, as far as the method takes them, over this many steps.
template <class F>
Objection on_increments(const Method& method, int steps, F judge) {
    for (const char* coordinates : {"exp", "cayley"})
        for (const char* name : {"forced_heavy_top", "forced_free_body", "double_pendulum"})
            for (const std::string& formulation : models::applicable(models::standard(name))) {
                if (!stepping::runs_on(method, models::standard(name), formulation)) continue;
                const OptionValues options = {{"coordinates", std::string(coordinates)}};
                RecordedRun run(method, options, models::standard(name), formulation, Real(1) / 32, steps);
                const DenseIncrements dense{matrix_group(formulation), std::string(coordinates) == "cayley"};
                const Objection objection = judge(run, dense).objection(equations_tolerance());
                if (!objection.empty()) return objection + " on " + name + " as " + formulation + ", " + coordinates;
            }
    return "";
}

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
