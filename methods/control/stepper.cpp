// SPDX-License-Identifier: BSD-3-Clause
#include "methods/control/stepper.hpp"

#include <stdexcept>

#include "methods/control/step_control.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

std::unique_ptr<Stepper> bind_stepper(const Method& method, System& system, Projection& projection,
                                      const Accuracy& accuracy, const OptionValues& options) {
    if (method.description.own_control)
        return method.factory.stepper(system, projection, accuracy, options, method.description);
    const MethodDescription description = method.under(options);
    if (description.estimate == 0)
        throw std::logic_error(description.name + " has no estimate of its error to choose steps by");
    return std::make_unique<StepControl>(system, projection, method.bind(system, options), accuracy, description);
}

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
