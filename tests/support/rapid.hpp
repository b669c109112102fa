// SPDX-License-Identifier: BSD-3-Clause
//
// Property-based testing, free of `Real` and of rapidcheck's headers, which one translation unit includes.
#pragma once

#include <functional>
#include <string>
#include <vector>

namespace rapid {

/// A property of numbers in [-1, 1]; it returns whether it holds.
using Property = std::function<bool(const std::vector<double>&)>;

/// Tries `property` on `cases` draws of `count` numbers, always the same ones. Returns rapidcheck's report with the
/// simplest counterexample it can shrink to, or an empty text where the property holds. The numbers are multiples of
/// 2^-20, so that they are the same in every precision.
std::string counterexample(const std::string& name, int count, int cases, const Property& property);

}  // namespace rapid
