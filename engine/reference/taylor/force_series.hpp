// SPDX-License-Identifier: BSD-3-Clause
//
// What acts on bodies as power series in time, all in space axes. Laws are those of mechanics/forces/, derived a second
// time: a file each in engine/reference/taylor/forces/.
#pragma once

#include <functional>
#include <memory>
#include <stdexcept>

#include "engine/reference/taylor/taylor_bodies.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

/// Refers to series of bodies that outlive it.
class ForceSeries {
  public:
    virtual ~ForceSeries() = default;
    /// At the expansion point, at time t.
    virtual void start(const Real& /*t*/) {}
    /// Adds coefficient k to the bodies it acts on.
    virtual void act(std::size_t k) = 0;
    /// Before the next expansion, at a time s after the last one: keeps the state that poses and velocities do not
    /// contain.
    virtual void move_on(const Real& /*s*/) {}
    /// Whether the force is not defined a time s after the expansion point.
    virtual bool has_parted(const Real& /*s*/) const { return false; }
};

/// The series of a body, or of the ground.
using BodyAt = std::function<BodySeries&(int body)>;

/// Makes the series of a force; recorded before main by SeriesRegistration.
template <class Force>
inline std::unique_ptr<ForceSeries> (*series_maker)(const Force& force, const BodyAt& at) = nullptr;

/// Records which series is that of a force: a static object in its file.
template <class Force, class Series>
struct SeriesRegistration {
    SeriesRegistration() {
        series_maker<Force> = [](const Force& force, const BodyAt& at) -> std::unique_ptr<ForceSeries> {
            return std::make_unique<Series>(force, at);
        };
    }
};

/// Throws std::logic_error if no file in engine/reference/taylor/forces/ derives the series of this force.
template <class Force>
std::unique_ptr<ForceSeries> series_of(const Force& force, const BodyAt& at) {
    if (!series_maker<Force>) throw std::logic_error("a force of the model has no series in the second route");
    return series_maker<Force>(force, at);
}

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
