// SPDX-License-Identifier: BSD-3-Clause
//
// Attempts at a step, of methods that declare an estimate of its error: they are steps, whatever has been attempted
// before them.
#include "methods/contract/integrator.hpp"
#include "tests/judges/methods/checks.hpp"
#include "tests/judges/methods/runs.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

using namespace stepping;

namespace {

/// A method on a model, its state y at time t, and what its last attempt there has left.
class Attempts {
  public:
    Attempts(const Method& entry, const Model& model, const std::string& formulation)
        : trip_(model, formulation, entry),
          y(trip_.y),
          y_new(trip_.y),
          error(static_cast<std::size_t>(trip_.system->state_group().dim())) {}

    void start() { see(trip_.integrator->start(t, y.data()), "a start"); }
    void attempt(const Real& h) {
        const std::vector<Real> before = y;
        see(trip_.integrator->attempt(t, h, y.data(), y_new.data(), error.data()), "an attempt");
        if (y != before && failure.empty()) failure = "an attempt changes the state that it starts from";
        h_ = h;
    }
    /// The last attempt is the step; `moved`, the state is changed afterwards.
    void accept(bool moved) {
        y = y_new;
        if (moved) y[trip_.y.size() - 1] += Real(1) / 64;  // an entry of v
        trip_.integrator->accept(moved);
        t += h_;
    }
    void step(const Real& h) {
        y_new = y;
        see(trip_.integrator->step(t, h, y_new.data()), "a step");
    }
    /// Starts at the state of another.
    void start_at(const Attempts& other) {
        t = other.t, y = other.y;
        start();
    }

  private:
    void see(Status status, const std::string& what) {
        if (status != Status::ok && failure.empty()) failure = what + " ends in " + name(status);
    }

    Trip trip_;
    Real h_ = 0;

  public:
    Real t = Real(1) / 3;
    std::vector<Real> y, y_new, error;
    Objection failure;
};

/// Round-off of one step: slopes that are kept differ from new ones by that.
bool same(const std::vector<Real>& a, const std::vector<Real>& b) {
    return largest_difference(a, b) <= 1000 * epsilon * max(Real(1), largest(a));
}

Objection difference(const Attempts& found, const Attempts& expected, const std::string& where) {
    for (const Attempts* one : {&found, &expected})
        if (!one->failure.empty()) return one->failure + " " + where;
    if (!same(expected.y_new, found.y_new)) return "an attempt " + where + " is not a fresh one";
    return same(expected.error, found.error) ? "" : "the error of an attempt " + where + " is not that of a fresh one";
}

Objection attempts_on(const Method& entry, const Model& model, const std::string& formulation) {
    const Real h = Real(1) / 1000;
    Attempts fresh(entry, model, formulation), used(entry, model, formulation);
    fresh.start(), fresh.attempt(h);
    used.start(), used.step(h);
    if (!fresh.failure.empty() || !used.failure.empty()) return fresh.failure + used.failure;
    if (!same(fresh.y_new, used.y_new)) return "an attempt is not the step";

    used.start(), used.attempt(h), used.attempt(h / 2);
    fresh.start(), fresh.attempt(h / 2);
    if (const Objection found = difference(used, fresh, "after a rejected one"); !found.empty()) return found;

    for (const bool moved : {false, true}) {
        used.attempt(h), used.attempt(h / 2), used.accept(moved);
        fresh.start_at(used);
        used.attempt(h), fresh.attempt(h);
        const Objection found = difference(used, fresh, moved ? "from a projected state" : "after an accepted one");
        if (!found.empty()) return found;
    }
    return "";
}

}  // namespace

Objection attempts_objection(const Method& entry) {
    if (entry.description.estimate == 0 || entry.description.own_control) return "";
    return first_objection(entry, [&](const models::Named& named, const std::string& formulation) {
        return attempts_on(entry, named.model, formulation);
    });
}

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
