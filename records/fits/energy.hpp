// SPDX-License-Identifier: BSD-3-Clause
//
// Whether the energy error of a method stays bounded over a long time, or grows.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace kreisel {

/// Samples that a trend needs, the start and two in each part.
inline constexpr std::size_t least_energy_samples = 65;

/// E - E_0 of one run with steps of size h, sampled at equidistant times t, the first of which is the start.
struct EnergySeries {
    double h = 0;                  ///< s
    std::vector<double> t, drift;  ///< s, J
    double largest = 0;            ///< |E - E_0| over all steps, J
    double scale = 0;              ///< |E_0|, which the round-off of a step is relative to, J; 0: unknown
};

/// The secular rate of E - E_0: the least-squares line through the means over 32 equal parts of the run, which leaves
/// oscillations out. Consecutive means are correlated where a period is long; `error`, three standard errors, counts
/// their residuals as n (1 - r)/(1 + r) independent ones, r the correlation of neighbours [santer2000, eq. (6)], and
/// adds what round-off can do, eight units of it in the same direction in each step.
struct EnergyTrend {
    double h = 0;                    ///< s
    double slope = 0, error = 0;     ///< J/s
    double largest = 0;              ///< J
    double round_off = 0;            ///< J: what that of all steps adds up to
    std::optional<double> exponent;  ///< p of t^p, from the rates over both halves; none where these have other signs
    bool is_zero() const { return slope <= error && -slope <= error; }
};

/// Throws std::invalid_argument unless there are 65 samples at least and h > 0.
EnergyTrend energy_trend(const EnergySeries& series);

enum class EnergyVerdict {
    kept,     ///< E - E_0 is no more than round-off at any step size
    bounded,  ///< no trend at any of two step sizes or more
    linear,   ///< a trend at each, proportional to t within 0.15 of the exponent
    growing,  ///< a trend at each, by another power of t or by none
    unclear,  ///< a trend at some step sizes only, or fewer than two of them
};

struct EnergyLaw {
    EnergyVerdict verdict = EnergyVerdict::unclear;
    std::vector<EnergyTrend> trends;  ///< coarsest step first
    std::optional<double> order;      ///< q of h^q: of the largest |E - E_0| if bounded, of the rate if not
    std::optional<double> exponent;   ///< of t, where the energy error grows; that of the finest step
};

/// The law behind runs of one method with different steps. Throws std::invalid_argument as energy_trend does.
EnergyLaw energy_law(std::vector<EnergySeries> runs);

/// "kept", "bounded, h^2.00", "linear, h^4.98", "t^2.00, h^4.00", "grows", "unclear".
std::string energy_text(const EnergyLaw& law);

}  // namespace kreisel
