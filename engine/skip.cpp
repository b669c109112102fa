// SPDX-License-Identifier: BSD-3-Clause
#include "engine/skip.hpp"

#include <algorithm>

#include "mechanics/formulation.hpp"
#include "mechanics/start.hpp"
#include "methods/contract/method.hpp"
#include "methods/contract/projection.hpp"
#include "problems/problem.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

namespace {

bool applies(const std::vector<std::string>& formulations, const std::string& name) {
    return formulations.empty() || std::find(formulations.begin(), formulations.end(), name) != formulations.end();
}

std::string only_for(const std::string& who, const std::vector<std::string>& formulations) {
    std::string list;
    for (const std::string& name : formulations) list += (list.empty() ? "" : ", ") + name;
    return who + " runs for " + list + " only";
}

/// Why a method does not take the steps of a cell, of one size or to a tolerance; empty if it does.
std::string why_not_paced(const Cell& cell, const MethodDescription& method) {
    if (method.own_control && cell.tolerance == 0) return cell.method + " chooses its steps itself, to a tolerance";
    if (cell.tolerance == 0 || method.own_control || method.estimate > 0) return "";
    return cell.method + (method.keeps_memory ? " remembers steps of one size, and has no formulas for changing ones"
                                              : " has no estimate of its error to choose steps by");
}

/// Why a projection does not apply; empty if it does.
std::string why_not_projected(const Cell& cell, const Model& model, const MethodDescription& method) {
    const ProjectionMethod& entry = projection(cell.projection);
    const ProjectionDescription& projector = entry.description;
    if (!method.projectable && !entry.stabilises())
        return cell.method + " remembers earlier steps, which a projection after each would invalidate";
    if (method.meets_constraints())
        return cell.method + " meets the constraints by itself, so that nothing is left to project";
    if (const std::string reason = entry.why_not(method); !reason.empty()) return reason;
    const auto every = cell.projection_options.find("every");
    if (cell.tolerance > 0 && every != cell.projection_options.end() && every->second != OptionValue(1L))
        return "what a projection moves a state by counts as error of its step, which the drift of several is not";
    if (!applies(projector.formulations, cell.formulation))
        return only_for("projection " + cell.projection, projector.formulations);
    const auto system = make_system(model, cell.formulation);
    if (projector.ambient && !system->has_ambient_jacobian())
        return "projection " + cell.projection + " takes spherical joints only";
    return system->constraints() == 0 ? "there is no constraint to project onto in formulation " + cell.formulation
                                      : "";
}

}  // namespace

std::string why_skipped(const Cell& cell) {
    const Model model = problem(cell.problem).build(Parameters(cell.parameters));
    check_start(model);
    const Method& entry = method(cell.method);
    projection(cell.projection);  // must exist
    if (const std::string reason = formulation(cell.formulation).why_not(model); !reason.empty()) return reason;
    if (!applies(entry.description.formulations, cell.formulation))
        return only_for(cell.method, entry.description.formulations);
    if (const std::string reason = entry.factory.why_not(cell.options); !reason.empty()) return reason;
    if (const std::string reason = why_not_paced(cell, entry.under(cell.options)); !reason.empty()) return reason;
    if (entry.factory.declines)
        if (const std::string reason = entry.factory.declines(*make_system(model, cell.formulation)); !reason.empty())
            return cell.method + " does not treat " + reason;
    return cell.projection == "none" ? "" : why_not_projected(cell, model, entry.description);
}

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
