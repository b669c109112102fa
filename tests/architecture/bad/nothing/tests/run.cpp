// SPDX-License-Identifier: BSD-3-Clause
#include <nlohmann/json.hpp>
#include "problems/top.cpp"
const double patience = 0.1;
