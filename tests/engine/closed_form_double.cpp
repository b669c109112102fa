// SPDX-License-Identifier: BSD-3-Clause
//
// Compiles the closed form a second time, in double; its symbols live in the inline namespace of that precision.
#undef KREISEL_PRECISION
#undef KREISEL_QUAD
#define KREISEL_PRECISION binary64
#define KREISEL_QUAD 0
#include "tests/engine/closed_form_double.hpp"

#include "mechanics/free_body/elliptic.cpp"
#include "mechanics/free_body/free_rotation.cpp"

namespace reference_tests {

DoubleRotation free_rotation_in_double(const kreisel::Matrix3& J, const kreisel::Matrix3& R0,
                                       const kreisel::Vector3& omega, double t) {
    using RowMajor = Eigen::Matrix<double, 3, 3, Eigen::RowMajor>;
    const auto matrix = [](const kreisel::Matrix3& a) { return Eigen::Map<const RowMajor>(a.data()); };
    const kreisel::FreeRotation exact =
        kreisel::free_rotation(matrix(J), matrix(R0), Eigen::Map<const Eigen::Vector3d>(omega.data()), t);
    DoubleRotation result;
    Eigen::Map<RowMajor>{result.R.data()} = exact.R;
    Eigen::Map<Eigen::Vector3d>{result.omega.data()} = exact.omega;
    return result;
}

}  // namespace reference_tests
