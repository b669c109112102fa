// SPDX-License-Identifier: BSD-3-Clause
#include "driver/cli/catalogue/methods.hpp"

#include <fmt/format.h>
#include <fmt/ostream.h>

#include "driver/config/options.hpp"
#include "records/json/writer.hpp"

namespace kreisel {

namespace {

std::string order_text(const Order& order) {
    if (order == Order(order.configuration)) { return fmt::format("order {}", order.configuration); }
    return fmt::format("order {} (configuration), {} (velocity), {} (multipliers)", order.configuration, order.velocity,
                       order.multipliers);
}

void print_options(std::ostream& out, const std::vector<OptionDescription>& options) {
    std::vector<NamedText> rows;
    rows.reserve(options.size());
    for (const OptionDescription& option : options) {
        rows.emplace_back(option.name, fmt::format("{}: {} (default {})", option.summary, allowed_values(option),
                                                   json_value(option.standard)));
    }
    if (rows.empty()) {
        fmt::print(out, "Options: none\n");
    } else {
        print_rows(out, "Options", rows);
    }
}

// Whether steps can be chosen to a tolerance.
std::string control_text(const MethodDescription& method) {
    if (method.own_control) { return "; chooses its steps itself, to a tolerance only"; }
    if (method.estimate == 0) { return ""; }
    const std::string steps = fmt::format("; steps to a tolerance, by an error estimate O(h^{})", method.estimate);
    return method.dense > 0 ? steps + fmt::format("; dense output of its own, of order {}", method.dense) : steps;
}

std::string solving_text(const MethodDescription& method) {
    switch (method.form) {
        case Form::implicit:
            return "implicit, solved by Newton iteration";
        case Form::half_explicit:
            return "half-explicit: stages one after another, each with its multipliers";
        case Form::explicit_steps:
            break;
    }
    if (method.variable_cost || method.stages == 0) { return "explicit"; }
    return fmt::format("explicit, solves of the dynamics per step: {}", method.stages);
}

std::string claims_text(const MethodDescription& method) {
    std::string text;
    for (const Claim& claim : method.preserves) {
        text += fmt::format("; {} ({} systems)", name(claim.property), name(claim.domain));
    }
    return text;
}

std::string constraints_text(const MethodDescription& method) {
    if (method.meets_constraints()) {
        return fmt::format("; {}projections do not apply",
                           method.reports_multipliers ? "multipliers are its own unknowns, " : "");
    }
    return fmt::format("{}{}", method.meets_positions ? "; meets the constraints on positions by itself" : "",
                       method.meets_velocities ? "; meets the constraints on velocities by itself" : "");
}

}  // namespace

std::vector<NamedText> method_rows(const std::vector<MethodDescription>& methods) {
    std::vector<NamedText> rows;
    rows.reserve(methods.size());
    for (const MethodDescription& method : methods) {
        rows.emplace_back(method.name,
                          fmt::format("{}; {}{}", order_text(method.order), method.summary, claims_text(method)));
    }
    return rows;
}

std::string declaration_of(const MethodDescription& method) {
    return fmt::format("{}; {}{}{}{}", order_text(method.order), solving_text(method), control_text(method),
                       claims_text(method), constraints_text(method));
}

void describe_method(const MethodDescription& method, std::ostream& out) {
    fmt::print(out, "{}: {}\n", method.name, method.summary);
    print_sources(out, method.cites);
    fmt::print(out, "{}\n", declaration_of(method));
    print_options(out, method.options);
}

void describe_projection(const ProjectionDescription& projection, std::ostream& out) {
    fmt::print(out, "{}: {}\n", projection.name, projection.summary);
    print_sources(out, projection.cites);
    print_options(out, projection.options);
}

}  // namespace kreisel
