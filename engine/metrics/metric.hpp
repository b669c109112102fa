// SPDX-License-Identifier: BSD-3-Clause
//
// What a metric is, and how it is registered: one line in its own file. The type of `observe` decides when it is
// measured:
//
//   Real (Observation&)        after every step: a defect, of which the largest and the final value are reported
//   Real (const Separation&)   at the end: an error, measured in the same way between two routes of a reference, so
//                              that its uncertainty is known
//   Real (const Comparison&)   at the end: an error that needs both states; its uncertainty is not known
//   StepDefect (const ObservedStep&)   of single steps from the start and from the end: a structure, with its
//                              uncertainty
//
// NaN and infinity mean: could not be measured.
#pragma once

#include <string>
#include <vector>

#include "engine/metrics/comparison.hpp"
#include "engine/metrics/description.hpp"
#include "engine/metrics/observation.hpp"
#include "engine/structure/observed_step.hpp"
#include "support/registration.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

using ObserveStep = Real (*)(Observation&);
using ObserveSeparation = Real (*)(const Separation&);
using ObserveComparison = Real (*)(const Comparison&);
using ObserveStructure = StepDefect (*)(const ObservedStep&);

/// One of the four functions is not null.
struct Metric {
    MetricDescription description;
    ObserveStep of_step = nullptr;
    ObserveSeparation of_separation = nullptr;
    ObserveComparison of_comparison = nullptr;
    ObserveStructure of_structure = nullptr;
    int place = 0;  ///< in lists: errors, defects, structures; then that of the description
};

/// All metrics, by kind, place and name, whatever the order of linking. Throws std::logic_error if two have one name.
const std::vector<Metric>& metrics();

/// Whether there are rows of the kind a metric is made of.
bool occurs(MetricRows kind, const std::vector<ConstraintRow>& rows);

/// Records a metric; a static object of this type is what KREISEL_METRIC declares.
struct MetricRegistration {
    MetricRegistration(MetricDescription description, ObserveStep observe);
    MetricRegistration(MetricDescription description, ObserveSeparation observe);
    MetricRegistration(MetricDescription description, ObserveComparison observe);
    MetricRegistration(MetricDescription description, ObserveStructure observe);
};

/// KREISEL_METRIC({.name = "error.position", .unit = "m", ...}, observe); several fit in one file.
#define KREISEL_METRIC(...) KREISEL_REGISTER(::kreisel::MetricRegistration, __VA_ARGS__)

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
