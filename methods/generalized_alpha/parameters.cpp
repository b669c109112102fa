// SPDX-License-Identifier: BSD-3-Clause
#include "methods/generalized_alpha/parameters.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

namespace {

const char* const from_rho = "rho";

/// The number that an option gives, else what follows from rho.
Real given_or(const OptionValues& options, const char* name, const Real& otherwise) {
    const auto found = options.find(name);
    const double* number = found == options.end() ? nullptr : std::get_if<double>(&found->second);
    return number ? decimal(*number) : otherwise;
}

OptionDescription parameter(const char* name, const char* summary, double least, double most) {
    return {.name = name,
            .summary = summary,
            .standard = from_rho,
            .choices = {from_rho},
            .real_min = least,
            .real_max = most};
}

/// Newmark's formulas damp what the constraints leave free of q and v if gamma > 1/2 and 2 beta > gamma; the recursion
/// of v' damps lambda if alpha_f < 1/2, that of a is stable if alpha_m <= alpha_f.
std::string why_unstable(const OptionValues& options) {
    const auto rho = options.find("rho");
    const AlphaParameters p = alpha_parameters(options);
    if (p.alpha_m <= p.alpha_f && 2 * p.alpha_f < 1 && 2 * p.gamma > 1 && 2 * p.beta > p.gamma) return "";
    if (rho != options.end() && std::get<double>(rho->second) == 1)
        return "with rho = 1 nothing damps the multipliers: they do not converge";
    return "parameters that damp satisfy alpha_m <= alpha_f < 1/2 < gamma < 2 beta";
}

}  // namespace

AlphaParameters alpha_parameters(const OptionValues& options) {
    const Real rho = given_or(options, from_rho, Real(9) / 10);
    AlphaParameters p;
    p.alpha_m = given_or(options, "alpha_m", (2 * rho - 1) / (rho + 1));
    p.alpha_f = given_or(options, "alpha_f", rho / (rho + 1));
    p.gamma = given_or(options, "gamma", Real(1) / 2 + p.alpha_f - p.alpha_m);
    p.beta = given_or(options, "beta", (p.gamma + Real(1) / 2) * (p.gamma + Real(1) / 2) / 4);
    return p;
}

Factory alpha_factory(decltype(Factory::make) make) {
    Factory factory;
    factory.make = std::move(make);
    factory.options = {{.name = from_rho,
                        .summary = "spectral radius at infinite frequency, below 1: 0 damps most",
                        .standard = 9.0 / 10,
                        .real_min = 0,
                        .real_max = 1},
                       parameter("alpha_m", "weight of the old a, or as it follows from rho", -1, 0.5),
                       parameter("alpha_f", "weight of the old v', or as it follows from rho", 0, 0.5),
                       parameter("gamma", "of the velocities; order 2 if 1/2 + alpha_f - alpha_m, as with rho", 0, 2),
                       parameter("beta", "of the increments, or (gamma + 1/2)^2 / 4 with rho", 0, 2)};
    factory.order = [](const OptionValues& options, const Order& declared) {
        const AlphaParameters p = alpha_parameters(options);
        const Real off = p.gamma - (Real(1) / 2 + p.alpha_f - p.alpha_m);
        return abs(off) < Real(1) / 1000000 ? declared : Order(1);
    };
    factory.why_not = why_unstable;
    return factory;
}

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
