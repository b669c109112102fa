// SPDX-License-Identifier: BSD-3-Clause
//
// Gragg-Bulirsch-Stoer: extrapolation that chooses its order and its step to a tolerance. Of the two base methods the
// one on the group is the standard: it takes as many solves, no inverse differential, and meets no limit of a chart.
// Sources: [gragg1965], [bulirschstoer1966], [hairer1993, Sec. II.9].
#include "methods/extrapolation/chart_midpoint.hpp"
#include "methods/extrapolation/gbs_stepper.hpp"
#include "methods/extrapolation/group_midpoint.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

namespace {

Factory gbs() {
    Factory factory;
    factory.stepper = [](System& system, Projection& projection, const Accuracy& accuracy, const OptionValues& options,
                         const MethodDescription& described) {
        const auto base = options.at("base") == OptionValue("chart") ? chart_midpoint : group_midpoint;
        return std::make_unique<GbsStepper>(system, projection, base, accuracy, described.name);
    };
    factory.options = {{.name = "base",
                        .summary =
                            "explicit midpoint rule on the group, or Gragg's rule in a chart around the start of "
                            "each step",
                        .standard = "group",
                        .choices = {"group", "chart"}}};
    return factory;
}

}  // namespace

KREISEL_METHOD(gbs(), {.name = "extrapolation/gbs",
                       .order = 16,
                       .cites = {"gragg1965", "bulirschstoer1966", "hairer1993"},
                       .summary = "Gragg-Bulirsch-Stoer extrapolation of variable order up to 16",
                       .own_control = true});

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
