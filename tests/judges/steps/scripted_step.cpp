// SPDX-License-Identifier: BSD-3-Clause
#include "tests/judges/steps/scripted_step.hpp"

#include <random>
#include <stdexcept>

#include "methods/contract/integrator.hpp"
#include "tests/judges/steps/scripted_system.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

namespace {

VecX random_vector(std::mt19937& generator, Eigen::Index size) {
    VecX x(size);
    for (auto& entry : x) entry = Real(static_cast<int>(generator() % 2001) - 1000) / 1000;
    return x;
}

DensePoint dense(const MatrixGroup& group, const Real& t, const VecX& y) {
    return {t, group.matrix(y.data()), y.tail(group.group->dim())};
}

/// The calls that `move(integrator, y)` makes, and the state it leaves in y.
template <class Move>
DenseStep running(const Method& method, const OptionValues& options, const Scenario& s, Move move) {
    ScriptedSystem system(s.group.group, s.script);
    const auto integrator = method.bind(system, options);
    VecX y = s.y;
    if (const Status status = move(*integrator, y); status != Status::ok)
        throw std::domain_error(std::string("ends in ") + name(status));
    DenseStep step;
    for (const auto& call : system.calls()) step.stages.push_back({call.t, s.group.matrix(call.q.data()), call.v});
    step.result = dense(s.group, s.t + s.h, y);
    return step;
}

}  // namespace

Scenario scenario(const MatrixGroup& group, std::size_t stages, const Real& magnitude) {
    std::mt19937 generator(5);
    const Eigen::Index n = group.group->dim(), size = group.group->size();
    Scenario s{.group = group, .t = Real(7) / 4, .h = Real(3) / 8 / magnitude, .y = VecX(size + n), .script = {}};
    group.group->identity(s.y.data());
    group.group->append_exp(s.y.data(), random_vector(generator, n).data(), s.y.data());
    s.y.tail(n) = 2 * random_vector(generator, n);
    for (std::size_t i = 0; i < stages; ++i) s.script.push_back(5 * random_vector(generator, n));
    return s;
}

ScriptedStep scripted(const Scenario& s, const OptionValues& options, int order) {
    return {s.group, s.h, dense(s.group, s.t, s.y), s.script, options, order};
}

DenseStep running_step(const Method& method, const OptionValues& options, const Scenario& s) {
    return running(method, options, s,
                   [&](Integrator& integrator, VecX& y) { return integrator.step(s.t, s.h, y.data()); });
}

DenseStep running_attempt(const Method& method, const OptionValues& options, const Scenario& s) {
    VecX error(2 * s.group.group->dim());
    DenseStep step = running(method, options, s, [&](Integrator& integrator, VecX& y) {
        const Status status = integrator.start(s.t, s.y.data());
        return status == Status::ok ? integrator.attempt(s.t, s.h, s.y.data(), y.data(), error.data()) : status;
    });
    step.error = error;
    return step;
}

Real distance(const DensePoint& a, const DensePoint& b) {
    if (!isfinite(Real(a.t - b.t + (a.q - b.q).sum() + (a.v - b.v).sum())))
        return std::numeric_limits<Real>::infinity();
    return max(Real(abs(Real(a.t - b.t))), max((a.q - b.q).cwiseAbs().maxCoeff(), (a.v - b.v).cwiseAbs().maxCoeff()));
}

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
