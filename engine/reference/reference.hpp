// SPDX-License-Identifier: BSD-3-Clause
//
// Reference solutions: extrapolation of high order on quaternion coordinates. Methods under test share the family
// (methods/extrapolation, with code of its own), the model, its System and (in S3xR3 and the quaternion baseline) the
// coordinates; the second route shares none of them (taylor/taylor_route.hpp).
#pragma once

#include <string>
#include <vector>

#include "engine/report/joint_forces.hpp"
#include "engine/report/report.hpp"
#include "mechanics/model/model.hpp"
#include "mechanics/turns.hpp"
#include "support/watch.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

/// Norms over all bodies of x, v and omega.
struct MotionSize {
    Real position = 0, velocity = 0, omega = 0;
};

struct ReferencePoint {
    Real t = 0;
    std::vector<BodyState> states;
};

/// A solution on the way and what is known of its error, in the sense of ReferenceSolution; unknown errors are NaN.
struct SampledPoint {
    ReferencePoint point;
    std::vector<Real> multipliers;
    Distance error;
    MultiplierDistance multiplier_error;
};

/// The state at t_end and what is known of its error. Errors are the differences between big steps H and H/2, each in
/// the unit and norm of its metric (Euclidean over all bodies, rotation by the norm of the logarithm: m, rad, m/s,
/// rad/s; multipliers in N and N m over their rows); position and velocity at least the constraint residuals |Phi|,
/// |C v + b|. Past the horizon they are the largest differences since: two solutions that have both diverged may meet
/// again. If the equations of motion fail on the way (a singular configuration, NaN), `stopped` names the status and
/// there are no states and no multipliers.
struct ReferenceSolution {
    std::vector<BodyState> states;
    std::vector<SpringAngle> angles;  ///< of the torsion springs
    std::vector<Real>
        multipliers;  ///< rows in space axes, joints in the order of the model; none if rows are redundant
    Real position_error = 0, rotation_error = 0, velocity_error = 0, omega_error = 0;
    MultiplierDistance multiplier_error;
    Real horizon = 0;      ///< s; last big step up to which both runs agree to 1e-12 of each quantity's largest size
    bool compared = true;  ///< false: a second route did not reach t_end, so the errors are unknown
    /// The largest ones of the finer run, at least the effect of the forces on free bodies within a thousandth of a big
    /// step: a body held at rest moves only by round-off.
    MotionSize sizes;
    std::vector<ReferencePoint> path;    ///< the big steps up to the horizon, the start included
    std::vector<ReferencePoint> beyond;  ///< those after it
    std::vector<SampledPoint> samples;   ///< those asked for, at t_0 + (t_end - t_0) k / K, k = 1 ... K
    std::string route;                   ///< how it was computed
    std::string stopped;                 ///< empty, or the name of the Status that ended the integration
    bool interrupted = false;            ///< it was asked to stop; all else is empty
};

/// Integrates from the start of a model at t_begin to t_end (s), which may be less: once with big steps chosen by their
/// local error, and once with each of these halved; samples by a shorter step of each run. The watch is asked and told
/// before each big step and each sample. Throws std::invalid_argument if t_end is not finite.
ReferenceSolution reference_solution(const Model& model, const Real& t_end, const Watch& watch = {}, long samples = 0,
                                     const Real& t_begin = 0);

/// Makes the errors of a reference at least as large as its distance from another solution.
void allow_for(ReferenceSolution& reference, const Distance& distance);

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
