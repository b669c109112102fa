// SPDX-License-Identifier: BSD-3-Clause
#include "engine/observers/samples.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

namespace {

void add_columns_of_body(const std::string& body, std::vector<Column>& all) {
    const auto add = [&](const char* quantity, const char* unit) {
        for (int i = 1; i <= 3; ++i) all.push_back({body + "." + quantity + std::to_string(i), unit});
    };
    add("x", "m");
    for (int i = 1; i <= 3; ++i)
        for (int j = 1; j <= 3; ++j) all.push_back({body + ".R" + std::to_string(i) + std::to_string(j), "1"});
    add("v", "m/s");
    add("omega", "rad/s");
}

void append_body(const BodyState& s, std::vector<Real>& row) {
    row.insert(row.end(), {s.x[0], s.x[1], s.x[2]});
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j) row.push_back(s.R(i, j));
    row.insert(row.end(), {s.v[0], s.v[1], s.v[2], s.omega[0], s.omega[1], s.omega[2]});
}

/// The counts of a run up to a sample, by the names that they have in results.
const std::pair<const char*, long Cost::*> work_columns[] = {
    {"cost.evaluations", &Cost::evaluations}, {"cost.exponentials", &Cost::exponentials},
    {"cost.brackets", &Cost::brackets},       {"cost.newton_iterations", &Cost::newton_iterations},
    {"cost.accepted", &Cost::accepted},       {"cost.rejected", &Cost::rejected}};

/// A line of numbers separated by commas; empty where one is not finite.
class SampleLine {
  public:
    void append(const std::string& text) { text_ += (text_.empty() ? "" : ",") + text; }
    void append(const std::vector<Real>& numbers) {
        for (const Real& x : numbers) append(isfinite(x) ? to_text(x) : "");
    }
    const std::string& text() const { return text_; }

  private:
    std::string text_;
};

}  // namespace

Samples::Samples(Sampled sources, SampleSink* sink) : sources_(sources), exerted_(sources.model), sink_(sink) {
    if (sink_) sink_->begin(columns());
}

std::vector<Column> Samples::columns() const {
    std::vector<Column> all = {{"t", "s"}};
    for (const Body& body : sources_.model.bodies) add_columns_of_body(body.name, all);
    for (const std::string& spring : names_of_torsion_springs(sources_.model)) {
        all.push_back({"theta." + spring, "rad"});
        all.push_back({"turns." + spring, "1"});
    }
    for (Column& column : sources_.joint_forces.columns()) all.push_back(std::move(column));
    for (Column& column : exerted_.columns()) all.push_back(std::move(column));
    sources_.step_metrics.add_columns(all);
    sources_.integral_metrics.add_columns(all);
    if (sources_.errors) sources_.errors->add_columns(all);
    if (sources_.work)
        for (const auto& [name, count] : work_columns) all.push_back({name, "1"});
    return all;
}

void Samples::take(Observation& now, const Real* multipliers) {
    std::vector<Real> motion = {now.t()}, measured;
    for (const BodyState& body : now.bodies()) append_body(body, motion);
    for (const SpringAngle& spring : now.springs()) motion.insert(motion.end(), {spring.theta, Real(spring.turns)});
    std::vector<std::string> forces;
    const bool found = sources_.joint_forces.find(now.t(), now.y(), multipliers);
    sources_.joint_forces.append_values(found, forces);
    static const std::vector<Real> unknown;
    if (sources_.errors) sources_.errors->add({now.bodies(), found ? sources_.joint_forces.multipliers() : unknown});
    exerted_.append_values(now.t(), now.motion(), measured);
    sources_.step_metrics.append_values(measured);
    sources_.integral_metrics.append_values(measured);
    if (sources_.errors) sources_.errors->append_values(measured);
    if (sources_.work) {
        const Cost cost = sources_.work();
        for (const auto& [name, count] : work_columns) measured.push_back(Real(cost.*count));
    }
    SampleLine line;
    line.append(motion);
    for (const std::string& text : forces) line.append(text);
    line.append(measured);
    if (sink_) sink_->add(line.text());
}

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
