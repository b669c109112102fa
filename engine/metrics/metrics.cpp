// SPDX-License-Identifier: BSD-3-Clause
#include "engine/metrics/metrics.hpp"

#include <algorithm>

#include "engine/metric_table.hpp"
#include "engine/report/report.hpp"
#include "support/pattern.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

void LineFit::add(const Real& t, const Real& y) {
    ++points_;
    const Real dt = t - t_, dy = y - y_;
    t_ += dt / Real(points_);
    y_ += dy / Real(points_);
    t_t_ += dt * (t - t_);
    t_y_ += dt * (y - y_);
    y_y_ += dy * (y - y_);
}

Real LineFit::slope_error() const {
    const Real rest = y_y_ - slope() * t_y_;
    return sqrt(max(rest, Real(0)) / Real(points_ - 2) / t_t_);
}

namespace {

const char* const defect_suffixes[] = {"", ".final"};
const char* const integral_suffixes[] = {"", ".final", ".relative", ".slope", ".slope_error"};

template <std::size_t n>
bool any_matches(const std::vector<std::string>& patterns, const std::string& name, const char* const (&suffixes)[n]) {
    for (const char* suffix : suffixes)
        if (matches_any(patterns, name + suffix)) return true;
    return false;
}

}  // namespace

Monitor::Monitor(System& system, std::vector<std::string> patterns)
    : system_(system),
      patterns_(std::move(patterns)),
      states_(static_cast<std::size_t>(system.bodies())),
      directions_(system.constraint_rows()),
      springs_(static_cast<std::size_t>(system.torsion_springs())),
      angles_(springs_.size()),
      rows_(system.constraints()),
      xi_(system.constraints()),
      bias_(system.constraints()),
      dv_(system.velocities()) {
    const auto add = [&](Level level, bool direction, const char* name) {
        const bool occurs = level == Level::orthogonality ||
                            std::any_of(directions_.begin(), directions_.end(),
                                        [&](const ConstraintRow& row) { return row.direction == direction; });
        if (occurs && any_matches(patterns_, name, defect_suffixes))
            defects_.push_back({level, direction, name, std::string(find_metric(name)->unit)});
    };
    add(Level::position, false, "defect.position");
    add(Level::position, true, "defect.direction");
    add(Level::velocity, false, "defect.velocity");
    add(Level::velocity, true, "defect.direction.velocity");
    add(Level::acceleration, false, "defect.acceleration");
    add(Level::acceleration, true, "defect.direction.acceleration");
    add(Level::orthogonality, false, "defect.orthogonality");
    for (const FirstIntegral& integral : system.integrals()) {
        const std::string name = "invariant." + integral.name;
        if (any_matches(patterns_, name, integral_suffixes)) integrals_.push_back({&integral, name});
    }
}

void Monitor::measure(Level level, const Real& t, const Real* y) {
    const Real* v = y + system_.group().size();
    switch (level) {
        case Level::position:
            rows_.setZero();  // rows without a position level
            system_.position_residual(t, y, rows_.data());
            break;
        case Level::velocity:
            system_.velocity_residual(t, y, v, rows_.data());
            break;
        case Level::orthogonality:
            break;
        case Level::acceleration:
            ++evaluations_;
            if (system_.accelerations(t, y, v, dv_.data(), nullptr) != Status::ok) measured_ = false;
            system_.velocity_residual(t, y, dv_.data(), rows_.data());  // C v' + b
            system_.velocity_bias(t, y, bias_.data());
            system_.acceleration_bias(t, y, v, xi_.data());
            rows_ -= bias_ + xi_;
            break;
    }
}

Real Monitor::norm(bool direction) const {
    Real sum = 0;
    for (std::size_t i = 0; i < directions_.size(); ++i)
        if (const Real& row = rows_[static_cast<Eigen::Index>(i)]; directions_[i].direction == direction)
            sum += row * row;
    return sqrt(sum);
}

namespace {

/// worst = max(worst, now), in which NaN and infinity persist.
void keep_worst(Real& worst, const Real& now) {
    if (isfinite(worst) && !(now <= worst)) worst = now;
}

}  // namespace

void Monitor::observe(const Real& t, const Real* y) {
    const Defect* before = nullptr;
    for (Defect& defect : defects_) {
        if (!before || before->level != defect.level) measure(defect.level, t, y);
        defect.now =
            defect.level == Level::orthogonality ? system_.group().orthogonality_defect(y) : norm(defect.direction);
        keep_worst(defect.worst, defect.now);
        before = &defect;
    }
    if (integrals_.empty()) return;
    system_.read(y, states_.data());
    system_.read_angles(y, springs_.data());
    for (std::size_t i = 0; i < angles_.size(); ++i) angles_[i] = springs_[i].theta;
    const MotionState state{states_, angles_};
    for (Integral& integral : integrals_) {
        const Real value = integral.source->value(state);
        if (!started_) {
            integral.start = value;
            // A start value below the round-off of its terms is zero, and relative values are undefined.
            integral.has_relative = abs(value) > 100 * epsilon * integral.source->size(state);
        }
        integral.now = value - integral.start;
        keep_worst(integral.worst, abs(integral.now));
        integral.fit.add(t, integral.now);
    }
    started_ = true;
}

std::vector<std::pair<std::string, Number>> Monitor::metrics(bool finished) const {
    std::vector<std::pair<std::string, Number>> all;
    const auto add = [&](const std::string& name, const Real& value) {
        if (isfinite(value) && matches_any(patterns_, name)) all.emplace_back(name, to_number(value));
    };
    for (const Defect& defect : defects_) {
        if (defect.level == Level::acceleration && !measured_) continue;
        add(defect.name, defect.worst);
        if (finished) add(defect.name + ".final", defect.now);
    }
    for (const Integral& integral : integrals_) {
        add(integral.name, integral.worst);
        if (integral.has_relative) add(integral.name + ".relative", integral.worst / abs(integral.start));
        if (finished) add(integral.name + ".final", Real(abs(integral.now)));
        if (!finished || integral.fit.points() < 3) continue;
        add(integral.name + ".slope", integral.fit.slope());
        add(integral.name + ".slope_error", integral.fit.slope_error());
    }
    return all;
}

std::vector<Column> Monitor::columns() const {
    std::vector<Column> all;
    const auto add = [&](const std::string& name, const std::string& unit) {
        all.push_back({name, unit});
        all.push_back({name + ".max", unit});
    };
    for (const Defect& defect : defects_) add(defect.name, defect.unit);
    for (const Integral& integral : integrals_) add(integral.name, integral.source->unit);
    return all;
}

void Monitor::append_values(std::vector<Real>& row) const {
    for (const Defect& defect : defects_) row.insert(row.end(), {defect.now, defect.worst});
    for (const Integral& integral : integrals_) row.insert(row.end(), {integral.now, integral.worst});
}

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
