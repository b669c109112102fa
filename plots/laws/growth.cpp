// SPDX-License-Identifier: BSD-3-Clause
#include "plots/laws/growth.hpp"

#include <algorithm>
#include <cmath>

#include "records/fits/order.hpp"
#include "records/reading/trajectory_table.hpp"

namespace kreisel {

namespace {

// max |omega| |v| over all samples and bodies: the size of the accelerations of a body that rotates about a joint.
double largest_acceleration(const TrajectoryTable& trajectory) {
    const auto norm = [&](const std::string& name, std::size_t sample) {
        double sum = 0;
        for (const char* component : {"1", "2", "3"}) {
            const auto* column = trajectory.find(name + component);
            if (column == nullptr) { return 0.0; }
            sum += (*column)[sample] * (*column)[sample];
        }
        return std::sqrt(sum);
    };
    double largest = 0;
    for (const std::string& column : trajectory.names) {
        if (!column.ends_with(".x1")) { continue; }
        const std::string body = column.substr(0, column.size() - 2);
        const std::size_t samples = trajectory.columns.front().size();
        for (std::size_t i = 0; i < samples; ++i) {
            largest = std::max(largest, norm(body + "omega", i) * norm(body + "v", i));
        }
    }
    return largest;
}

}  // namespace

double roundoff_level(const TrajectoryTable& trajectory, const std::string& precision) {
    const auto* t = trajectory.find("t");
    const double end = t == nullptr || t->empty() ? 0 : t->back();
    return epsilon_of(precision) * std::max(1e4, 10 * largest_acceleration(trajectory) * end * end / 2);
}

std::optional<GrowthLaw> growth_of(const TrajectoryTable& trajectory, const std::string& name,
                                   const std::string& precision) {
    const auto* t = trajectory.find("t");
    const auto* y = trajectory.find(name + ".max");
    if (t == nullptr || y == nullptr) { return std::nullopt; }
    return fit_growth(*t, *y, roundoff_level(trajectory, precision));
}

}  // namespace kreisel
