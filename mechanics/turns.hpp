// SPDX-License-Identifier: BSD-3-Clause
//
// Full turns of torsion springs. Poses determine angles up to full turns; the configuration group of a model with
// torsion springs is therefore a covering (lie/covering.hpp) with a label for each spring: its angle at the last
// accepted step. The angle at a pose is the representative nearest to what is expected there,
//   outside a step   the label,
//   in a step        theta_n + (t - t_n) theta'_n, from the start of the step,
// and has no jump where it passes pi. Labels need not be exact. The count is lost, and the status is turn_lost, if a
// step cannot resolve the turning: |h theta'| >= pi, or an angle farther than pi/2 from what is expected in a step; or
// if the axes of a spring have parted so far that the angle winds about a pose where it is undefined (Turn::shadow
// below 1/2).
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "lie/covering.hpp"
#include "lie/status.hpp"
#include "mechanics/model/model.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

/// An angle (rad) with all its turns, and their number: theta less 2 pi turns lies in (-pi, pi].
struct SpringAngle {
    Real theta = 0;
    long turns = 0;
};

/// The representative of `angle` in (near - pi, near + pi].
Real nearest_turn(const Real& angle, const Real& near);

/// The configuration group of a model whose poses form the group `poses`.
std::shared_ptr<const Group> configurations(std::shared_ptr<const Group> poses, const Model& model);

/// Part of a system; refers to its model. `labels` are those of a configuration, motion(body) is the Motion of a body
/// or of the ground.
class Turns {
  public:
    explicit Turns(const Model& model) : model_(model), steps_(model.torsion_springs.size()) {}

    /// theta of a spring at time t. One evaluation asks for all springs, in their order; its fault remains until
    /// the next one.
    Real angle(std::size_t spring, const Turn& turn, const Real& t, const Real* labels) const {
        if (spring == 0) fault_ = {};
        const Real expected = stepping_ ? Real(steps_[spring].theta + (t - t_) * steps_[spring].rate) : labels[spring];
        const Real theta = nearest_turn(turn.principal, expected);
        if (fault_.kind == Fault::none) judge(spring, turn, theta - expected);
        return theta;
    }
    /// turn_lost if the last evaluation has lost a turn. An angle that is not finite is not a fault here.
    Status status() const { return fault_.kind == Fault::none ? Status::ok : Status::turn_lost; }
    /// The fault of the last evaluation in words.
    std::string reason() const;

    template <class MotionOf>
    Status begin_step(const Real& t, const Real& h, const Real* labels, MotionOf motion) {
        stepping_ = false;
        each(motion, [&](std::size_t i, const Turn& turn) { steps_[i] = {angle(i, turn, t, labels), turn.rate, 0}; });
        t_ = t, h_ = h, stepping_ = true;
        each(motion, [&](std::size_t i, const Turn& turn) { angle(i, turn, t, labels); });
        return status();
    }

    /// The status of a step to time t, given that of the method; if it is ok, the labels become the angles there.
    template <class MotionOf>
    Status end_step(Status result, const Real& t, Real* labels, MotionOf motion) {
        if (result == Status::ok) result = status();
        if (result == Status::ok) {
            each(motion, [&](std::size_t i, const Turn& turn) { steps_[i].end = angle(i, turn, t, labels); });
            result = status();
        }
        stepping_ = false;
        if (result != Status::ok) return result;
        for (const Step& step : steps_) *labels++ = step.end;
        return result;
    }

    /// The angle of a spring outside a step.
    template <class MotionOf>
    SpringAngle read(std::size_t i, const Real* labels, MotionOf motion) const {
        return counted(turn_of(i, motion).principal, labels[i]);
    }

  private:
    struct Step {
        Real theta = 0, rate = 0;  // at its start
        Real end = 0;
    };
    struct Fault {
        enum Kind { none, parted, fast, far } kind = none;
        std::size_t spring = 0;
        Real size = 0;
    };
    void judge(std::size_t spring, const Turn& turn, const Real& distance) const;
    static SpringAngle counted(const Real& principal, const Real& near);

    template <class MotionOf>
    Turn turn_of(std::size_t i, MotionOf motion) const {
        const TorsionSpring& spring = model_.torsion_springs[i];
        return turn(spring, motion(spring.first), motion(spring.second));
    }
    template <class MotionOf, class F>
    void each(MotionOf motion, F f) const {
        for (std::size_t i = 0; i < steps_.size(); ++i) f(i, turn_of(i, motion));
    }

    const Model& model_;
    std::vector<Step> steps_;
    bool stepping_ = false;
    Real t_ = 0, h_ = 0;
    mutable Fault fault_;  // of the last evaluation: set by const functions
};

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
