// SPDX-License-Identifier: BSD-3-Clause
//
// Fixed-size vectors and matrices, and views of them in flat storage (column by column, as Eigen keeps them).
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>

#include "lie/real.hpp"

#if KREISEL_QUAD
namespace Eigen {
/// Quad numbers are stored by value: Eigen may copy them like built-in types.
template <>
struct NumTraits<kreisel::Real> : GenericNumTraits<kreisel::Real> {
    enum {
        IsComplex = 0,
        IsInteger = 0,
        IsSigned = 1,
        RequireInitialization = 0,
        ReadCost = 2,
        AddCost = 30,
        MulCost = 40
    };
    static kreisel::Real epsilon() { return kreisel::epsilon; }
    static kreisel::Real dummy_precision() { return kreisel::epsilon * 1024; }
    static kreisel::Real highest() { return std::numeric_limits<kreisel::Real>::max(); }
    static kreisel::Real lowest() { return std::numeric_limits<kreisel::Real>::lowest(); }
    static int digits10() { return std::numeric_limits<kreisel::Real>::digits10; }
};
}  // namespace Eigen
#endif

namespace kreisel {
inline namespace KREISEL_PRECISION {

using Vec3 = Eigen::Matrix<Real, 3, 1>;
using Mat3 = Eigen::Matrix<Real, 3, 3>;
using VecX = Eigen::Matrix<Real, Eigen::Dynamic, 1>;
using MatX = Eigen::Matrix<Real, Eigen::Dynamic, Eigen::Dynamic>;

/// For the innermost functions: inline every call in the body, beyond the compiler's own limits.
/// Not under sanitizers, whose checks in the flattened bodies take a compiler minutes and gigabytes.
#if defined(__SANITIZE_ADDRESS__)
#define KREISEL_HOT
#else
#define KREISEL_HOT [[gnu::flatten]]
#endif

inline Vec3 vec3(const Real* p) { return {p[0], p[1], p[2]}; }
inline Eigen::Map<const Mat3> mat3(const Real* p) { return Eigen::Map<const Mat3>(p); }
inline void store(const Vec3& v, Real* p) { p[0] = v[0], p[1] = v[1], p[2] = v[2]; }
inline void store(const Mat3& m, Real* p) { Eigen::Map<Mat3>{p} = m; }

/// hat: R^3 -> so(3), hat(w) x = w x x (cross product).
inline Mat3 hat(const Vec3& w) {
    Mat3 W;
    W << 0, -w[2], w[1], w[2], 0, -w[0], -w[1], w[0], 0;
    return W;
}

/// vee: so(3) -> R^3, the inverse of hat on skew matrices; on others, of the skew part.
inline Vec3 vee(const Mat3& W) { return Vec3(W(2, 1) - W(1, 2), W(0, 2) - W(2, 0), W(1, 0) - W(0, 1)) / 2; }

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
