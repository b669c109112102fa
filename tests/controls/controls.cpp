// SPDX-License-Identifier: BSD-3-Clause
#include "tests/controls/controls.hpp"

#include "tests/controls/broken.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

namespace {

const Tableau& tableau_of(const std::string& name) { return method(name).factory.scheme->tableau; }

/// A control that claims to be the registered method `original`.
Control control(const std::string& original, const std::string& fault, Factory factory, int true_order) {
    MethodDescription claim = method(original).description;
    claim.name = "control/" + original.substr(original.find('/') + 1) + "_" + fault;
    claim.summary = "broken on purpose: " + original + ", " + fault;
    claim.options = {};
    return {.method = {.description = claim, .factory = std::move(factory), .file = __FILE__},
            .true_order = true_order,
            .seen_by_one_step = true};
}

Control rkmk_control(const std::string& original, const std::string& fault, MuntheKaasFault broken, int true_order) {
    return control(original, fault, broken_rkmk(tableau_of(original), broken), true_order);
}

Control crouch_grossman_control(const std::string& original, const std::string& fault, CrouchGrossmanFault broken,
                                int true_order) {
    return control(original, fault, broken_crouch_grossman(tableau_of(original), broken), true_order);
}

std::vector<Control> make_controls() {
    using enum MuntheKaasFault::Dexpinv;
    return {
        rkmk_control("rkmk/rk4", "without_dexpinv", {.dexpinv = absent}, 2),
        rkmk_control("rkmk/rk4", "wrong_sign_of_dexpinv", {.dexpinv = wrong_sign}, 2),
        rkmk_control("rkmk/rk4", "stages_at_old_time", {.frozen_time = true}, 1),
        rkmk_control("rkmk/kutta3", "without_dexpinv", {.dexpinv = absent}, 2),
        // Order 2 needs no dexpinv: only the comparison of one step can tell.
        rkmk_control("rkmk/midpoint", "without_dexpinv", {.dexpinv = absent}, 2),
        crouch_grossman_control("crouch_grossman/cg3a", "reversed_final_factors", {.reversed_final_factors = true}, 2),
        // Two different branches at one node take four nodes: order 3 cannot see the stage products.
        crouch_grossman_control("crouch_grossman/cg3a", "reversed_stage_factors", {.reversed_stage_factors = true}, 3),
        crouch_grossman_control("crouch_grossman/cg4a", "reversed_stage_factors", {.reversed_stage_factors = true}, 3),
        crouch_grossman_control("crouch_grossman/cg4a", "reversed_rows", {.reversed_rows = true}, 2)};
}

}  // namespace

const std::vector<Control>& controls() {
    static const std::vector<Control> all = make_controls();
    return all;
}

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
