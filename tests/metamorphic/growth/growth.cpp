// SPDX-License-Identifier: BSD-3-Clause
#include "tests/metamorphic/growth/growth.hpp"

#include <map>
#include <stdexcept>
#include <tuple>

#include "lie/so3.hpp"
#include "tests/metamorphic/models/motion.hpp"
#include "tests/metamorphic/models/named_models.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {
namespace metamorphic {

using namespace growing;

namespace {

/// Far above round-off, and its square far below it (in double, by four digits).
const Real small = Real(1) / Real(1L << (KREISEL_QUAD ? 60 : 40));

/// A direction without symmetry, different for each body.
Vec3 direction(std::size_t body) {
    const auto i = static_cast<int>(body);
    return Vec3(3 + i, (i % 2 == 0 ? 2 : -5), 6 - 2 * i).normalized();
}

Model perturbed(Model model, Cause cause, const Real& size) {
    for (std::size_t i = 0; i < model.bodies.size(); ++i) {
        BodyState& s = model.bodies[i].start;
        const Vec3 change = size * direction(i);
        switch (cause) {
            case of_position:
                s.x += change;
                break;
            case of_rotation:
                s.R = s.R * SO3::exp(change);
                break;
            case of_velocity:
                s.v += change;
                break;
            default:
                s.omega += change;
                break;
        }
    }
    return model;
}

std::array<double, effects> differences(const Outcome& a, const Outcome& b) {
    std::array<double, effects> worst{};
    const auto see = [&](Effect effect, const Real& difference) {
        worst[effect] = std::max(worst[effect], to_double(difference / small));
    };
    for (std::size_t i = 0; i < a.bodies.size(); ++i) {
        const BodyState &s = a.bodies[i], &r = b.bodies[i];
        see(on_position, (s.x - r.x).norm()), see(on_rotation, (s.R - r.R).norm());
        see(on_velocity, (s.v - r.v).norm()), see(on_omega, (s.omega - r.omega).norm());
    }
    for (std::size_t i = 0; i < a.totals.size(); ++i) {
        see(on_force, (a.totals[i].force - b.totals[i].force).norm());
        see(on_torque, (a.totals[i].torque - b.totals[i].torque).norm());
    }
    for (std::size_t j = 0; j < a.joints.size(); ++j)
        for (const std::size_t side : {0u, 1u}) {
            see(on_force, (a.joints[j][side].force - b.joints[j][side].force).norm());
            see(on_torque, (a.joints[j][side].torque - b.joints[j][side].torque).norm());
        }
    return worst;
}

Growth measured(const Model& model, const Span& span, bool projected) {
    const Combination standard{"rkmk/rk4", "SO3xR3", projected ? "position_velocity" : "none"};
    const Outcome base = run(model, standard, span);
    if (!base.failure.empty()) throw std::runtime_error("no growth: " + base.failure);
    Growth growth{};
    for (const Cause cause : {of_position, of_rotation, of_velocity, of_omega}) {
        const Outcome other = run(perturbed(model, cause, small), standard, span);
        if (!other.failure.empty()) throw std::runtime_error("no growth: " + other.failure);
        const auto change = differences(base, other);
        for (std::size_t effect = 0; effect < effects; ++effect) growth[effect][cause] = change[effect];
    }
    return growth;
}

}  // namespace

}  // namespace metamorphic
}  // namespace KREISEL_PRECISION

namespace growing {

const Growth& growth(const std::string& model, double h, int steps, bool projected) {
    static std::map<std::tuple<std::string, int, bool>, Growth> known;
    const auto key = std::make_tuple(model, steps, projected);
    const auto found = known.find(key);
    if (found != known.end()) return found->second;
    const Model& start = metamorphic::named_model(model).model;
    return known[key] = metamorphic::measured(start, {Real(h), steps}, projected);
}

}  // namespace growing
}  // namespace kreisel
