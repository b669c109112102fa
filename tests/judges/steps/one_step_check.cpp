// SPDX-License-Identifier: BSD-3-Clause
//
// One step of the running code against its declared scheme: stage points, stage times, result and error estimate must
// equal an evaluation of the scheme's family (tests/judges/families/) to round-off. Methods without a scheme have
// checks of their own (step_checks.hpp).
#include <algorithm>
#include <stdexcept>

#include "tests/judges/families/scheme_family.hpp"
#include "tests/judges/steps/scheme_checks.hpp"
#include "tests/judges/steps/scripted_step.hpp"
#include "tests/judges/steps/step_checks.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

namespace {

std::string text(const OptionValues& options) {
    std::string all;
    for (const auto& [name, option] : options)
        std::visit(
            [&, key = name](const auto& entry) {
                all += " " + key + "=";
                if constexpr (std::is_convertible_v<decltype(entry), std::string>)
                    all += entry;
                else
                    all += std::to_string(entry);
            },
            option);
    return all;
}

/// The part of a step that differs most from what it should be.
struct Deviation {
    std::string part = "it";
    Real size = 0;
    void see(const std::string& of, const Real& by) {
        if (by > size) part = of, size = by;
    }
};

/// What differs between `found` and the first of the expected stages, result and error.
Deviation deviation(const DenseStep& expected, const DenseStep& found) {
    Deviation most;
    for (std::size_t i = 0; i < found.stages.size(); ++i)
        most.see("stage " + std::to_string(i + 1), distance(expected.stages[i], found.stages[i]));
    most.see("the result", distance(expected.result, found.result));
    if (found.error.size() == 0) return most;
    const VecX apart = expected.error - found.error;
    most.see("the estimate of the error",
             apart.allFinite() ? apart.cwiseAbs().maxCoeff() : std::numeric_limits<Real>::infinity());
    return most;
}

/// `step` is running_step or running_attempt, which takes `stages` of the expected ones.
template <class Step>
Objection compared(const Scenario& s, const DenseStep& expected, std::size_t stages, const Real& tolerance,
                   const std::string& place, Step step) {
    try {
        const DenseStep found = step(s);
        if (found.stages.size() != stages)
            return "takes " + std::to_string(found.stages.size()) + " slopes of " + std::to_string(stages) + place;
        const Deviation most = deviation(expected, found);
        return most.size < tolerance ? "" : most.part + " deviates by " + to_text(most.size) + place;
    } catch (const std::out_of_range&) {
        return "asks for more slopes than it declares" + place;
    } catch (const std::domain_error& failure) { return failure.what() + place; }
}

Objection scheme_objection(const Method& method, const SchemeFamily& family, const OptionValues& options,
                           const MatrixGroup& group) {
    const Scheme& scheme = *method.factory.scheme;
    const ClassicalScheme classical = family.classical(scheme);
    const Real size = magnitude(classical), tolerance = one_step_tolerance() * size;
    const Scenario s = scenario(group, classical.a.size(), size);
    const DenseStep expected = family.step(scheme, scripted(s, options, method.description.order.configuration));
    const std::string place = " on " + group.name + text(options);
    const Objection objection =
        compared(s, expected, static_cast<std::size_t>(method.description.stages), tolerance, place,
                 [&](const Scenario& given) { return running_step(method, options, given); });
    if (!objection.empty() || method.description.estimate == 0) return objection;
    if (expected.error.size() == 0) return "declares an estimate of its error, which its scheme does not have";
    return compared(s, expected, expected.stages.size(), tolerance, place + ", an attempt",
                    [&](const Scenario& given) { return running_attempt(method, options, given); });
}

Objection scheme_objection(const Method& method) {
    const SchemeFamily* family = family_of(*method.factory.scheme);
    if (!family) return "no file of tests/judges/families knows the family of its scheme";
    for (const MatrixGroup& group : {matrix_so3(), matrix_se3()})
        for (const OptionValues& options : scheme_variants(method)) {
            const Objection objection = scheme_objection(method, *family, options, group);
            if (!objection.empty()) return objection;
        }
    return "";
}

Objection own_objection(const Method& method) {
    const StepCheck* check = step_check_of(method);
    if (!check) return "no one-step check knows this method: declare its scheme, or bring a check of its own";
    try {
        return check->objection(method);
    } catch (const std::domain_error& failure) { return failure.what(); }
}

}  // namespace

std::vector<OptionValues> scheme_variants(const Method& method) {
    const auto& options = method.description.options;
    const auto coordinates =
        std::find_if(options.begin(), options.end(), [](const auto& option) { return option.name == "coordinates"; });
    if (coordinates == options.end()) return {{}};
    std::vector<OptionValues> all;
    for (const std::string& chart : coordinates->choices)
        if (chart != "exp") all.push_back(with_defaults({{"coordinates", chart}, {"dexpinv", "exact"}}, options));
    for (const OptionValue& dexpinv : {OptionValue("exact"), OptionValue("seed"), OptionValue(0L), OptionValue(1L),
                                       OptionValue(2L), OptionValue(4L), OptionValue(9L)})
        all.push_back(with_defaults({{"coordinates", "exp"}, {"dexpinv", dexpinv}}, options));
    return all;
}

Real one_step_difference(const Method& method, const OptionValues& a, const OptionValues& b, const MatrixGroup& group) {
    const Scenario s = scenario(group, static_cast<std::size_t>(method.description.stages), 1);
    return distance(running_step(method, a, s).result, running_step(method, b, s).result);
}

Objection one_step_objection(const Method& method) {
    return method.factory.scheme ? scheme_objection(method) : own_objection(method);
}

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
