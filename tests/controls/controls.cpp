// SPDX-License-Identifier: BSD-3-Clause
#include "tests/controls/controls.hpp"

#include "mechanics/system.hpp"
#include "methods/commutator_free/commutator_free.hpp"
#include "methods/projection/baumgarte_system.hpp"
#include "methods/rkmk/few_commutators.hpp"
#include "tests/controls/broken.hpp"
#include "tests/controls/splitting.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

namespace {

const Tableau& tableau_of(const std::string& name) {
    const Scheme& scheme = *method(name).factory.scheme;
    if (const auto* products = scheme.as<CrouchGrossmanScheme>()) return products->tableau;
    return scheme.as<MuntheKaasScheme>()->tableau;
}

template <class Family>
const Family& scheme_of(const std::string& name) {
    return *method(name).factory.scheme->as<Family>();
}

/// A control that claims to be the registered method `original`.
Control control(const std::string& original, const std::string& fault, Factory factory, int true_order,
                std::vector<Check> caught_by) {
    MethodDescription claim = method(original).description;
    claim.name = "control/" + original.substr(original.find('/') + 1) + "_" + fault;
    claim.summary = "broken on purpose: " + original + ", " + fault;
    claim.options = {};
    claim.estimate = 0;  // the broken steps make no attempts
    return {.method = {.description = claim, .factory = std::move(factory), .file = __FILE__},
            .true_order = true_order,
            .caught_by = std::move(caught_by)};
}

Control rkmk_control(const std::string& original, const std::string& fault, MuntheKaasFault broken, int true_order,
                     std::vector<Check> caught_by = {Check::one_step}) {
    return control(original, fault, broken_rkmk(tableau_of(original), broken), true_order, std::move(caught_by));
}

Control crouch_grossman_control(const std::string& original, const std::string& fault, CrouchGrossmanFault broken,
                                int true_order) {
    return control(original, fault, broken_crouch_grossman(tableau_of(original), broken), true_order,
                   {Check::one_step});
}

std::vector<Control> faults_of_dexpinv_and_nodes() {
    using enum MuntheKaasFault::Dexpinv;
    using Nodes = MuntheKaasFault::Nodes;
    return {rkmk_control("rkmk/rk4", "without_dexpinv", {.dexpinv = absent}, 2),
            rkmk_control("rkmk/rk4", "wrong_sign_of_dexpinv", {.dexpinv = wrong_sign}, 2),
            rkmk_control("rkmk/rk4", "stages_at_old_time", {.nodes = Nodes::start}, 1),
            rkmk_control("rkmk/rk4", "stages_at_mid_time", {.nodes = Nodes::middle}, 2),
            rkmk_control("rkmk/kutta3", "without_dexpinv", {.dexpinv = absent}, 2),
            // Order 2 needs no dexpinv: only the comparison of one step detects it.
            rkmk_control("rkmk/midpoint", "without_dexpinv", {.dexpinv = absent}, 2)};
}

std::vector<Control> faults_of_products() {
    return {
        crouch_grossman_control("crouch_grossman/cg3a", "reversed_final_factors", {.reversed_final_factors = true}, 2),
        // Two different branches at one node take four nodes: order 3 does not involve the stage products.
        crouch_grossman_control("crouch_grossman/cg3a", "reversed_stage_factors", {.reversed_stage_factors = true}, 3),
        crouch_grossman_control("crouch_grossman/cg4a", "reversed_stage_factors", {.reversed_stage_factors = true}, 3),
        crouch_grossman_control("crouch_grossman/cg4a", "reversed_rows", {.reversed_rows = true}, 2)};
}

std::vector<Control> faults_of_coefficients() {
    // Heun's a_21 = 1 off by 1e-6. At any h in use h^2 is larger than 1e-6 h, so no slope detects it.
    Tableau off = tableau_of("rkmk/heun");
    off.a[1][0] = {1000001, 1000000};
    // The weights of rk4 from the inside to the outside: sum b = 1 and sum b c = 1/2 hold, sum b c^2 = 1/3 does not.
    Tableau exchanged = tableau_of("rkmk/rk4");
    exchanged.b = {{1, 3}, {1, 6}, {1, 6}, {1, 3}};
    return {
        control("rkmk/heun", "declares_coefficient_off", broken_rkmk(off, {}), 2, {Check::order_conditions}),
        control("rkmk/heun", "uses_coefficient_off", broken_rkmk(tableau_of("rkmk/heun"), {}, off), 2,
                {Check::one_step}),
        control("rkmk/rk4", "wrong_weights", broken_rkmk(tableau_of("rkmk/rk4"), {}, exchanged), 2, {Check::one_step})};
}

std::vector<Control> faults_of_conduct() {
    Control asymmetric =
        control("rkmk/heun", "claims_symmetry", broken_rkmk(tableau_of("rkmk/heun"), {}), 2, {Check::reversal});
    asymmetric.method.description.preserves = {{Property::symmetric, Domain::autonomous}};
    return {// First same as last, which is right as long as nobody starts elsewhere or projects.
            rkmk_control("rkmk/rk4", "keeps_stale_slope", {.stale_slope = true}, 4, {Check::history}),
            rkmk_control("rkmk/rk4", "hides_a_solve", {.uncounted_solve = true}, 4, {Check::solves}),
            rkmk_control("rkmk/rk4", "swallows_nan", {.deaf = true}, 4, {Check::injection}),
            rkmk_control("rkmk/heun", "turns_space", {.turns_space = true}, 2, {Check::equivariance}),
            control("rkmk/implicit_midpoint", "unconverged", unconverged_midpoint(), 2,
                    {Check::one_step, Check::convergence, Check::reversal}),
            control("symmetric_projection/midpoint", "projected_at_the_end_alone",
                    projected_at_the_end("rkmk/implicit_midpoint"), 2, {Check::one_step, Check::reversal}),
            asymmetric};
}

/// A sound method that claims what it does not do.
Control claimant(const std::string& original, Factory factory, Property property, Domain domain, Check caught_by) {
    const int order = method(original).description.order.configuration;
    Control made = control(original, std::string("claims_") + name(caught_by), std::move(factory), order, {caught_by});
    made.method.description.preserves = {{property, domain}};
    return made;
}

Factory under_standard_options(const Factory& inner) {
    Factory factory = inner;
    factory.make = [inner](System& system, const OptionValues&, const MethodDescription& declared) {
        return inner.make(system, with_defaults({}, inner.options), declared);
    };
    return factory;
}

std::vector<Control> faults_of_claims() {
    const Factory rk4 = broken_rkmk(tableau_of("rkmk/rk4"), {});
    // Between bodies that gravity turns, a force at the old pose; elsewhere the method is sound.
    Control stale{
        .method = splitting_verlet(true), .true_order = 1, .caught_by = {Check::symplecticity, Check::bounded_energy}};
    // Its energy grows between bodies: what is symplectic there keeps it near.
    Control growing = claimant("rkmk/rk4", rk4, Property::symplectic, Domain::constrained, Check::bounded_energy);
    growing.caught_by.push_back(Check::symplecticity);
    return {growing,
            claimant("rkmk/implicit_midpoint", method("rkmk/implicit_midpoint").factory, Property::symplectic,
                     Domain::free, Check::symplecticity),
            claimant("rkmk/rk4", rk4, Property::symplectic, Domain::potential, Check::symplecticity),
            // In vector spaces it would be, and symmetric it is.
            claimant("variational/lie_newmark", under_standard_options(method("variational/lie_newmark").factory),
                     Property::symplectic, Domain::free, Check::symplecticity),
            control("variational/rattlie", "with_momentum_of_the_stage", rattlie_with_stage_momentum(), 2,
                    {Check::one_step, Check::symplecticity, Check::momentum}),
            claimant("rkmk/rk4", rk4, Property::momentum, Domain::free, Check::momentum),
            claimant("rkmk/rk4", rk4, Property::energy, Domain::free, Check::energy),
            claimant("rkmk/rk4", rk4, Property::constraints, Domain::constrained, Check::constraints), stale};
}

Control pair_control(const std::string& fault, PairFault broken, Check caught_by) {
    Control made{.method = broken_pair("control/pair_" + fault, broken), .true_order = 3, .caught_by = {caught_by}};
    made.method.description.summary = "broken on purpose: embedded pair, " + fault;
    return made;
}

std::vector<Control> faults_of_attempts() {
    Control optimist = pair_control("overrates_its_estimate", {}, Check::order_conditions);
    optimist.method.description.estimate = 4;
    return {pair_control("doubles_its_estimate", {.doubled_error = true}, Check::one_step),
            pair_control("keeps_a_rejected_slope", {.keeps_rejected = true}, Check::attempts),
            pair_control("ignores_a_projection", {.ignores_projection = true}, Check::attempts), optimist};
}

std::vector<Control> faults_of_families() {
    CommutatorFreeScheme swapped = scheme_of<CommutatorFreeScheme>("commutator_free/cf4");
    const CommutatorFreeScheme cf4 = swapped;
    std::swap(swapped.result.factors[0], swapped.result.factors[1]);
    FewCommutatorsScheme negated = scheme_of<FewCommutatorsScheme>("rkmk/mk4");
    const FewCommutatorsScheme mk4 = negated;
    for (BracketSum* row : {&negated.stages[2], &negated.result})
        for (BracketTerm& term : row->brackets) std::swap(term.left, term.right);
    const auto claiming = [](Factory running, const auto& declared) {
        running.scheme = Scheme(declared);
        return running;
    };
    return {
        control("commutator_free/cf4", "swapped_final_factors", claiming(commutator_free(swapped), cf4), 2,
                {Check::one_step}),
        control("rkmk/mk4", "wrong_sign_of_brackets", claiming(few_commutators(negated), mk4), 2, {Check::one_step}),
        // Its rows have order 2, and h^3 next, which their extrapolation leaves.
        control("extrapolation/midpoint4", "with_one_sided_base", one_sided_extrapolation(), 3, {Check::one_step})};
}

std::vector<Control> make_controls() {
    std::vector<Control> all;
    for (const auto make : {faults_of_dexpinv_and_nodes, faults_of_products, faults_of_coefficients, faults_of_conduct,
                            faults_of_claims, faults_of_attempts, faults_of_families})
        for (const Control& one : make()) all.push_back(one);
    return all;
}

/// Does what `actual` does, and claims to be `claimed`.
ProjectionMethod impostor(const std::string& claimed, const std::string& actual) {
    ProjectionMethod entry = projection(claimed);
    entry.description.name = "control/" + claimed + "_that_is_" + actual;
    entry.make = [make = projection(actual).make](System& system, const OptionValues&) { return make(system, {}); };
    return entry;
}

/// Treats non-finite residuals as converged.
class DeafProjection final : public Projection {
  public:
    DeafProjection(std::unique_ptr<Projection> inner, int size)
        : inner_(std::move(inner)), before_(static_cast<std::size_t>(size)) {}
    Status project(const Real& t, Real* y) override {
        std::copy_n(y, before_.size(), before_.begin());
        const Status status = inner_->project(t, y);
        if (status != Status::non_finite) return status;
        std::copy(before_.begin(), before_.end(), y);
        return Status::ok;
    }

