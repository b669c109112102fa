// SPDX-License-Identifier: BSD-3-Clause
#include "plots/figures/kinds/smooth_path.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace kreisel {

namespace {

double dot(const Point3& a, const Point3& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
double length(const Point3& a) { return std::sqrt(dot(a, a)); }

// From a sample to the next one.
struct Arc {
    double t, h;
    Point3 x, dx, v, w;  // at the first; dx to the second, where the velocity is w

    Arc(const BodyPath& path, std::size_t k)
        : t(path.t[k]), h(path.t[k + 1] - t), x(path.x[k]), dx(path.x[k + 1]), v(path.v[k]), w(path.v[k + 1]) {
        for (std::size_t i = 0; i < 3; ++i) { dx[i] -= x[i]; }
    }

    // By how much v turns in points, 1 for a straight line.
    int pieces() const {
        constexpr double longest_arc = 2, most = 6 * std::numbers::pi / 180;  // arc over chord; rad from point to point
        const double way = h * (length(v) + length(w)) / 2, speeds = length(v) * length(w);
        if (!(way < longest_arc * length(dx)) || !(speeds > 0)) { return 1; }
        const double angle = std::acos(std::clamp(dot(v, w) / speeds, -1.0, 1.0));
        return std::max(1, static_cast<int>(std::ceil(angle / most - 1e-9)));
    }

    // At the part s of the time, 0 < s < 1.
    void append(double s, BodyPath& path) const {
        const double a = s * s * (3 - 2 * s), b = h * s * (1 - s) * (1 - s), c = -h * s * s * (1 - s);
        const double da = 6 * s * (1 - s) / h, db = (1 - s) * (1 - 3 * s), dc = s * (3 * s - 2);
        Point3 at{}, rate{};
        for (std::size_t i = 0; i < 3; ++i) {
            at[i] = x[i] + a * dx[i] + b * v[i] + c * w[i];
            rate[i] = da * dx[i] + db * v[i] + dc * w[i];
        }
        path.t.push_back(t + s * h);
        path.x.push_back(at);
        path.v.push_back(rate);
    }
};

}  // namespace

BodyPath smooth_path(const BodyPath& samples) {
    if (samples.v.size() != samples.t.size() || samples.t.empty()) { return {samples.t, samples.x, {}}; }
    BodyPath smooth{{samples.t.front()}, {samples.x.front()}, {}, {samples.v.front()}};
    for (std::size_t k = 0; k + 1 < samples.t.size(); ++k) {
        const Arc arc(samples, k);
        const int pieces = arc.pieces();
        for (int i = 1; i < pieces; ++i) { arc.append(static_cast<double>(i) / pieces, smooth); }
        smooth.t.push_back(samples.t[k + 1]);
        smooth.x.push_back(samples.x[k + 1]);
        smooth.v.push_back(samples.v[k + 1]);
    }
    return smooth;
}

}  // namespace kreisel
