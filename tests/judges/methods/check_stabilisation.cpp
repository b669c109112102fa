// SPDX-License-Identifier: BSD-3-Clause
//
// What a stabilisation makes of the accelerations, off the constraints: the rows obey C v' = xi - 2 alpha (C v + b) -
// beta^2 Phi, changed by C v' only, and by no more than the joints push. On the constraints nothing changes.
#include "mechanics/step_watcher.hpp"
#include "tests/judges/methods/checks.hpp"
#include "tests/judges/methods/runs.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

using namespace stepping;

namespace {

const Real step = Real(1) / 64;

/// A system, what a stabilisation makes of it, and a state.
struct Stabilised {
    Stabilised(const ProjectionMethod& entry, const Model& model, const std::string& formulation)
        : system(make_system(model, formulation)),
          changed(entry.changed(*system, {{"alpha", 3.0}, {"beta", 5.0}})),
          y(initial_state(*system, model)),
          dv(system->velocities()),
          plain(dv) {
        per_step = dynamic_cast<const StepWatcher*>(changed.get()) != nullptr;
    }

    Real alpha() const { return per_step ? Real(3 / step) : Real(3); }
    Real beta() const { return per_step ? Real(5 / step) : Real(5); }

    /// Both accelerations, within a step.
    Status evaluate() {
        changed->begin_step(0, step, y.data());
        const Status status = changed->evaluate(0, y.data(), system->v(y.data()), dv.data());
        changed->end_step(status, 0, y.data());
        if (status != Status::ok) return status;
        return system->accelerations(0, y.data(), system->v(y.data()), plain.data(), nullptr);
    }
    /// Off the constraints by some thousandths, rotations on their group.
    void disturb() {
        std::vector<Real> u(static_cast<std::size_t>(system->velocities()));
        Real* v = system->v(y.data());
        for (std::size_t i = 0; i < u.size(); ++i) {
            u[i] = sin(Real(7 * static_cast<int>(i) + 2)) / 500;
            v[i] += cos(Real(5 * static_cast<int>(i) + 1)) / 500;
        }
        system->group().append_exp(y.data(), u.data(), y.data());
    }
    /// Of the rows, relative to what is demanded of them.
    Real error_of_rows() const {
        const Real* v = system->v(y.data());
        VecX rows(system->constraints()), expected(rows), r(rows), position = VecX::Zero(rows.size());
        system->apply_jacobian(0, y.data(), dv.data(), rows.data());
        system->acceleration_bias(0, y.data(), v, expected.data());
        system->velocity_residual(0, y.data(), v, r.data());
        system->position_residual(0, y.data(), position.data());
        expected -= 2 * alpha() * r + beta() * beta() * position;
        return (rows - expected).norm() / (1 + expected.norm());
    }
    /// The part of the change of accelerations along motions that the joints allow, relative to it.
    Real error_along_motions() const {
        VecX change = dv - plain, force(change), along(change);
        const Eigen::Index block = system->mass_block();
        MatX blocks(block, change.size());
        system->mass(y.data(), blocks.data());
        for (Eigen::Index i = 0; i < change.size(); i += block)
            force.segment(i, block) = blocks.middleCols(i, block) * change.segment(i, block);
        const VecX zero = VecX::Zero(system->constraints());
        if (system->solve_kkt(0, y.data(), force.data(), zero.data(), along.data(), nullptr) != Status::ok) return 1;
        return along.norm() / (1 + change.norm());
    }

    std::unique_ptr<System> system, changed;
    std::vector<Real> y;
    VecX dv, plain;
    bool per_step = false;
};

Objection objection_to(const ProjectionMethod& entry, const Model& model, const std::string& formulation) {
    const Real most = 1000000 * epsilon;
    Stabilised run(entry, model, formulation);
    if (run.evaluate() != Status::ok) return "fails on the constraints";
    if (!((run.dv - run.plain).norm() <= most * (1 + run.plain.norm()))) return "acts on the constraints";
    if (run.system->constraints() == 0) return "";
    run.disturb();
    const long before = run.system->evaluations();
    if (run.evaluate() != Status::ok) return "fails off the constraints";
    if (run.system->evaluations() - before != 1) return "does not count its solve";
    if (!(run.error_of_rows() <= most)) return "the rows obey other equations";
    if (!(run.error_along_motions() <= most)) return "pushes along motions that the joints allow";
    *run.system->v(run.y.data()) = std::numeric_limits<Real>::quiet_NaN();
    return run.evaluate() == Status::ok ? "accepts NaN in the velocities" : "";
}

}  // namespace

Objection stabilisation_objection(const ProjectionMethod& entry) {
    if (!entry.stabilises()) return "";
    for (const models::Named& named : models::for_methods())
        for (const std::string& formulation : models::applicable(named.model)) {
            if (KREISEL_QUAD && formulation != "SE3") continue;  // slow
            const Objection objection = objection_to(entry, named.model, formulation);
            if (!objection.empty()) return objection + " (" + named.name + " as " + formulation + ")";
        }
    return "";
}

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
