// SPDX-License-Identifier: BSD-3-Clause
#include "driver/cli/certify/findings.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <optional>

#include "plots/laws/convergence.hpp"
#include "plots/laws/energy.hpp"
#include "plots/laws/structure.hpp"
#include "records/fits/order.hpp"

namespace kreisel {

namespace {

constexpr double units_of_round_off = 1e4;

Domain domain_of_cell(const ResultRow& row) {
    if (row.problem == "free_top") { return Domain::free; }
    const bool jointed = row.formulation.ends_with("xR3") || row.formulation == "SE3";
    return jointed ? Domain::constrained : Domain::potential;
}

// Whether the metrics of these names, relative to the start where they can be, are round-off; nothing where there are
// none.
std::optional<bool> is_kept(const ResultRow& row, const std::vector<std::string>& prefixes) {
    std::optional<bool> kept;
    for (const auto& [name, value] : row.metrics) {
        const bool plain = name.find('.', name.find('.') + 1) == std::string::npos;
        const bool meant = std::any_of(prefixes.begin(), prefixes.end(),
                                       [&name = name](const std::string& prefix) { return name.starts_with(prefix); });
        if (!plain || !meant) { continue; }
        const auto relative = row.metrics.find(name + ".relative");
        const double drift = relative == row.metrics.end() ? value : relative->second;
        kept = kept.value_or(true) && drift <= units_of_round_off * epsilon_of(row.precision);
    }
    return kept;
}

std::optional<bool> is_kept(const CellGroup& group, const std::string& structure) {
    const StructureLaw law = structure_of(group, structure);
    return law.steps == 0 ? std::nullopt : std::optional(law.kept);
}

std::optional<bool> has_property(const CellGroup& group, Property property) {
    const ResultRow* best = finest(group);
    if (best == nullptr) { return std::nullopt; }
    switch (property) {
        case Property::symplectic:
            return is_kept(group, "structure.symplectic");
        case Property::symmetric:
            return is_kept(group, "structure.reversal");
        case Property::momentum:
            return is_kept(*best, {"invariant.angular_momentum", "invariant.momentum"});
        case Property::energy:
            return is_kept(*best, {"invariant.energy"});
        case Property::constraints:
            return is_kept(*best, {"defect.position", "defect.velocity", "defect.direction"});
    }
    return std::nullopt;
}

// The classes on which a property was measured, and whether every cell has it.
std::map<Domain, bool> seen_on(const Results& results, Property property) {
    std::map<Domain, bool> seen;
    for (const CellGroup& group : group_by_method(results.rows)) {
        const auto has = has_property(group, property);
        if (!has) { continue; }
        auto& all = seen.try_emplace(domain_of_cell(group.front()), true).first->second;
        all = all && *has;
    }
    return seen;
}

// Declared of a class of which no cell tells, or of its largest part that trials have.
std::vector<std::string> claims_not_seen(const MethodDescription& method, Property property,
                                         const std::map<Domain, bool>& seen) {
    std::vector<std::string> complaints;
    for (const Claim& claim : method.preserves) {
        if (claim.property != property || seen.contains(std::min(claim.domain, Domain::constrained))) { continue; }
        complaints.push_back(fmt::format("it declares to be {} on {} systems, and no cell shows it", name(property),
                                         name(claim.domain)));
    }
    return complaints;
}

// On a class and on all that are parts of it.
std::optional<Domain> largest_domain(const std::map<Domain, bool>& seen) {
    std::optional<Domain> largest;
    for (const auto& [domain, has] : seen) {
        if (!has) { break; }
        largest = domain;
    }
    return largest;
}

}  // namespace

Findings structure_findings(const MethodDescription& method, const Results& results) {
    Findings findings;
    for (const Property property :
         {Property::symplectic, Property::symmetric, Property::momentum, Property::energy, Property::constraints}) {
        const auto seen = seen_on(results, property);
        for (const auto& [domain, has] : seen) {
            if (!has && method.claims(property, domain)) {
                findings.complaints.push_back(
                    fmt::format("it declares to be {} on {} systems, and is not", name(property), name(domain)));
            }
        }
        const auto not_seen = claims_not_seen(method, property, seen);
        findings.complaints.insert(findings.complaints.end(), not_seen.begin(), not_seen.end());
        const auto largest = largest_domain(seen);
        if (largest && !method.claims(property, *largest)) {
            findings.remarks.push_back(fmt::format("{} on {} systems, as far as was seen; this is not declared",
                                                   name(property), name(*largest)));
        }
    }
    return findings;
}

Findings energy_findings(const MethodDescription& method, const Results& results) {
    Findings findings;
    for (const CellGroup& group : group_by_method(results.rows)) {
        const auto law = energy_law_of(group);
        const Domain domain = domain_of_cell(group.front());
        const bool claimed = method.claims(Property::symplectic, domain) || method.claims(Property::energy, domain);
        if (!law || !claimed || law->verdict == EnergyVerdict::kept || law->verdict == EnergyVerdict::bounded) {
            continue;
        }
        findings.complaints.push_back(fmt::format("the energy error on {} in {} is not bounded, but {}",
                                                  group.front().label, group.front().formulation, energy_text(*law)));
    }
    return findings;
}

}  // namespace kreisel
