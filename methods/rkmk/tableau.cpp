// SPDX-License-Identifier: BSD-3-Clause
//
// Munthe-Kaas lift of an explicit tableau that the config writes, by default the classical one. Its order and that of
// its embedded solution are declared beside it, and verified before it runs (methods/conditions/tableau_options.hpp).
// Sources: lift [munthekaas1998], [kutta1901], conditions [hairer1993, Sec. II.2].
#include "methods/conditions/tableau_options.hpp"
#include "methods/contract/integrator.hpp"
#include "methods/rkmk/rkmk.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

namespace {

/// What the options write by default.
const Tableau classical{.a = {{}, {{1, 2}}, {0, {1, 2}}, {0, 0, 1}}, .b = {{1, 6}, {1, 3}, {1, 3}, {1, 6}}};

Order order_of(const OptionValues& options) { return {static_cast<int>(std::get<long>(options.at("order")))}; }

Factory rkmk_of_options() {
    Factory factory = rkmk(classical);
    const auto lift_order = factory.order;
    const auto why_no_lift = factory.why_not;
    const std::vector<OptionDescription> tableau = tableau_options();
    factory.options.insert(factory.options.begin(), tableau.begin(), tableau.end());
    factory.make = [](System& system, const OptionValues& options, const MethodDescription& described) {
        MethodDescription declared = described;
        declared.order = order_of(options);
        return rkmk(verified_tableau(options)).make(system, options, declared);
    };
    factory.order = [lift_order](const OptionValues& options, const Order&) {
        return lift_order(options, order_of(options));
    };
    factory.estimate = [](const OptionValues& options, int) { return estimate_of_tableau(options); };
    factory.why_not = [why_no_lift](const OptionValues& options) {
        verified_tableau(options);
        return why_no_lift(options);
    };
    return factory;
}

}  // namespace

KREISEL_METHOD(rkmk_of_options(), {.name = "rkmk/tableau",
                                   .order = 4,
                                   .cites = {"munthekaas1998", "kutta1901", "hairer1993"},
                                   .summary = "Munthe-Kaas lift of an explicit tableau or embedded pair of your own"});

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
