// SPDX-License-Identifier: BSD-3-Clause
#include "driver/config/urdf/pose.hpp"

#include "driver/config/urdf/element.hpp"

namespace kreisel::urdf {

using namespace boost::qvm;

Pose read_origin(const Element& element) {
    const auto origin = element.child("origin");
    if (!origin) { return {}; }
    return {rotation_of(origin->vector("rpy", {0, 0, 0})), to_vector(origin->vector("xyz", {0, 0, 0}))};
}

Matrix rotation_of(const std::array<double, 3>& rpy) {
    const Matrix x = rotx_mat<3>(rpy[0]), y = roty_mat<3>(rpy[1]), z = rotz_mat<3>(rpy[2]);
    return z * y * x;
}

Matrix turned(const Matrix& R, const Matrix& J) {
    const Matrix back = transposed(R), whole = R * J * back, mirrored = transposed(whole);
    return (whole + mirrored) / 2.0;
}

Matrix of_unit_mass(const Vector& d) {
    const auto [x, y, z] = d.a;
    return {{{y * y + z * z, -x * y, -x * z}, {-x * y, x * x + z * z, -y * z}, {-x * z, -y * z, x * x + y * y}}};
}

}  // namespace kreisel::urdf
