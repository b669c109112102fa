// SPDX-License-Identifier: BSD-3-Clause
//
// No method escapes the check of its steps: there is one for each method or its scheme, none is unused, and each
// rejects steps that follow other equations.
#include <algorithm>
#include <catch2/catch.hpp>

#include "tests/judges/families/scheme_family.hpp"
#include "tests/judges/steps/baseline_step.hpp"
#include "tests/judges/steps/collocation_step.hpp"
#include "tests/judges/steps/half_explicit_step.hpp"
#include "tests/judges/steps/multistep/adams_bashforth_step.hpp"
#include "tests/judges/steps/multistep/adams_moulton_step.hpp"
#include "tests/judges/steps/stabilised_step.hpp"
#include "tests/judges/steps/step_checks.hpp"
#include "tests/judges/steps/symmetric_projection_step.hpp"

using namespace kreisel;

namespace {

/// A correct method of a family unknown to the tests.
Method stranger() {
    Method made_up = method("rkmk/rk4");
    made_up.description.name = "stranger/rk4";
    made_up.factory.scheme.reset();
    return made_up;
}

}  // namespace

TEST_CASE("a method without a one-step check is rejected", "[one_step]") {
    CHECK(one_step_objection(stranger()) ==
          "no one-step check knows this method: declare its scheme, or bring a check of its own");
}

TEST_CASE("an explicit method without a scheme is rejected", "[one_step]") {
    CHECK(order_conditions_objection(stranger()) ==
          "no order conditions for an explicit method without a scheme: declare it, or state why it has none");
    Method implicit = stranger();
    implicit.description.form = Form::implicit;
    CHECK(order_conditions_objection(implicit) == "");
}

TEST_CASE("a method whose scheme is of a family that no test knows is rejected", "[one_step]") {
    struct UnknownFamily {};
    Method unknown = method("rkmk/rk4");
    unknown.factory.scheme = Scheme(UnknownFamily());
    CHECK(one_step_objection(unknown) == "no file of tests/judges/families knows the family of its scheme");
    CHECK(order_conditions_objection(unknown) == "no file of tests/judges/families knows the family of its scheme");
}

TEST_CASE("every family of schemes is that of a registered method", "[one_step]") {
    for (const SchemeFamily& family : Registered<SchemeFamily>::all()) {
        INFO(family.name);
        CHECK(std::any_of(methods().begin(), methods().end(), [&](const Method& method) {
            return method.factory.scheme && family.knows(*method.factory.scheme);
        }));
    }
}

TEST_CASE("every step check is of a registered method without a scheme", "[one_step]") {
    for (const StepCheck& check : step_checks()) {
        INFO(check.name);
        CHECK(std::any_of(methods().begin(), methods().end(), [&](const Method& method) {
            return !method.factory.scheme && covers(check.name, method.description.name);
        }));
    }
}

TEST_CASE("a step check covers its method, its family, and controls that claim to be it", "[one_step]") {
    CHECK(covers("baseline/rk4_matrix", "baseline/rk4_matrix"));
    CHECK(covers("baseline/", "baseline/rk4_matrix"));
    CHECK(covers("multistep/bliedf2", "control/bliedf2_any_fault"));
    CHECK_FALSE(covers("multistep/bliedf2", "multistep/bliedf22"));
    CHECK_FALSE(covers("multistep/bliedf2", "other/bliedf2"));
    CHECK_FALSE(covers("base/", "baseline/rk4_matrix"));
}

TEST_CASE("steps of methods with multipliers satisfy their equations", "[one_step]") {
    const StabilisedForm left = {.side = DenseBodies::Side::left}, end = {.eta_from_end = true},
                         massless = {.eta_without_mass = true}, bare = {.without_eta = true},
                         negated = {.multipliers_negated = true};
    for (const StabilisedForm& wrong : {left, end, massless, bare, negated}) {
        CHECK(generalised_alpha_step_objection(method("generalized_alpha/index2"), wrong) != "");
        CHECK(bliedf_step_objection(method("multistep/bliedf2"), 2, wrong) != "");
    }
    CHECK(generalised_alpha_step_objection(method("generalized_alpha/index2"), {.start_at_rate = true}) != "");
    CHECK(bliedf_step_objection(method("multistep/bliedf2"), 2, {.sign_of_previous = -1}) != "");
    CHECK(bliedf_step_objection(method("multistep/bliedf3"), 3, {.sign_of_previous = -1}) != "");
    CHECK(bliedf_step_objection(method("multistep/bliedf3"), 3, {.sign_of_bracket = -1}) != "");
    CHECK(bliedf_step_objection(method("multistep/bliedf2"), 3) != "");
    CHECK(bliedf_step_objection(method("multistep/bliedf1"), 2) != "");
    const Method& positions = method("multistep/bliedf2_index3");
    CHECK(bliedf_step_objection(method("multistep/bliedf1_index3"), 1) != "");
    for (StabilisedForm wrong : {left, negated, StabilisedForm{.sign_of_previous = -1}}) {
        wrong.without_eta = wrong.positions_alone = true;
        CHECK(bliedf_step_objection(positions, 2, wrong) != "");
    }
    const Method& index3 = method("generalized_alpha/index3");
    for (const StabilisedForm& wrong : {left, negated, StabilisedForm{.sign_of_bracket = -1},
                                        StabilisedForm{.start_at_rate = true}, StabilisedForm{.unperturbed = true}})
        CHECK(position_alpha_step_objection(index3, wrong) != "");
}

