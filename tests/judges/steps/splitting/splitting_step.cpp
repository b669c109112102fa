// SPDX-License-Identifier: BSD-3-Clause
//
// Splitting methods: which kicks and drifts a step makes is seen on a system that records them; these satisfy the order
// conditions, and a step of bodies is their composition, with the closed form of the free rotation.
#include <stdexcept>

#include "mechanics/free_body/free_rotation.hpp"
#include "tests/judges/steps/recorded_steps.hpp"
#include "tests/judges/steps/splitting/splitting_conditions.hpp"
#include "tests/judges/steps/step_checks.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

namespace {

/// One body of unit mass and moments on R^6, which records when it is kicked and pushes at one kick only.
class KickedBody final : public System {
  public:
    explicit KickedBody(int pushed = -1) : System(std::make_shared<AdditiveGroup>(6)), pushed_(pushed) {}
    Status accelerations(const Real&, const Real*, const Real*, Real*, Real*) override {
        throw std::domain_error("a splitting method solves the dynamics");
    }
    void conservative_force(const Real& t, const Real*, Real* f) const override {
        std::fill_n(f, 6, Real(static_cast<int>(times.size()) == pushed_ ? 1 : 0));
        times.push_back(t);
    }
    int bodies() const override { return 1; }

    mutable std::vector<Real> times;

  private:
    int pushed_;
};

struct Composition {
    std::vector<Real> kicks, drifts;
};

void take_step(const Method& method, KickedBody& body, VecX& y) {
    if (method.bind(body, {})->step(0, 1, y.data()) != Status::ok) throw std::domain_error("the step fails");
}

/// Flows of length zero do not show, and need not.
Composition observed(const Method& method) {
    Composition found;
    KickedBody all;
    VecX y = VecX::Zero(12);
    take_step(method, all, y);
    for (std::size_t i = 0; i < all.times.size(); ++i) {
        KickedBody one(static_cast<int>(i));
        y.setZero();
        take_step(method, one, y);
        found.kicks.push_back(y[6]);
        if (i > 0) found.drifts.push_back(all.times[i] - all.times[i - 1]);
    }
    if (all.times.front() > 0) {  // it begins and ends with a drift
        found.kicks.insert(found.kicks.begin(), 0), found.kicks.push_back(0);
        found.drifts.insert(found.drifts.begin(), all.times.front()), found.drifts.push_back(1 - all.times.back());
    }
    return found;
}

/// A state of bodies without joints, moved by the flows.
struct SplitMotion {
    System& system;
    std::vector<Mat3> J;
    std::vector<Real> y;
    Real t;

    void kick(RecordedRun& run, const Real& b_h) {
        VecX f(system.velocities());
        system.applied_force(t, y.data(), std::vector<Real>(y.size()).data(), f.data());
        MatX rates = f;
        run.solve_mass(Eigen::Map<const VecX>(y.data(), system.group().size()), rates);
        Eigen::Map<VecX>(system.v(y.data()), f.size()) += b_h * rates.col(0);
    }
    /// In the coordinates of reports, whatever the formulation.
    void drift(const Real& a_h, bool in_space) {
        std::vector<BodyState> bodies(J.size());
        system.read(y.data(), bodies.data());
        for (std::size_t i = 0; i < J.size(); ++i) {
            const FreeRotation turned = free_rotation(J[i], bodies[i].R, bodies[i].omega, a_h);
            if (in_space) bodies[i].x += a_h * bodies[i].v;
            bodies[i].R = turned.R, bodies[i].omega = turned.omega;
        }
        system.write(bodies.data(), y.data());
        t += a_h;
    }
};

Objection composition_objection(const Method& method, const Composition& flows, const Model& model,
                                const std::string& formulation) {
    const Real h = Real(1) / 64;
    RecordedRun run(method, {}, model, formulation, h, 1);
    System& system = run.system();
    const Eigen::Index block = system.mass_block();
    MatX blocks(block, system.velocities());
    const RecordedState &before = run.states[0], &after = run.states[1];
    system.mass(before.q.data(), blocks.data());
    SplitMotion motion{system, {}, std::vector<Real>(before.q.begin(), before.q.end()), before.t};
    motion.y.insert(motion.y.end(), before.v.begin(), before.v.end());
    for (Eigen::Index i = 0; i < blocks.cols(); i += block)
        motion.J.push_back(blocks.block<3, 3>(block - 3, i + block - 3));
    for (std::size_t i = 0; i < flows.kicks.size(); ++i) {
        if (i > 0) motion.drift(flows.drifts[i - 1] * h, block == 6);
        motion.kick(run, flows.kicks[i] * h);
    }
    const Eigen::Map<const VecX> y(motion.y.data(), static_cast<Eigen::Index>(motion.y.size()));
    Violations found;
    found.see("q+ of the composition", run.bodies.increment(y.head(before.q.size()), after.q));
    found.see("v+ of the composition", after.v - y.tail(before.v.size()));
    return found.objection(1000 * epsilon * max(Real(1), after.v.cwiseAbs().maxCoeff()));
}

Objection splitting_objection(const Method& method) {
    const Composition flows = observed(method);
    const int order = splitting_order(flows.kicks, flows.drifts), declared = method.description.order.configuration;
    if (order != declared)
        return "a composition of order " + std::to_string(order) + ", not " + std::to_string(declared);
    for (const char* name :
         {"forced_heavy_top", "asymmetric_heavy_top", "lagrange_top", "forced_free_body", "free_top"})
        for (const std::string& formulation : models::applicable(models::standard(name))) {
            const Model model = models::standard(name);
            if (!stepping::runs_on(method, model, formulation)) continue;
            const Objection objection = composition_objection(method, flows, model, formulation);
            if (!objection.empty()) return objection + " on " + name + " as " + formulation;
        }
    return "";
}

}  // namespace

KREISEL_STEP_CHECK("splitting/", splitting_objection,
                   "its order conditions, those of composed flows, are checked here");

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
