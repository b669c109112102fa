// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "engine/engine.hpp"
#include "engine/step_times.hpp"
#include "methods/simulation.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

/// The steps of a run: so many of one size, or those that the method chooses to a tolerance.
class Pace {
  public:
    /// Refers to both; from the time of the simulation.
    Pace(const Cell& cell, Simulation& simulation)
        : cell_(cell), simulation_(simulation), t_begin_(simulation.time()), t_end_(decimal(cell.t_end)) {
        if (cell.steps > 0) times_ = StepTimes(simulation.time(), t_end_, cell.steps);
    }

    bool to_tolerance() const { return cell_.tolerance > 0; }
    const Real& t_end() const { return t_end_; }
    long steps_done() const { return done_; }
    bool arrived() const { return to_tolerance() ? simulation_.time() == t_end_ : done_ == cell_.steps; }
    /// The share of the run that is done: of its steps, or of its time where their sizes are chosen.
    double share() const {
        return to_tolerance() ? to_double((simulation_.time() - t_begin_) / (t_end_ - t_begin_))
                              : static_cast<double>(done_) / static_cast<double>(cell_.steps);
    }

    /// From the state of the simulation at its time, which is that of the start.
    Status begin() {
        done_ = 0;
        return to_tolerance() ? simulation_.restart_to(t_end_) : simulation_.restart();
    }
    /// The next step, not beyond `limit` if its size is chosen.
    Status step(const Real& limit) {
        const Status status =
            to_tolerance() ? simulation_.stride(limit) : simulation_.step(times_.h(), time(done_ + 1));
        if (status == Status::ok) ++done_;
        return status;
    }

    /// After so many steps: of one size any, else the last.
    Real time(long step) const { return to_tolerance() ? simulation_.time() : times_.at(step); }

  private:
    const Cell& cell_;
    Simulation& simulation_;
    Real t_begin_, t_end_;
    StepTimes times_;
    long done_ = 0;
};

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