  private:
    std::unique_ptr<Projection> inner_;
    std::vector<Real> before_;
};

ProjectionMethod deaf(const std::string& claimed) {
    ProjectionMethod entry = projection(claimed);
    entry.description.name = "control/" + claimed + "_swallows_nan";
    entry.make = [inner = entry.make](System& system, const OptionValues& options) {
        return std::make_unique<DeafProjection>(inner(system, options), system.state_group().size());
    };
    return entry;
}

/// A registered projection under another name and another making.
ProjectionMethod remade(const std::string& claimed, const std::string& fault, MakeProjection make) {
    ProjectionMethod entry = projection(claimed);
    entry.description.name = "control/" + claimed + "_" + fault;
    entry.make = std::move(make);
    return entry;
}

/// Goes half of the way.
class HalfProjection final : public Projection {
  public:
    HalfProjection(System& system, std::unique_ptr<Projection> inner) : system_(system), inner_(std::move(inner)) {}
    Status project(const Real& t, Real* y) override {
        std::vector<Real> nearest(y, y + system_.state_group().size());
        const Status status = inner_->project(t, nearest.data());
        if (status != Status::ok) return status;
        const auto places = static_cast<std::size_t>(system_.group().size() / system_.bodies());
        for (std::size_t i = 0; i < nearest.size(); ++i) {
            const bool rotation = i < static_cast<std::size_t>(system_.group().size()) && i % places >= 3;
            y[i] = rotation ? nearest[i] : Real((y[i] + nearest[i]) / 2);
        }
        return status;
    }

