// SPDX-License-Identifier: BSD-3-Clause
//
// The parameters of generalised-alpha methods: from the spectral radius at infinite frequency [chunghulbert1993],
//   alpha_m = (2 rho - 1)/(rho + 1),  alpha_f = rho/(rho + 1),
//   gamma = 1/2 + alpha_f - alpha_m,  beta = (gamma + 1/2)^2 / 4,
// or each of them given as an option of its own name.
#pragma once

#include "lie/real.hpp"
#include "methods/contract/method.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

struct AlphaParameters {
    Real alpha_m, alpha_f, gamma, beta;
};

/// What the options say; those that are missing are their defaults.
AlphaParameters alpha_parameters(const OptionValues& options);

/// Options, order and the reasons why parameters do not apply, of a method that `make` binds.
Factory alpha_factory(decltype(Factory::make) make);

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
