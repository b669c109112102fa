// SPDX-License-Identifier: BSD-3-Clause
#include "tests/metamorphic/models/motion.hpp"

#include <utility>

#include "mechanics/formulation.hpp"
#include "mechanics/joints/joint_rows.hpp"
#include "mechanics/model/scales.hpp"
#include "methods/simulation.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {
namespace metamorphic {

namespace {

SimulationParts simulation_parts(const Model& model, const Combination& combination, const Bench& bench) {
    auto system = bench.system(model, combination.formulation);
    auto changed = projection(combination.projection).changed(*system, combination.projection_options);
    auto integrator = bench.integrator(changed ? *changed : *system, combination);
    auto projected = bench.projection(*system, combination);
    return {.system = std::move(system),
            .integrator = std::move(integrator),
            .projection = std::move(projected),
            .changed = std::move(changed)};
}

/// A run in progress.
class Run {
  public:
    Run(const Model& model, const Combination& combination, const Bench& bench)
        : model_(model),
          simulation_(simulation_parts(model, combination, bench), model),
          system_(simulation_.system()),
          lambda_(static_cast<std::size_t>(system_.constraints())) {
        outcome_.bodies.resize(model.bodies.size());
        observe();
    }

    Outcome advance(const Span& span) {
        Status status = simulation_.restart();
        for (int i = 0; i < span.steps && status == Status::ok; ++i) {
            if (span.restart && 2 * i == span.steps) status = simulation_.restart();
            if (status == Status::ok) status = simulation_.step(span.h, span.h * (i + 1));
            observe();
        }
        if (status == Status::ok) status = find_multipliers(simulation_.time());
        if (status != Status::ok) outcome_.failure = name(status);
        if (status == Status::ok) act(simulation_.time());
        std::vector<SpringAngle> springs(static_cast<std::size_t>(system_.torsion_springs()));
        system_.read_angles(simulation_.q(), springs.data());
        std::vector<Real> angles;
        for (const SpringAngle& spring : springs) angles.push_back(spring.theta);
        for (const FirstIntegral& integral : system_.integrals())
            outcome_.integrals[integral.name] = integral.value({outcome_.bodies, angles});
        return std::move(outcome_);
    }

  private:
    void observe() {
        system_.read(simulation_.q(), outcome_.bodies.data());
        Sizes& sizes = outcome_.sizes;
        for (const BodyState& s : outcome_.bodies) {
            sizes.x = max(sizes.x, Real(s.x.norm())), sizes.v = max(sizes.v, Real(s.v.norm()));
            sizes.omega = max(sizes.omega, Real(s.omega.norm()));
        }
    }

    Status find_multipliers(const Real& t) {
        if (lambda_.empty()) return Status::ok;
        if (const Real* own = simulation_.multipliers()) {
            std::copy_n(own, lambda_.size(), lambda_.begin());
            return Status::ok;
        }
        std::vector<Real> dv(static_cast<std::size_t>(system_.velocities()));
        return system_.accelerations(t, simulation_.q(), simulation_.v(), dv.data(), lambda_.data());
    }

    /// The wrench of each joint on its bodies: minus its part of C^T lambda. Rows without a position level come last.
    void act(const Real& t) {
        outcome_.totals.resize(model_.bodies.size());
        if (lambda_.empty()) return;
        std::size_t position = 0, velocity = static_cast<std::size_t>(system_.position_constraints());
        JointRows rows;
        for (const Joint& joint : model_.joints) {
            write_rows(joint, t, motion_of(outcome_.bodies, joint.first), motion_of(outcome_.bodies, joint.second),
                       rows);
            std::array<Action, 2>& on = outcome_.joints.emplace_back();
            for (int k = 0; k < rows.count; ++k) {
                const Real& lambda = lambda_[k < position_rows_of(joint.type) ? position++ : velocity++];
                push(joint.first, rows.first.col(k), lambda, on[0]);
                push(joint.second, rows.second.col(k), lambda, on[1]);
            }
            finish(joint.first, on[0]), finish(joint.second, on[1]);
        }
    }
    void push(int body, const Vec6& W, const Real& lambda, Action& action) const {
        if (body == ground) return;
        const Mat3& R = outcome_.bodies[static_cast<std::size_t>(body)].R;
        action.add({-lambda * (R * W.head<3>()), -lambda * (R * W.tail<3>())});
    }
    void finish(int body, const Action& action) {
        if (body == ground) return;
        outcome_.totals[static_cast<std::size_t>(body)].add(action);
        outcome_.sizes.force = max(outcome_.sizes.force, Real(action.force.norm()));
        outcome_.sizes.torque = max(outcome_.sizes.torque, Real(action.torque.norm()));
    }

