// SPDX-License-Identifier: BSD-3-Clause
//
// What integrators of other libraries are given: the equations of motion on quaternions, one for each body, in unknowns
// u = w / s that are of size one, so that one absolute tolerance serves all of them, whatever the library makes of
// tolerances. The scales s are 1 for quaternions, the length of the mechanism for positions, and these times the rate
// of the motion at the start for velocities; powers of two, so that scaling loses no bit.
#pragma once

#include <vector>

#include "methods/baseline/global_equations.hpp"
#include "methods/control/error_norm.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

class PeerEquations {
  public:
    /// The system outlives this.
    PeerEquations(System& system, const Accuracy& accuracy);

    std::size_t size() const { return w_.size(); }  ///< reals of u
    const Real& rate() const { return rate_; }      ///< of the motion at the start, 1/s; 0 of a body at rest
    const std::vector<Real>& scales() const { return scale_; }  ///< s
    const Real& length() const { return length_; }              ///< of positions, m
    const Real& unit_rate() const { return unit_; }             ///< of velocities, 1/s

    /// y at t -> u, where a run begins. `span` (s) is what it takes, which gives the scale of velocities at rest.
    Status start(const Real& t, const Real& span, const Real* y, Real* u);
    /// The same later on: scales stay.
    void read(const Real* y, Real* u);
    /// The labels of torsion springs where the unknowns were read last, into y.
    void write_labels(Real* y) const { equations_.write_labels(y); }
    /// u -> y; the labels of y stay as they are.
    void write(const Real* u, Real* y);

    /// u'. Where it cannot be had it is NaN, and the first status since `forget` is kept: libraries know no status, and
    /// some take NaN for a success.
    bool derivative(const Real& t, const Real* u, Real* du);
    /// u' for a slope z = (v, v') of TG.
    void rates(const Real* u, const Real* z, Real* du);
    void fail(Status status) {
        if (status_ == Status::ok) status_ = status;
    }
    void forget() { status_ = Status::ok; }
    /// The status kept, or `otherwise` where nothing has failed.
    Status status(Status otherwise = Status::ok) const { return status_ == Status::ok ? otherwise : status_; }

  private:
    void choose_scales(const Real& rate);

    System& system_;
    Real length_;
    ErrorNorm norm_;
    GlobalEquations equations_;
    std::vector<Real> w_, scale_, inverse_, slope_;
    Real rate_ = 0, unit_ = 1;
    Status status_ = Status::ok;
};

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
