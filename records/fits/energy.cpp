// SPDX-License-Identifier: BSD-3-Clause
#include "records/fits/energy.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <stdexcept>

#include "records/fits/fit.hpp"

namespace kreisel {

namespace {

constexpr std::size_t parts_of_run = 32;
static_assert(least_energy_samples == 2 * parts_of_run + 1);
constexpr double round_off_of_step = 8 * std::numeric_limits<double>::epsilon();
constexpr double highest_correlation = 0.9;  // beyond, 32 means would count as fewer than two
constexpr double linear_within = 0.15;

struct Means {
    std::vector<double> t, y;
};

// Over equal parts; the start and what is left over at the end belong to none.
Means means_of(const EnergySeries& series) {
    const std::size_t width = (series.t.size() - 1) / parts_of_run;
    Means means;
    for (std::size_t k = 0; k < parts_of_run; ++k) {
        const auto mean = [&](const std::vector<double>& all) {
            const auto first = all.begin() + static_cast<std::ptrdiff_t>(1 + k * width);
            return std::accumulate(first, first + static_cast<std::ptrdiff_t>(width), 0.0) / static_cast<double>(width);
        };
        means.t.push_back(mean(series.t));
        means.y.push_back(mean(series.drift));
    }
    return means;
}

// The correlation of neighbouring residuals, between 0 and the highest that is counted.
double correlation(const Means& means, const FittedLine& line) {
    double together = 0, square = 0, before = 0;
    for (std::size_t i = 0; i < means.t.size(); ++i) {
        const double residual = means.y[i] - line.intercept - line.slope * means.t[i];
        together += residual * before;
        square += residual * residual;
        before = residual;
    }
    return square > 0 ? std::clamp(together / square, 0.0, highest_correlation) : 0;
}

double rate_between(const Means& means, std::size_t first, std::size_t last) {
    const auto part = [&](const std::vector<double>& all) {
        return std::vector<double>(all.begin() + static_cast<std::ptrdiff_t>(first),
                                   all.begin() + static_cast<std::ptrdiff_t>(last));
    };
    return fit_line(part(means.t), part(means.y)).slope;
}

// (2T)^p - T^p over T^p is 2^p - 1, whatever the energy oscillates about.
std::optional<double> exponent_of(const Means& means) {
    const double early = rate_between(means, 0, parts_of_run / 2),
                 late = rate_between(means, parts_of_run / 2, parts_of_run);
    if (!(early * late > 0)) { return std::nullopt; }
    return std::log2(1 + late / early);
}

std::optional<double> order_between(const EnergyTrend& coarse, const EnergyTrend& fine, double ratio, bool bounded) {
    const double a = bounded ? coarse.largest : std::abs(coarse.slope);
    const double b = bounded ? fine.largest : std::abs(fine.slope);
    const bool seen = !bounded || fine.largest > fine.round_off;
    return seen && a > 0 && b > 0 ? std::optional(std::log(a / b) / std::log(ratio)) : std::nullopt;
}

EnergyVerdict verdict_of(const std::vector<EnergyTrend>& trends) {
    const auto all = [&](auto holds) { return std::all_of(trends.begin(), trends.end(), holds); };
    if (all([](const EnergyTrend& one) { return one.largest <= one.round_off; })) { return EnergyVerdict::kept; }
    if (trends.size() < 2) { return EnergyVerdict::unclear; }
    if (all([](const EnergyTrend& one) { return one.is_zero(); })) { return EnergyVerdict::bounded; }
    if (!all([](const EnergyTrend& one) { return !one.is_zero(); })) { return EnergyVerdict::unclear; }
    const bool linear =
        all([](const EnergyTrend& one) { return one.exponent && std::abs(*one.exponent - 1) <= linear_within; });
    return linear ? EnergyVerdict::linear : EnergyVerdict::growing;
}

std::string power_of_h(const EnergyLaw& law) { return law.order ? fmt::format(", h^{:.2f}", *law.order) : ""; }

}  // namespace

EnergyTrend energy_trend(const EnergySeries& series) {
    if (series.t.size() != series.drift.size() || series.t.size() < least_energy_samples || !(series.h > 0)) {
        throw std::invalid_argument(
            fmt::format("energy_trend: {} samples at least and h > 0 are needed", least_energy_samples));
    }
    const Means means = means_of(series);
    const FittedLine line = fit_line(means.t, means.y);
    const double r = correlation(means, line);
    EnergyTrend trend;
    trend.h = series.h;
    trend.slope = line.slope;
    trend.error = 3 * line.slope_error * std::sqrt((1 + r) / (1 - r)) + round_off_of_step * series.scale / series.h;
    trend.largest = series.largest;
    trend.round_off = round_off_of_step * series.scale / series.h * series.t.back();
    trend.exponent = exponent_of(means);
    return trend;
}

EnergyLaw energy_law(std::vector<EnergySeries> runs) {
    std::sort(runs.begin(), runs.end(), [](const auto& a, const auto& b) { return a.h > b.h; });
    EnergyLaw law;
    for (const EnergySeries& run : runs) { law.trends.push_back(energy_trend(run)); }
    if (runs.empty()) { return law; }
    law.verdict = verdict_of(law.trends);
    const bool bounded = law.verdict == EnergyVerdict::bounded;
    const bool grows = law.verdict == EnergyVerdict::linear || law.verdict == EnergyVerdict::growing;
    if (bounded || grows) {
        law.order = order_between(law.trends[runs.size() - 2], law.trends.back(),
                                  runs[runs.size() - 2].h / runs.back().h, bounded);
    }
    if (grows) { law.exponent = law.trends.back().exponent; }
    return law;
}

std::string energy_text(const EnergyLaw& law) {
    switch (law.verdict) {
        case EnergyVerdict::kept:
            return "kept";
        case EnergyVerdict::bounded:
            return "bounded" + power_of_h(law);
        case EnergyVerdict::linear:
            return "linear" + power_of_h(law);
        case EnergyVerdict::growing:
            return (law.exponent ? fmt::format("t^{:.2f}", *law.exponent) : "grows") + power_of_h(law);
        case EnergyVerdict::unclear:
            break;
    }
    return "unclear";
}

}  // namespace kreisel
