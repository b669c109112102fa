// SPDX-License-Identifier: BSD-3-Clause
#include "tests/judges/methods/checks.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

const char* name(Check check) {
    switch (check) {
        case Check::order_conditions:
            return "order conditions";
        case Check::one_step:
            return "one step";
        case Check::order:
            return "observed order";
        case Check::solves:
            return "solves per step";
        case Check::history:
            return "history";
        case Check::attempts:
            return "attempts";
        case Check::reversal:
            return "time reversal";
        case Check::symplecticity:
            return "symplecticity";
        case Check::momentum:
            return "momentum";
        case Check::energy:
            return "energy";
        case Check::bounded_energy:
            return "bounded energy";
        case Check::constraints:
            return "constraints";
        case Check::equivariance:
            return "equivariance";
        case Check::injection:
            return "injection";
        case Check::convergence:
            return "convergence";
        case Check::projection:
            return "projection";
        case Check::iterations:
            return "iterations";
        case Check::every:
            return "every";
        case Check::stabilisation:
            return "stabilisation";
    }
    return "unknown";
}

const std::vector<Judgement>& running_checks() {
    static const std::vector<Judgement> all = {{Check::order, order_objection},
                                               {Check::solves, solves_objection},
                                               {Check::history, history_objection},
                                               {Check::attempts, attempts_objection},
                                               {Check::reversal, reversal_objection},
                                               {Check::symplecticity, symplecticity_objection},
                                               {Check::momentum, momentum_objection},
                                               {Check::energy, energy_objection},
                                               {Check::bounded_energy, bounded_energy_objection},
                                               {Check::constraints, constraints_objection},
                                               {Check::equivariance, equivariance_objection},
                                               {Check::injection, injection_objection},
                                               {Check::convergence, convergence_objection}};
    return all;
}

const std::vector<ProjectionJudgement>& projection_checks() {
    static const std::vector<ProjectionJudgement> all = {{Check::projection, projection_objection},
                                                         {Check::iterations, iterations_objection},
                                                         {Check::every, every_objection},
                                                         {Check::stabilisation, stabilisation_objection},
                                                         {Check::injection, projection_injection_objection}};
    return all;
}

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
