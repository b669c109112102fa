// SPDX-License-Identifier: BSD-3-Clause
//
// A tableau as the options of a method write it: exact numbers, rows apart by semicolons. What it declares is verified
// in rational arithmetic, by the same conditions that certify the methods of this project.
#pragma once

#include <vector>

#include "methods/contract/description.hpp"
#include "methods/tableaus/tableau.hpp"

namespace kreisel {

/// a, b, b_hat, c, order, order_hat, label; by default the classical method of order 4.
std::vector<OptionDescription> tableau_options();

/// The tableau, where the options have the shape of an explicit one, rows sum to their nodes and both solutions have
/// their declared order and no more, all exactly; decimals of 40 digits and more may be rounded in the last of them.
/// Else throws OptionError, which names the row or the first condition that is missed. The tableau lives as long as the
/// program, and each is verified once.
const Tableau& verified_tableau(const OptionValues& options);

/// r of its estimate (MethodDescription::estimate): one more than the lower of the orders; 0 without b_hat.
int estimate_of_tableau(const OptionValues& options);

}  // namespace kreisel
