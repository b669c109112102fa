// SPDX-License-Identifier: BSD-3-Clause
//
// Failure is a value: a step, a solve or a projection returns a Status, and the caller records when and where.
#pragma once

namespace kreisel {

enum class Status {
    ok,
    non_finite,         ///< NaN or infinity in a state, a force, the mass matrix or a constraint
    left_chart,         ///< a stage rotated out of the domain of its coordinates
    chart_singularity,  ///< global coordinates are singular here (Euler angles)
    singular_kkt,       ///< the constraint Jacobian has lost rank
    projection_failed,  ///< the projection onto the constraints did not converge
    newton_failed,      ///< the Newton iteration of an implicit step did not converge
    step_too_small,     ///< a step chosen to a tolerance has become too small to move time
    turn_lost,          ///< the turn count of a torsion spring is lost: the step is too long, or its axes have parted
};

constexpr const char* name(Status status) {
    switch (status) {
        case Status::ok:
            return "ok";
        case Status::non_finite:
            return "non_finite";
        case Status::left_chart:
            return "left_chart";
        case Status::chart_singularity:
            return "chart_singularity";
        case Status::singular_kkt:
            return "singular_kkt";
        case Status::projection_failed:
            return "projection_failed";
        case Status::newton_failed:
            return "newton_failed";
        case Status::step_too_small:
            return "step_too_small";
        case Status::turn_lost:
            return "turn_lost";
    }
    return "unknown";
}

}  // namespace kreisel
