// SPDX-License-Identifier: BSD-3-Clause
#include "methods/baseline/global_equations.hpp"

#include <algorithm>

#include "mechanics/system.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

GlobalEquations::GlobalEquations(System& system, std::shared_ptr<const RotationCoordinates> coordinates)
    : system_(system),
      coordinates_(std::move(coordinates)),
      bodies_(system.bodies()),
      translations_(system.group().dim() == 6 * bodies_ ? 3 : 0),
      size_(static_cast<std::size_t>(bodies_ * stride() + system.velocities())),
      y_(static_cast<std::size_t>(system.state_group().size())),
      z_(static_cast<std::size_t>(system.state_group().dim())) {}

void GlobalEquations::read(const Real* y, Real* w) {
    std::copy(y, y + y_.size(), y_.begin());
    const Real* v = system_.v(y);
    for (int i = 0; i < bodies_; ++i, y += translations_ + 9, w += stride()) {
        std::copy_n(y, translations_, w);
        coordinates_->from_matrix(y + translations_, w + translations_);
    }
    std::copy_n(v, system_.velocities(), w);
}

void GlobalEquations::write_labels(Real* y) const {
    std::copy_n(system_.labels(y_.data()), system_.torsion_springs(), system_.labels(y));
}

void GlobalEquations::write(const Real* w, Real* y) const {
    Real* v = system_.v(y);
    for (int i = 0; i < bodies_; ++i, y += translations_ + 9, w += stride()) {
        std::copy_n(w, translations_, y);
        coordinates_->to_matrix(w + translations_, y + translations_);
    }
    std::copy_n(w, system_.velocities(), v);
}

Status GlobalEquations::derivative(const Real& t, const Real* w, const Real& h, Real* dw) {
    write(w, y_.data());
    const Status status = system_.vector_field(t, y_.data(), z_.data());
    const bool regular = rates(w, z_.data(), h, dw);
    return regular || status != Status::ok ? status : Status::chart_singularity;
}

bool GlobalEquations::rates(const Real* w, const Real* z, const Real& h, Real* dw) const {
    bool regular = true;
    for (int i = 0; i < bodies_; ++i, w += stride(), dw += stride(), z += translations_ + 3) {
        std::copy_n(z, translations_, dw);
        regular &= coordinates_->derivative(w + translations_, z + translations_, h, dw + translations_);
    }
    std::copy_n(z, system_.velocities(), dw);
    return regular;
}

void GlobalEquations::finish(Real* w) const {
    for (int i = 0; i < bodies_; ++i, w += stride()) coordinates_->finish(w + translations_);
}

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
