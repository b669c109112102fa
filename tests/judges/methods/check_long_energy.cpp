// SPDX-License-Identifier: BSD-3-Clause
//
// Whether the energy errors of a method that claims to be symplectic, or to keep the energy, stay bounded over ten
// thousand steps [hairer2006, Thm IX.8.1]: on a free body, two integrable tops and two links that swing gently, at two
// step sizes, in double.
#include "mechanics/model/scales.hpp"
#include "records/fits/energy.hpp"
#include "tests/judges/methods/domains.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

using namespace stepping;

namespace {

constexpr long steps_of_run = 10000;

/// Two links that hang along x and swing by some 0.1 rad: nearly integrable, where the model's own start is chaotic.
Model gentle_pendulum() {
    Model model = models::standard("double_pendulum");
    model.gravity.g = Vec3(Real(981) / 100, 0, 0);
    const Vec3 first(Real(1) / 2, Real(3) / 10, Real(-1) / 5), second(Real(-3) / 10, Real(1) / 5, Real(2) / 5);
    const Vec3 half(Real(1) / 2, 0, 0), lever(Real(2) / 5, 0, 0), pin = first.cross(Vec3::UnitX());
    model.bodies[0].start = {half, Mat3::Identity(), first.cross(half), first};
    model.bodies[1].start = {Vec3::UnitX() + lever, Mat3::Identity(), pin + second.cross(lever), second};
    return model;
}

const std::vector<models::Named>& long_models() {
    static const std::vector<models::Named> all = {{"free_top", models::standard("free_top")},
                                                   {"lagrange_top", models::standard("lagrange_top")},
                                                   {"kovalevskaya_top", models::standard("kovalevskaya_top")},
                                                   {"a gentle double_pendulum", gentle_pendulum()}};
    return all;
}

const FirstIntegral& energy_of(const System& system) {
    const auto& all = system.integrals();
    return *std::find_if(all.begin(), all.end(), [](const FirstIntegral& one) { return one.name == "energy"; });
}

/// E - E_0 after every step (a top nutates faster than sparse samples could see); a status if a step fails.
Status run_for_energy(Trip& trip, const Real& h, EnergySeries& series) {
    const FirstIntegral& energy = energy_of(*trip.system);
    const auto value = [&] { return energy.value({trip.bodies()}); };
    const Real start = value();
    series = {.h = to_double(h), .t = {0}, .drift = {0}, .scale = to_double(energy.size({trip.bodies()}))};
    Status status = trip.integrator->start(0, trip.y.data());
    for (long i = 1; i <= steps_of_run && status == Status::ok; ++i) {
        status = trip.integrator->step(h * Real(i - 1), h, trip.y.data());
        series.t.push_back(to_double(h * Real(i)));
        series.drift.push_back(to_double(Real(value() - start)));
        series.largest = std::max(series.largest, std::abs(series.drift.back()));
    }
    return status;
}

Objection long_energy_objection(const Method& entry, const models::Named& named, const std::string& formulation) {
    std::vector<EnergySeries> runs(2);
    for (std::size_t i = 0; i < runs.size(); ++i) {
        Trip trip(named.model, formulation, entry);
        const Status status = run_for_energy(trip, Real(1) / (i == 0 ? 50 : 100), runs[i]);
        if (status != Status::ok) return std::string("a long run ends in ") + name(status);
    }
    const EnergyLaw law = energy_law(runs);
    const bool good = law.verdict == EnergyVerdict::bounded || law.verdict == EnergyVerdict::kept;
    return good ? ""
                : "the energy error is not bounded over " + std::to_string(steps_of_run) + " steps, but " +
                      energy_text(law);
}

bool claims_bounded_energy(const MethodDescription& method, Domain domain) {
    for (const Property property : {Property::symplectic, Property::energy}) {
        const std::optional<Domain> claimed = claimed_domain(method, property);
        if (claimed && domain <= *claimed) return true;
    }
    return false;
}

}  // namespace

Objection bounded_energy_objection(const Method& entry) {
    if (KREISEL_QUAD) return "";  // ten thousand steps would take a minute
    for (const models::Named& named : long_models())
        for (const char* formulation : {"SO3", "SO3xR3"}) {
            const auto applies = models::applicable(named.model);
            if (std::find(applies.begin(), applies.end(), formulation) == applies.end()) continue;
            if (!runs_on(entry, named.model, formulation)) continue;
            const Domain domain = domain_of(named.model, *make_system(named.model, formulation));
            if (!claims_bounded_energy(entry.description, domain)) continue;
            const Objection objection = long_energy_objection(entry, named, formulation);
            if (!objection.empty()) return objection + " (" + named.name + ", as " + formulation + ")";
            break;  // one formulation of a model is enough
        }
    return "";
}

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
