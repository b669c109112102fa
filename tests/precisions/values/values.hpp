// SPDX-License-Identifier: BSD-3-Clause
//
// The maps of the groups at fixed points, evaluated in each precision; free of `Real`.
#pragma once

#include <string>
#include <vector>

/// A number as the sum of two doubles, with its name.
struct Value {
    std::string name;
    double high, low;
};

std::vector<Value> values_binary64();
std::vector<Value> values_binary128();
