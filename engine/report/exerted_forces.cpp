// SPDX-License-Identifier: BSD-3-Clause
#include "engine/report/exerted_forces.hpp"

#include <map>
#include <span>
#include <type_traits>

namespace kreisel {
inline namespace KREISEL_PRECISION {

namespace {

/// The body on which a force is looked at: its second, or its first where the second is the ground.
template <class Force>
int seen_on(const Force& force) {
    return force.second == ground ? force.first : force.second;
}

template <class Force>
Vec3 point_of_second(const Force& force) {
    if constexpr (requires { force.r_second; })
        return force.r_second;
    else
        return Vec3::Zero();
}

/// Whether its moment about its point of the second body may be other than 0.
template <class Force>
bool may_twist(const Force& force) {
    return force.centre_on(force.second) == nullptr;
}

class Bodies {
  public:
    explicit Bodies(std::span<const BodyState> states) : states_(states) {}
    Motion operator()(int body) const {
        if (body == ground) return {};
        const BodyState& s = states_[static_cast<std::size_t>(body)];
        return {s.x, s.R, s.R.transpose() * s.v, s.omega};
    }

  private:
    std::span<const BodyState> states_;
};

/// The wrench on the second body in space axes, its torque about the point of the second body.
template <class Force>
Wrench wrench_on_second(const Force& force, const Real& t, const Bodies& motion, const Real& theta) {
    Wrench seen;
    const auto push = [&](int body, const Wrench& wrench) {
        if (body != seen_on(force)) return;
        const Motion on = motion(body);
        const Vec3 arm = motion(force.second).point(point_of_second(force)) - on.x, F = on.R * wrench.force;
        const Real sign = body == force.second ? 1 : -1;
        seen = {sign * F, sign * (on.R * wrench.torque - arm.cross(F))};
    };
    force.act(
        t, motion, [&](const auto&) { return theta; }, push);
    return seen;
}

void add_columns(const std::string& name, const char* unit, std::vector<Column>& all) {
    for (int k = 1; k <= 3; ++k) all.push_back({name + "." + std::to_string(k), unit});
}

}  // namespace

std::vector<std::string> names_of_forces(const Model& model) {
    std::vector<std::string> names;
    std::map<std::string, int> used;
    each_force_between(model, [&](const auto& force, std::size_t) {
        const std::string name =
            std::string(force.type) + "." + model.name_of(force.first) + "-" + model.name_of(force.second);
        const int number = ++used[name];
        names.push_back(number == 1 ? name : name + "-" + std::to_string(number));
    });
    return names;
}

std::vector<Column> ExertedForces::columns() const {
    std::vector<Column> all;
    std::size_t next = 0;
    const std::vector<std::string> names = names_of_forces(model_);
    each_force_between(model_, [&](const auto& force, std::size_t) {
        const std::string name = "exerted." + names[next++];
        if (force.may_push(seen_on(force))) add_columns(name + ".force", "N", all);
        if (may_twist(force)) add_columns(name + ".torque", "N m", all);
    });
    return all;
}

void ExertedForces::append_values(const Real& t, const MotionState& now, std::vector<Real>& row) const {
    const Bodies motion(now.bodies);
    each_force_between(model_, [&](const auto& force, std::size_t i) {
        Real theta = 0;
        if constexpr (std::is_same_v<decltype(force), const TorsionSpring&>) theta = now.angles[i];
        const Wrench wrench = wrench_on_second(force, t, motion, theta);
        if (force.may_push(seen_on(force))) row.insert(row.end(), wrench.force.begin(), wrench.force.end());
        if (may_twist(force)) row.insert(row.end(), wrench.torque.begin(), wrench.torque.end());
    });
}

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
