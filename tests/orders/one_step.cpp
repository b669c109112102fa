// SPDX-License-Identifier: BSD-3-Clause
//
// One step of the running code against its declared scheme. With scripted accelerations the slopes of the stages do not
// commute and do not depend on the state, so that stage points, stage times and result must equal an evaluation with
// dense matrices to round-off. This sees what no order can: a missing dexpinv at order 2, the order of stage factors.
#include <catch2/catch.hpp>
#include <random>

#include "methods/integrator.hpp"
#include "tests/controls/controls.hpp"
#include "tests/orders/declared_step.hpp"
#include "tests/orders/scripted_system.hpp"

using namespace kreisel;

namespace {

/// Round-off of some ten matrix products.
Real tolerance() { return KREISEL_QUAD ? from_text("1e-30") : from_text("1e-14"); }

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
    const auto integrator = method.factory.make(system, options, method.description);
    VecX y = s.y;
    REQUIRE(integrator->step(s.t, s.h, y.data()) == Status::ok);
    DenseStep step;
    for (const auto& call : system.calls()) step.stages.push_back({call.t, s.group.matrix(call.q.data()), call.v});
    step.result = dense(s.group, s.t + s.h, y);
    return step;
}

/// Largest difference of an entry; infinite where one is not a number.
Real distance(const DensePoint& a, const DensePoint& b) {
    if (!isfinite(Real(a.t - b.t + (a.q - b.q).sum() + (a.v - b.v).sum())))
        return std::numeric_limits<Real>::infinity();
    return max(Real(abs(Real(a.t - b.t))), max((a.q - b.q).cwiseAbs().maxCoeff(), (a.v - b.v).cwiseAbs().maxCoeff()));
}

/// Largest difference between running and declared step, over stages and result; their numbers must agree.
Real deviation(const Method& method, const OptionValues& options, const MatrixGroup& group) {
    const Scenario s = scenario(group, method.description.stages);
    const DenseStep expected = declared(method, options, s), found = running(method, options, s);
    REQUIRE(found.stages.size() == expected.stages.size());
    Real largest = distance(expected.result, found.result);
    for (std::size_t i = 0; i < found.stages.size(); ++i)
        largest = max(largest, distance(expected.stages[i], found.stages[i]));
    return largest;
}

/// Every combination of options that changes the scheme.
std::vector<OptionValues> variants(const Method& method) {
    if (method.factory.scheme->kind != Scheme::Kind::munthe_kaas) return {{}};
    std::vector<OptionValues> all = {{{"coordinates", "cayley"}, {"dexpinv", "exact"}}};
    for (const OptionValue& dexpinv : {OptionValue("exact"), OptionValue("seed"), OptionValue(0L), OptionValue(1L),
                                       OptionValue(2L), OptionValue(4L), OptionValue(9L)})
        all.push_back({{"coordinates", "exp"}, {"dexpinv", dexpinv}});
    return all;
}

std::string text(const OptionValues& options) {
    std::string all;
    for (const auto& [name, option] : options) {
        const auto* word = std::get_if<std::string>(&option);
        all += " " + name + "=" + (word ? *word : std::to_string(std::get<long>(option)));
    }
    return all;
}

}  // namespace

TEST_CASE("one step of every registered method equals its declared scheme", "[one_step]") {
    int methods_seen = 0;
    for (const Method& method : methods()) {
        if (!method.factory.scheme) continue;
        ++methods_seen;
        for (const MatrixGroup& group : {matrix_so3(), matrix_se3()})
            for (const OptionValues& options : variants(method)) {
                const Real found = deviation(method, options, group);
                INFO(method.description.name << text(options) << " on " << group.name << ": " << to_text(found));
                CHECK(found < tolerance());
            }
    }
    CHECK(methods_seen >= 10);
}

TEST_CASE("one step tells every option from every other", "[one_step]") {
    // Otherwise the comparison above would not notice an option that is ignored.
    const Method& rk4 = method("rkmk/rk4");
    for (const MatrixGroup& group : {matrix_so3(), matrix_se3()}) {
        const Scenario s = scenario(group, rk4.description.stages);
        const auto all = variants(rk4);
        for (std::size_t i = 0; i < all.size(); ++i)
            for (std::size_t j = 0; j < i; ++j) {
                // q = p - 1 = 3 brackets are q = 2, because B_3 = 0.
                const bool same =
                    all[j].at("dexpinv") == OptionValue("seed") && all[i].at("dexpinv") == OptionValue(2L);
                const Real apart = distance(running(rk4, all[i], s).result, running(rk4, all[j], s).result);
                INFO(text(all[i]) << " and" << text(all[j]) << " on " << group.name << ": " << to_text(apart));
                CHECK((apart > 1000 * tolerance()) == !same);
            }
    }
}

TEST_CASE("one step turns down every control that it can see", "[one_step]") {
    int seen = 0;
    for (const Control& control : controls()) {
        for (const MatrixGroup& group : {matrix_so3(), matrix_se3()}) {
            const Real found = deviation(control.method, {}, group);
            INFO(control.method.description.name << " on " << group.name << ": " << to_text(found));
            CHECK((found > Real(1) / 1000) == control.seen_by_one_step);
        }
        seen += control.seen_by_one_step;
    }
    CHECK(seen >= 6);
}
