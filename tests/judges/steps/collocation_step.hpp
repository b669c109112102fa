// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "tests/judges/steps/dense_states.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

enum class CollocationPoints { gauss, radau, lobatto };

/// A tableau of implicit stages; modified if a control requires it.
struct CollocationForm {
    CollocationPoints points;
    int stages;                            ///< 2 or 3, of Lobatto points to 4
    bool around_middle;                    ///< coordinates around the middle of the step, else around q
    bool velocities_by_companion = false;  ///< IIIB beside IIIA
};
inline constexpr CollocationForm gauss_form(int stages) { return {CollocationPoints::gauss, stages, true}; }
inline constexpr CollocationForm radau_form(int stages) { return {CollocationPoints::radau, stages, false}; }
inline constexpr CollocationForm lobatto_form(int stages) { return {CollocationPoints::lobatto, stages, true, true}; }

struct CollocationRows {
    VecX c, b;
    MatX a, a_hat;  ///< row i: a_i1, a_i2, ...; a_hat: of velocities
};

/// The stages of a step in the chart around its start or its middle, iterated with dense matrices.
class DenseCollocation {
  public:
    /// `run` outlives this.
    DenseCollocation(RecordedRun& run, const CollocationForm& form);
    /// The iteration, from where it was; the start may have moved since.
    void sweep(const RecordedState& start, int times);
    /// u of the end of the step, y exp(u).
    VecX increment() const;

  private:
    DenseStates states_;
    Real h_;
    CollocationRows rows_;
    bool around_middle_;
    MatX slopes_;  // (k_i, f_i) as columns
};

/// A step of methods/rkmk/implicit_rkmk.hpp with these coefficients.
Objection collocation_step_objection(const Method& method, const CollocationForm& form);

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
