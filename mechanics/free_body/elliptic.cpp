// SPDX-License-Identifier: BSD-3-Clause
//
// Pi of negative characteristic is turned into one of positive characteristic, a sum of positive terms.
#include "mechanics/free_body/elliptic.hpp"

#include <array>
#include <boost/math/special_functions/ellint_rf.hpp>
#include <boost/math/special_functions/ellint_rj.hpp>
#include <limits>

namespace kreisel {
inline namespace KREISEL_PRECISION {

EllipticPhase elliptic_phase_of(Real s, Real c, const Real& k12) {
    const Real size = sqrt(s * s + c * c);
    s /= size, c /= size;
    const Real d2 = c * c + k12 * s * s;
    return {s * boost::math::ellint_rf(c * c, d2, Real(1)), atan2(s, c), s, c, sqrt(d2)};
}

/// By the arithmetic-geometric mean and descending Landen transformations (Abramowitz & Stegun, 16.4), the arcsines as
/// arctangents that keep their digits at k = 1.
EllipticPhase elliptic_phase(const Real& u, const Real& k1) {
    using std::atan, std::cosh, std::tanh;
    if (k1 == 0) {
        const Real sech = max(Real(1 / cosh(u)), std::numeric_limits<Real>::min());  // cn/dn = 1 to the end
        return {u, 2 * atan(tanh(u / 2)), tanh(u), sech, sech};
    }
    struct Mean {
        Real a, b, c;
    };
    std::array<Mean, 40> means = {{{Real(1), k1, Real(0)}}};  // from the smallest k' it takes some 20
    std::size_t last = 0;
    do {
        const Mean& m = means[last];
        means[last + 1] = {(m.a + m.b) / 2, sqrt(m.a * m.b), (m.a - m.b) / 2};
        ++last;
    } while (means[last].c > epsilon * means[last].a && last + 1 < means.size());
    Real phi = means[last].a * u;
    for (std::size_t n = 0; n < last; ++n) phi *= 2;
    for (std::size_t n = last; n > 0; --n) {
        const auto& [a, b, c] = means[n];
        const Real s = sin(phi), co = cos(phi);
        phi = (phi + atan2(c * s, sqrt(a * a * co * co + b * b * s * s))) / 2;
    }
    const Real s = sin(phi), c = cos(phi);
    return {u, phi, s, c, sqrt(c * c + k1 * k1 * s * s)};
}

namespace {

/// Pi(am u, N, k) for N in [k^2, 1), by Carlson's R_J; `complement` is 1 - N without cancellation, k12 = k'^2 > 0.
Real third_kind_positive(const EllipticPhase& p, const Real& N, const Real& complement, const Real& k12) {
    using boost::math::ellint_rj, std::round;
    const Real half_turns = round(p.am / pi()), sign = cos(half_turns * pi()) < 0 ? -1 : 1;
    const Real s = sign * p.sn, s2 = s * s, c2 = p.cn * p.cn;
    const Real part = s * s2 * ellint_rj(c2, p.dn * p.dn, Real(1), c2 + complement * s2);
    const Real whole = half_turns == 0 ? Real(0) : 2 * half_turns * ellint_rj(Real(0), k12, Real(1), complement);
    return p.u + N / 3 * (part + whole);
}

}  // namespace

/// Through the characteristic N = (k^2 - n)/(1 - n) in [k^2, 1] (Abramowitz & Stegun, 17.7.15 and 17.7.16).
Real third_kind(const EllipticPhase& p, const Real& n, const Real& k2, const Real& k12) {
    if (n == 0) return p.u;
    const Real N = (k2 - n) / (1 - n), d = k2 - n;
    const Real rest = k2 / d * p.u + atan2(sqrt(-n * N) * p.sn * p.cn, p.dn) * sqrt(-n / (d * (1 - n)));
    if (k12 == 0) return rest;
    return rest - n * k12 / ((1 - n) * d) * third_kind_positive(p, N, k12 / (1 - n), k12);
}

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