    const Model& model_;
    Simulation simulation_;
    System& system_;
    std::vector<Real> lambda_;
    Outcome outcome_;
};

/// 1/m + |r|^2 / J_min: the inverse mass seen by a force at r.
Real mobility(const Model& model, int body, const Vec3& r) {
    if (body == ground) return 0;
    const Body& it = model.bodies[static_cast<std::size_t>(body)];
    return 1 / it.mass + (it.point ? Real(0) : Real(r.squaredNorm() * it.J.inverse().norm()));
}

Real spin_mobility(const Model& model, int body) {
    return body == ground ? Real(0) : Real(model.bodies[static_cast<std::size_t>(body)].J.inverse().norm());
}

}  // namespace

std::string to_text(const Combination& combination) {
    std::string text = combination.method;
    for (const auto& [option, value] : combination.options)
        if (const std::string* word = std::get_if<std::string>(&value)) text += " " + option + "=" + *word;
    text += ", " + combination.formulation + ", " + combination.projection;
    for (const auto& [option, value] : combination.projection_options)
        if (const std::string* word = std::get_if<std::string>(&value)) text += " " + option + "=" + *word;
    return text;
}

Bench::Bench()
    : system(make_system),
      integrator([](System& bound, const Combination& combination) {
          const Method& entry = method(combination.method);
          return entry.bind(bound, with_defaults(combination.options, entry.description.options));
      }),
      projection([](System& bound, const Combination& combination) {
          const ProjectionMethod& entry = kreisel::projection(combination.projection);
          return entry.make(bound, with_defaults(combination.projection_options, entry.description.options));
      }) {}

Outcome run(const Model& model, const Combination& combination, const Span& span, const Bench& bench) {
    return Run(model, combination, bench).advance(span);
}

Motion motion_of(const std::vector<BodyState>& bodies, int body) {
    if (body == ground) return {};
    const BodyState& s = bodies[static_cast<std::size_t>(body)];
    return {s.x, s.R, s.R.transpose() * s.v, s.omega};
}

namespace {

/// The shortest distance of a mass centre from a joint of its body, 0 where there is none.
Real shortest_arm(const Model& model) {
    Real arm = 0;
    for (const Joint& joint : model.joints)
        for (const auto& [body, r] : {std::pair(joint.first, joint.r_first), std::pair(joint.second, joint.r_second)})
            if (const Real length = r.norm(); body != ground && length > 0) arm = arm > 0 ? min(arm, length) : length;
    return arm;
}

}  // namespace

Real fastest_rate(const Model& model) {
    const auto system = make_system(model, "SO3xR3");
    std::vector<Real> y = initial_state(*system, model), dv(static_cast<std::size_t>(system->velocities()));
    if (system->accelerations(0, y.data(), system->v(y.data()), dv.data(), nullptr) != Status::ok) return 0;
    const Real size = extent(model), arm = shortest_arm(model);
    Real rate = model.gravity.amplitude != 0 ? abs(model.gravity.frequency) : Real(0);
    const auto allow = [&](const Real& other) { rate = max(rate, other); };
    if (arm > 0) allow(sqrt(model.gravity.g.norm() / arm));  // of the pendulum that some pose of it is
    for (std::size_t i = 0; i < model.bodies.size(); ++i) {
        const BodyState& s = model.bodies[i].start;
        allow(s.omega.norm()), allow(s.v.norm() / size);
        allow(sqrt(Vec3(vec3(&dv[6 * i])).norm() / size)), allow(sqrt(Vec3(vec3(&dv[6 * i + 3])).norm()));
    }
    for (const Spring& spring : model.springs) {
        const Real mu = mobility(model, spring.first, spring.r_first) + mobility(model, spring.second, spring.r_second);
        allow(sqrt(spring.stiffness * mu)), allow(spring.damping * mu);
    }
    for (const TorsionSpring& spring : model.torsion_springs) {
        const Real mu = spin_mobility(model, spring.first) + spin_mobility(model, spring.second);
        allow(sqrt(spring.stiffness * mu)), allow(spring.damping * mu);
    }
    for (const Load& load : model.loads) allow(abs(load.frequency));
    for (const Joint& joint : model.joints) {
        allow(abs(joint.frequency)), allow(joint.turn.pace()), allow(joint.shift.pace() / size);
        for (const Prescribed& law : {joint.turn, joint.shift})
            for (const Sinusoid& one : law.sinusoids) allow(abs(one.frequency));
    }
    return rate;
}

}  // namespace metamorphic
}  // namespace KREISEL_PRECISION
}  // namespace kreisel
