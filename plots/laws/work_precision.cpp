// SPDX-License-Identifier: BSD-3-Clause
#include "plots/laws/work_precision.hpp"

#include <algorithm>
#include <cmath>

namespace kreisel {

std::optional<CostAtAccuracy> cost_at(std::vector<WorkPoint> points, double accuracy) {
    std::erase_if(points, [](const WorkPoint& point) { return !(point.x > 0); });
    std::stable_sort(points.begin(), points.end(), [](const auto& a, const auto& b) { return a.x < b.x; });
    const auto reaches = [&](const WorkPoint& point) { return point.error <= accuracy; };
    const auto first = std::find_if(points.begin(), points.end(), reaches);
    if (first == points.end()) { return std::nullopt; }
    if (first->error == accuracy) { return CostAtAccuracy{first->x}; }
    if (first == points.begin() || first->error == 0) { return CostAtAccuracy{first->x, true}; }
    const WorkPoint& before = *std::prev(first);
    const double share = std::log(before.error / accuracy) / std::log(before.error / first->error);
    return CostAtAccuracy{before.x * std::pow(first->x / before.x, share)};
}

}  // namespace kreisel
