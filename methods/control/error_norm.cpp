// SPDX-License-Identifier: BSD-3-Clause
#include "methods/control/error_norm.hpp"

#include "lie/linear.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

ErrorNorm::ErrorNorm(const System& system, const Accuracy& accuracy)
    : system_(system),
      n_(system.velocities()),
      triples_(n_ / 3),
      triples_per_body_(system.bodies() > 0 ? triples_ / system.bodies() : 1),
      tolerance_(accuracy.tolerance),
      inverse_length_(accuracy.length > 0 ? Real(1 / accuracy.length) : Real(1)),
      inverse_(static_cast<std::size_t>(system.state_group().size())),
      difference_(static_cast<std::size_t>(2 * n_)) {}

Real ErrorNorm::squares(const Real* z) const {
    Real sum = 0;
    for (int i = 0; i < triples_; ++i) {
        const Real w = weight(i);
        sum += w * w * vec3(z + 3 * i).squaredNorm();
    }
    for (int i = 3 * triples_; i < n_; ++i) sum += z[i] * z[i];
    return sum;
}

/// z(i) is entry i of a velocity; its root is a length over the length of the mechanism, or an angle.
template <class Entry>
Real ErrorNorm::largest(Entry z) const {
    Real square = 0;
    for (int i = 0; i < triples_; ++i) {
        const Real w = weight(i);
        square = max(square, Real(w * w * Vec3(z(3 * i), z(3 * i + 1), z(3 * i + 2)).squaredNorm()));
    }
    for (int i = 3 * triples_; i < n_; ++i) square = max(square, Real(z(i) * z(i)));
    return sqrt(square);
}

Real ErrorNorm::rate(const Real& h, const Real* y, const Real* y_new) const {
    const Real *v = system_.v(y), *v_new = system_.v(y_new);
    const Real velocity = largest([v](int i) { return v[i]; });
    const Real at_end = largest([v_new](int i) { return v_new[i]; });
    const Real change = largest([=](int i) { return Real(v_new[i] - v[i]); });
    return max(max(velocity, at_end), Real(sqrt(change / abs(h))));
}

Real ErrorNorm::rate(const Real* z) const {
    const Real* dv = system_.state_group().dv(z);
    const Real velocity = largest([z](int i) { return z[i]; }), slope = largest([dv](int i) { return dv[i]; });
    return max(velocity, Real(sqrt(slope)));
}

Real ErrorNorm::operator()(const Real& h, const Real* y, const Real* y_new, const Real* error) const {
    Real velocities = squares(system_.state_group().dv(error));
    if (velocities != 0) {
        const Real unit = rate(h, y, y_new);
        velocities /= unit * unit;
    }
    return sqrt((squares(error) + velocities) / Real(2 * n_)) / tolerance_;
}

Real ErrorNorm::distance(const Real& h, const Real* y, const Real* moved) {
    const TangentGroup& group = system_.state_group();
    group.inverse(y, inverse_.data());
    group.multiply(inverse_.data(), moved, inverse_.data());
    group.log(inverse_.data(), difference_.data());
    return (*this)(h, y, moved, difference_.data());
}

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