  private:
    System& system_;
    std::unique_ptr<Projection> inner_;
};

/// Counts steps that are not taken.
class ObstinateProjection final : public Projection {
  public:
    explicit ObstinateProjection(std::unique_ptr<Projection> inner) : inner_(std::move(inner)) {}
    void start() override { inner_->start(); }
    Status project(const Real& t, Real* y) override { return inner_->project(t, y); }

  private:
    std::unique_ptr<Projection> inner_;
};

std::vector<ProjectionControl> faults_of_options() {
    const MakeProjection make = projection("position").make;
    return {
        {remade("position", "that_goes_half_the_way",
                [make](System& system, const OptionValues& options) {
                    return std::make_unique<HalfProjection>(system, make(system, options));
                }),
         Check::iterations},
        {remade("position", "at_every_step", [make](System& system, const OptionValues&) { return make(system, {}); }),
         Check::every},
        {remade("position", "that_counts_rejected_steps",
                [make](System& system, const OptionValues& options) {
                    return std::make_unique<ObstinateProjection>(make(system, options));
                }),
         Check::every}};
}

/// Feedback with alpha and beta as `fault` makes them.
ProjectionControl feedback_control(const std::string& name, std::function<Feedback(Feedback)> fault) {
    ProjectionMethod entry = projection("baumgarte");
    entry.description.name = "control/baumgarte_" + name;
    entry.stabilisation.change = [fault](System& system, const OptionValues& options) {
        return with_feedback(system, fault(feedback_of(options)), false);
    };
    return {entry, Check::stabilisation};
}

std::vector<ProjectionControl> faults_of_feedback() {
    return {feedback_control("with_wrong_sign",
                             [](Feedback f) {
                                 return Feedback{-f.alpha, f.beta};
                             }),
            feedback_control("without_the_2",
                             [](Feedback f) {
                                 return Feedback{f.alpha / 2, f.beta};
                             }),
            feedback_control("without_the_square", [](Feedback f) {
                return Feedback{f.alpha, sqrt(f.beta)};
            })};
}

std::vector<ProjectionControl> make_projection_controls() {
    std::vector<ProjectionControl> all = {{impostor("position_velocity", "position"), Check::projection},
                                          {impostor("position_velocity", "velocity"), Check::projection},
                                          {impostor("coordinate_partitioning", "velocity"), Check::projection},
                                          {deaf("position_velocity"), Check::injection}};
    for (const auto make : {faults_of_options, faults_of_feedback})
        for (const ProjectionControl& one : make()) all.push_back(one);
    return all;
}

}  // namespace

const std::vector<ProjectionControl>& projection_controls() {
    static const std::vector<ProjectionControl> all = make_projection_controls();
    return all;
}

const std::vector<Control>& controls() {
    static const std::vector<Control> all = make_controls();
    return all;
}

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
