// SPDX-License-Identifier: BSD-3-Clause
//
// One step of the running code against its declared scheme. With scripted accelerations the slopes of the stages do not
// commute and do not depend on the state, so that stage points, stage times and result must equal an evaluation with
// dense matrices to round-off. Methods without a scheme have checks of their own (step_checks.hpp).
#include <algorithm>
#include <random>
#include <stdexcept>

#include "methods/contract/integrator.hpp"
#include "tests/judges/steps/declared_step.hpp"
#include "tests/judges/steps/scheme_checks.hpp"
#include "tests/judges/steps/scripted_system.hpp"
#include "tests/judges/steps/step_checks.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

namespace {

VecX random_vector(std::mt19937& generator, Eigen::Index size) {
    VecX x(size);
    for (auto& entry : x) entry = Real(static_cast<int>(generator() % 2001) - 1000) / 1000;
    return x;
}

/// A step whose rotations are of order one: every term of dexpinv shows.
struct Scenario {
    MatrixGroup group;
    Real t = Real(7) / 4, h = Real(3) / 8;
    VecX y;  ///< initial state as stored
    std::vector<VecX> script;
};

Scenario scenario(const MatrixGroup& group, int stages) {
    std::mt19937 generator(5);
    const Eigen::Index n = group.group->dim(), size = group.group->size();
    Scenario s{.group = group, .y = VecX(size + n), .script = {}};
    group.group->identity(s.y.data());
    group.group->append_exp(s.y.data(), random_vector(generator, n).data(), s.y.data());
    s.y.tail(n) = 2 * random_vector(generator, n);
    for (int i = 0; i < stages; ++i) s.script.push_back(5 * random_vector(generator, n));
    return s;
}

DensePoint dense(const MatrixGroup& group, const Real& t, const VecX& y) {
    return {t, group.matrix(y.data()), y.tail(group.group->dim())};
}

DenseStep declared(const Method& method, const OptionValues& options, const Scenario& s) {
    const Scheme& scheme = *method.factory.scheme;
    const DensePoint start = dense(s.group, s.t, s.y);
    if (scheme.kind == Scheme::Kind::crouch_grossman)
        return dense_crouch_grossman(s.group, scheme.tableau, s.script, s.h, start);
    const DenseChart chart = dense_chart(s.group, options, method.description.order.configuration);
    return dense_munthe_kaas(s.group, chart, scheme.tableau, s.script, s.h, start);
}

DenseStep running(const Method& method, const OptionValues& options, const Scenario& s) {
    ScriptedSystem system(s.group.group, s.script);
    const auto integrator = method.bind(system, options);
    VecX y = s.y;
    if (integrator->step(s.t, s.h, y.data()) != Status::ok) throw std::domain_error("the step fails");
    DenseStep step;
    for (const auto& call : system.calls()) step.stages.push_back({call.t, s.group.matrix(call.q.data()), call.v});
    step.result = dense(s.group, s.t + s.h, y);
    return step;
}

/// Largest difference of an entry; infinite if one is NaN.
Real distance(const DensePoint& a, const DensePoint& b) {
    if (!isfinite(Real(a.t - b.t + (a.q - b.q).sum() + (a.v - b.v).sum())))
        return std::numeric_limits<Real>::infinity();
    return max(Real(abs(Real(a.t - b.t))), max((a.q - b.q).cwiseAbs().maxCoeff(), (a.v - b.v).cwiseAbs().maxCoeff()));
}

/// Largest difference between running and declared step, over stages and result; infinite where their numbers differ.
Real deviation(const Method& method, const OptionValues& options, const MatrixGroup& group) {
    const Scenario s = scenario(group, method.description.stages);
    const DenseStep expected = declared(method, options, s), found = running(method, options, s);
    if (found.stages.size() != expected.stages.size()) return std::numeric_limits<Real>::infinity();
    Real largest = distance(expected.result, found.result);
    for (std::size_t i = 0; i < found.stages.size(); ++i)
        largest = max(largest, distance(expected.stages[i], found.stages[i]));
    return largest;
}

std::string text(const OptionValues& options) {
    std::string all;
    for (const auto& [name, option] : options) {
        const auto* word = std::get_if<std::string>(&option);
        all += " " + name + "=" + (word ? *word : std::to_string(std::get<long>(option)));
    }
    return all;
}

Objection one_step_objection(const Method& method, const OptionValues& options, const MatrixGroup& group) {
    try {
        const Real found = deviation(method, options, group);
        return found < one_step_tolerance() ? ""
                                            : "deviates by " + to_text(found) + " on " + group.name + text(options);
    } catch (const std::out_of_range&) {
        return "asks for more slopes than it declares";
    } catch (const std::domain_error& failure) { return failure.what(); }
}

}  // namespace

std::vector<OptionValues> scheme_variants(const Method& method) {
    const auto& options = method.description.options;
    const auto named = [](const OptionDescription& option) { return option.name == "coordinates"; };
    if (std::none_of(options.begin(), options.end(), named)) return {{}};
    std::vector<OptionValues> all = {{{"coordinates", "cayley"}, {"dexpinv", "exact"}}};
    for (const OptionValue& dexpinv : {OptionValue("exact"), OptionValue("seed"), OptionValue(0L), OptionValue(1L),
                                       OptionValue(2L), OptionValue(4L), OptionValue(9L)})
        all.push_back({{"coordinates", "exp"}, {"dexpinv", dexpinv}});
    return all;
}

Real one_step_difference(const Method& method, const OptionValues& a, const OptionValues& b, const MatrixGroup& group) {
    const Scenario s = scenario(group, method.description.stages);
    return distance(running(method, a, s).result, running(method, b, s).result);
}

namespace {

Objection scheme_objection(const Method& method) {
    for (const MatrixGroup& group : {matrix_so3(), matrix_se3()})
        for (const OptionValues& options : scheme_variants(method)) {
            const Objection objection = one_step_objection(method, options, group);
            if (!objection.empty()) return objection;
        }
    return "";
}

Objection own_objection(const Method& method) {
    for (const StepCheck& check : step_checks())
        if (covers(check.knows, method.description.name)) {
            try {
                return check.objection(method);
            } catch (const std::domain_error& failure) { return failure.what(); }
        }
    return "no one-step check knows this method: declare its scheme, or bring a check of its own";
}

}  // namespace

Objection one_step_objection(const Method& method) {
    return method.factory.scheme ? scheme_objection(method) : own_objection(method);
}

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
