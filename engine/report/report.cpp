// SPDX-License-Identifier: BSD-3-Clause
#include "engine/report/report.hpp"

#include <map>

#include "lie/so3.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

namespace {

Vec3 vector(const std::array<Number, 3>& n) { return {from_number(n[0]), from_number(n[1]), from_number(n[2])}; }

}  // namespace

std::array<Number, 3> to_numbers(const Vec3& v) { return {to_number(v[0]), to_number(v[1]), to_number(v[2])}; }

Number to_number(const Real& x) { return {to_double(x), to_text(x)}; }
Real from_number(const Number& x) { return from_text(x.text); }

ConstraintSummary to_summary(const ConstraintRank& rank) {
    ConstraintSummary summary{.rows = rank.rows,
                              .rank = rank.rank,
                              .directions = 0,
                              .redundant = rank.redundant,
                              .condition = {},
                              .least_norm = {}};
    if (rank.condition) summary.condition = to_double(*rank.condition);
    return summary;
}

ReportedState to_report(const Real& t, const std::vector<BodyState>& states, const Model& model,
                        const std::vector<Real>& multipliers, const std::vector<SpringAngle>& springs) {
    ReportedState report{to_number(t), {}, {}, {}, {}};
    for (std::size_t i = 0; i < states.size(); ++i) {
        const BodyState& s = states[i];
        ReportedBody body{model.bodies[i].name, to_numbers(s.x), to_numbers(s.v), to_numbers(s.omega), {}};
        for (int j = 0; j < 3; ++j)
            for (int k = 0; k < 3; ++k) body.R[static_cast<std::size_t>(3 * j + k)] = to_number(s.R(j, k));
        report.bodies.push_back(body);
    }
    for (const Real& lambda : multipliers) report.multipliers.push_back(to_number(lambda));
    for (const SpringAngle& spring : springs) {
        report.theta.push_back(to_number(spring.theta));
        report.turns.push_back(spring.turns);
    }
    return report;
}

std::vector<std::string> names_of_torsion_springs(const Model& model) {
    std::vector<std::string> names;
    std::map<std::string, int> used;
    for (const TorsionSpring& spring : model.torsion_springs) {
        const std::string pair = model.name_of(spring.first) + "-" + model.name_of(spring.second);
        const int number = ++used[pair];
        names.push_back(number == 1 ? pair : pair + "-" + std::to_string(number));
    }
    return names;
}

std::vector<BodyState> from_report(const ReportedState& report) {
    std::vector<BodyState> states;
    for (const ReportedBody& body : report.bodies) {
        BodyState s{vector(body.x), Mat3::Identity(), vector(body.v), vector(body.omega)};
        for (int j = 0; j < 3; ++j)
            for (int k = 0; k < 3; ++k) s.R(j, k) = from_number(body.R[static_cast<std::size_t>(3 * j + k)]);
        states.push_back(s);
    }
    return states;
}

Distance distance(const std::vector<BodyState>& a, const std::vector<BodyState>& b) {
    Distance sum;
    for (std::size_t i = 0; i < a.size(); ++i) {
        sum.position += (a[i].x - b[i].x).squaredNorm();
        sum.velocity += (a[i].v - b[i].v).squaredNorm();
        sum.omega += (a[i].omega - b[i].omega).squaredNorm();
        const Mat3 relative = b[i].R.transpose() * a[i].R;
        const bool rotation = SO3::orthogonality_defect(relative) <= Real(1) / 10;
        sum.rotation += rotation ? Real(SO3::log(relative).squaredNorm()) : std::numeric_limits<Real>::quiet_NaN();
    }
    return {sqrt(sum.position), sqrt(sum.rotation), sqrt(sum.velocity), sqrt(sum.omega)};
}

Distance largest(const Distance& a, const Distance& b) {
    const auto larger = [](const Real& x, const Real& y) { return x > y || !isfinite(x) ? x : y; };
    return {larger(a.position, b.position), larger(a.rotation, b.rotation), larger(a.velocity, b.velocity),
            larger(a.omega, b.omega)};
}

Real norm_of_difference(const std::vector<Real>& a, const std::vector<Real>& b) {
    Real sum = 0;
    for (std::size_t i = 0; i < a.size(); ++i) sum += (a[i] - b[i]) * (a[i] - b[i]);
    return sqrt(sum);
}

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
