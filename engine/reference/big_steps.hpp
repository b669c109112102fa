// SPDX-License-Identifier: BSD-3-Clause
//
// The first route to a reference: big steps of extrapolation (gbs.hpp) on quaternion coordinates (quaternion_form.hpp).
#pragma once

#include <array>
#include <vector>

#include "engine/reference/gbs.hpp"
#include "engine/reference/quaternion_form.hpp"
#include "support/watch.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

#if KREISEL_QUAD
inline constexpr int reference_columns = 11;
#else
inline constexpr int reference_columns = 8;
#endif

/// Norms of x, quaternions, v and omega, each over all bodies.
using PartSizes = std::array<Real, 4>;
PartSizes part_sizes(const Real* w, int bodies);
/// Largest a_p / b_p; a part that is always zero is ignored.
Real largest_ratio(const PartSizes& a, const PartSizes& b);

/// Times and states of the big steps of one run, the start included, up to where it stopped.
struct BigStepRun {
    std::vector<Real> times;
    std::vector<std::vector<Real>> states;
    PartSizes sizes{};  ///< largest of all steps
    Status status = Status::ok;
    bool interrupted = false;
};

/// Integrates one model; not copied, since the extrapolation refers to its form.
class BigSteps {
  public:
    /// From the start of the model at time t_begin.
    BigSteps(const Model& model, const Real& t_begin)
        : form(model),
          t_begin_(t_begin),
          gbs_(even_sequence(reference_columns), form.dimension(),
               [this](const Real& t, const Real* w, Real* rate) { return form.rate(t, w, rate); }) {}
    BigSteps(const BigSteps&) = delete;
    BigSteps& operator=(const BigSteps&) = delete;

    /// Big steps as large as the tolerance allows, from the guess H.
    BigStepRun adaptive(const Real& t_end, Real H, const Watch& watch);
    /// Every big step of another run in two halves.
    BigStepRun halved(const BigStepRun& coarse, const Watch& watch);
    /// The state of a run at a time within it, by a shorter step from the last big one before.
    Status state_at(const BigStepRun& run, const Real& t, std::vector<Real>& w);

    QuaternionForm form;

  private:
    /// H is a guess of the big steps.
    BigStepRun begin(const Real& H);
    /// Appends the step to time t. On failure, or if its local error exceeds `allowed`, the run is as before.
    bool append(BigStepRun& run, const Real& t, const Real& allowed);

    Real t_begin_;
    Extrapolation gbs_;
    Real local_error_ = 0;  // of the last step, relative to the sizes
};

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
