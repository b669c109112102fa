// SPDX-License-Identifier: BSD-3-Clause
#include <Eigen/Core>
#include <nlohmann/json.hpp>
