// SPDX-License-Identifier: BSD-3-Clause
//
// The description of a metric, free of `Real`: lists, checks of a config, units, axis labels, tables, declared orders
// and the scales of comparisons follow from it. First integrals, `invariant.NAME`, are not among these: a system names
// its integrals itself, and what is measured of each is listed below.
#pragma once

#include <string>

namespace kreisel {

/// Which of the declared orders (methods/contract/description.hpp) an error is held against.
enum class MetricLevel { none, configuration, velocity, multipliers };

/// The constraint rows that a metric is made of: all the same whether there are any, lengths, or comparisons of
/// directions.
enum class MetricRows { any, lengths, directions };

/// A metric is a difference with the round-off of the numbers subtracted: near round-off its own size is meaningless,
/// and two of its values are compared relative to the size of these numbers in the final state. `position`, `velocity`,
/// `omega`, `force` and `torque` are the largest components x, v, w of the bodies and those of the multipliers,
/// `acceleration` is v (w + 1/T), `angular_acceleration` w (w + 1/T) with T = t_end; `own` is the metric's own size.
enum class MetricScale { own, one, position, velocity, omega, force, torque, acceleration, angular_acceleration };

/// `error`: distance from the reference at the end; NAME.max is the largest over the samples of a run, those between
/// steps among them. `defect`: deviation from the constraints or the group, the largest over all steps; NAME.final is
/// the one at the end. `structure`: of single steps of one size, the largest at the start and at the end of a run,
/// where it is above ten times its uncertainty, NAME.uncertainty.
enum class MetricKind { error, defect, structure };
inline constexpr const char *largest_of_error = ".max", *final_of_defect = ".final",
                            *uncertainty_of_structure = ".uncertainty";

struct MetricDescription {
    std::string name, unit;
    std::string symbol;  ///< in gnuplot's enhanced notation
    std::string summary;
    MetricLevel level = MetricLevel::none;
    MetricRows rows = MetricRows::any;
    MetricScale scale = MetricScale::own;
    int place = 1000;                      ///< metrics are listed and written by kind, place and name
    MetricKind kind = MetricKind::defect;  ///< set on registration
};

/// What is measured of the deviation of a first integral: what stands behind `invariant.NAME`.
struct IntegralSuffix {
    const char *name, *unit, *summary;
};
inline constexpr IntegralSuffix largest_of_integral = {"", "as the integral", "largest |I - I0| over all steps"},
                                final_of_integral = {".final", "as the integral", "|I - I0| at the end"},
                                relative_of_integral = {".relative", "1",
                                                        "largest |I - I0| / |I0|, where I0 is not zero"},
                                slope_of_integral = {".slope", "as the integral per s",
                                                     "secular rate: least-squares slope of I - I0 over time"},
                                slope_error_of_integral = {".slope_error", "as the integral per s",
                                                           "standard error of that slope"};
inline constexpr IntegralSuffix integral_suffixes[] = {largest_of_integral, final_of_integral, relative_of_integral,
                                                       slope_of_integral, slope_error_of_integral};

}  // namespace kreisel