TEST_CASE("steps of stages satisfy their equations", "[one_step]") {
    CHECK(herk3_step_objection(method("half_explicit/herk3"), {.first_solved = true}) != "");
    CHECK(herk3_step_objection(method("half_explicit/herk3"), {.without_dexpinv = true}) != "");
    CHECK(herk3_step_objection(method("half_explicit/herk2")) != "");
    using enum CollocationPoints;
    CHECK(collocation_step_objection(method("rkmk/gauss2"), {gauss, 2, false}) != "");  // around the start
    CHECK(collocation_step_objection(method("rkmk/gauss2"), gauss_form(3)) != "");
    CHECK(collocation_step_objection(method("rkmk/radau2a2"), {radau, 2, true}) != "");
    CHECK(collocation_step_objection(method("rkmk/radau2a2"), gauss_form(2)) != "");
    CHECK(collocation_step_objection(method("rkmk/lobatto3ab3"), {lobatto, 3, true, false}) != "");  // IIIA alone
    CHECK(collocation_step_objection(method("rkmk/lobatto3ab3"), {lobatto, 3, false, true}) != "");
}

TEST_CASE("steps of symmetric projections have the same multipliers at both ends", "[one_step]") {
    const Method& midpoint = method("symmetric_projection/midpoint");
    for (const SymmetricProjectionForm& wrong :
         {SymmetricProjectionForm{.after_alone = true}, SymmetricProjectionForm{.start_alone = true},
          SymmetricProjectionForm{.without_mass = true}})
        CHECK(symmetric_projection_step_objection(midpoint, wrong) != "");
    CHECK(symmetric_projection_step_objection(method("rkmk/implicit_midpoint")) != "");
    const Method& gauss2 = method("symmetric_projection/gauss2");
    CHECK(symmetric_projection_step_objection(gauss2) != "");  // not the midpoint rule
    CHECK(symmetric_projection_step_objection(gauss2, {.gauss_stages = 2, .start_alone = true}) != "");
}

TEST_CASE("steps of Adams-Bashforth methods pull the slopes of earlier states back", "[one_step]") {
    for (const int k : {2, 3, 4}) {
        const Method& adams = method("multistep/adams_bashforth" + std::to_string(k));
        CHECK(adams_bashforth_step_objection(adams, k) == "");
        for (const AdamsForm& wrong :
             {AdamsForm{.recentred = false}, AdamsForm{.sign_of_sigma = -1}, AdamsForm{.differences_left_out = 1}})
            CHECK(adams_bashforth_step_objection(adams, k, wrong) != "");
        CHECK(adams_bashforth_step_objection(method("rkmk/rk4"), k) != "");
    }
}

TEST_CASE("steps of Adams-Moulton methods pull all slopes back", "[one_step]") {
    const Method& adams = method("multistep/adams_moulton3");
    for (const AdamsMoultonForm& wrong : {AdamsMoultonForm{.recentred = false}, AdamsMoultonForm{.sign_of_sigma = -1},
                                          AdamsMoultonForm{.differences_left_out = 1}})
        CHECK(adams_moulton_step_objection(adams, 3, wrong) != "");
    CHECK(adams_moulton_step_objection(adams, 2) != "");
}

TEST_CASE("steps are checked in every formulation, with and without constraints", "[one_step]") {
    const auto top = models::applicable(models::standard("forced_heavy_top"));
    CHECK(top == std::vector<std::string>{"SO3xR3", "SE3", "S3xR3", "SO3", "S3",
                                          "SO3-LiePoisson"});  // the last three without constraints
    CHECK(models::applicable(models::standard("forced_free_body")).size() == 3);
    CHECK(make_system(models::standard("forced_free_body"), "SE3")->constraints() == 0);
    CHECK(make_system(models::standard("double_pendulum"), "SE3")->constraints() == 6);
}

TEST_CASE("steps of baselines are those of their coordinates", "[one_step]") {
    // Of the same order, so only the comparison of one step detects it.
    const Method& other = method("crouch_grossman/cg4a");
    CHECK(quaternion_step_objection(other) != "");
    CHECK(matrix_step_objection(other) != "");
    CHECK(euler_angles_step_objection(other) != "");
    CHECK(euler_angles_step_objection(method("baseline/rk4_matrix")) != "");
    CHECK(matrix_step_objection(method("baseline/rk4_euler_angles")) != "");
}

TEST_CASE("the dense logarithm is the inverse of the dense exponential", "[one_step]") {
    VecX u(6);
    u << 3, -2, 1, 1, Real(-3) / 2, Real(1) / 2;
    for (const MatrixGroup& group : {matrix_so3xr3(), matrix_s3xr3(), matrix_se3()}) {
        const MatX U = group.hat(u);
        CHECK((dense_log(dense_exp(U)) - U).cwiseAbs().maxCoeff() < 1000 * epsilon);
        CHECK((group.vee(U) - u).cwiseAbs().maxCoeff() == 0);
    }
}
