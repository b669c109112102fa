// SPDX-License-Identifier: BSD-3-Clause
#include "mechanics/system.hpp"

#include <Eigen/Cholesky>
#include <algorithm>

namespace kreisel {
inline namespace KREISEL_PRECISION {

namespace {

int size_of_poses(const Group& configurations) {
    const auto* covering = dynamic_cast<const Covering*>(&configurations);
    return covering ? covering->base().size() : configurations.size();
}

}  // namespace

System::System(std::shared_ptr<const Group> configurations)
    : group_(configurations), state_group_(configurations), poses_(size_of_poses(*configurations)) {}

Status System::solve_kkt(const Real&, const Real*, const Real* f, const Real*, Real* a, Real*) {
    if (f)
        std::copy_n(f, velocities(), a);  // unit mass, no constraints
    else
        std::fill_n(a, velocities(), Real(0));
    return Status::ok;
}

void System::mass(const Real*, Real* blocks) const {
    const int size = mass_block();
    for (int block = 0; block < velocities() / size; ++block, blocks += size * size)
        Eigen::Map<MatX>(blocks, size, size).setIdentity();
}

void System::solve_mass(const Real* q, const Real* f, Real* a) const {
    const Eigen::Index rows = mass_block();
    MatX blocks(rows, velocities());
    mass(q, blocks.data());
    for (Eigen::Index i = 0; i < velocities(); i += rows)
        Eigen::Map<VecX>(a + i, rows) =
            MatX(blocks.middleCols(i, rows)).llt().solve(Eigen::Map<const VecX>(f + i, rows)).eval();
}

void System::apply_jacobian(const Real& t, const Real* q, const Real* v, Real* product) const {
    MatX C(constraints(), velocities());
    jacobian(t, q, C.data());
    Eigen::Map<VecX>(product, C.rows()) = (C * Eigen::Map<const VecX>(v, C.cols())).eval();
}

void System::apply_jacobian_transpose(const Real& t, const Real* q, const Real* lambda, Real* f) const {
    MatX C(constraints(), velocities());
    jacobian(t, q, C.data());
    Eigen::Map<VecX>(f, C.cols()) = (C.transpose() * Eigen::Map<const VecX>(lambda, C.rows())).eval();
}

void System::complement_diagonal(const Real& t, const Real* q, Real* diagonal) const {
    MatX C(constraints(), velocities());
    jacobian(t, q, C.data());
    VecX row(velocities()), a(velocities());
    for (Eigen::Index k = 0; k < C.rows(); ++k) {
        row = C.row(k).transpose();
        solve_mass(q, row.data(), a.data());
        diagonal[k] = row.dot(a);
    }
}

void System::applied_force(const Real&, const Real*, const Real*, Real* f) const {
    std::fill_n(f, velocities(), Real(0));
}

void System::conservative_force(const Real& t, const Real* q, Real* f) const {
    const std::vector<Real> rest(static_cast<std::size_t>(velocities()), Real(0));
    applied_force(t, q, rest.data(), f);
}

void System::dissipative_force(const Real& t, const Real* q, const Real* v, Real* f) const {
    std::vector<Real> at_rest(static_cast<std::size_t>(velocities()));
    conservative_force(t, q, at_rest.data());
    applied_force(t, q, v, f);
    for (std::size_t i = 0; i < at_rest.size(); ++i) f[i] -= at_rest[i];
}

void System::gyroscopic_force(const Real*, const Real*, Real* f) const { std::fill_n(f, velocities(), Real(0)); }

void System::velocity_bias(const Real&, const Real*, Real* b) const { std::fill_n(b, constraints(), Real(0)); }

void System::row_scale(Real* scale) const { std::fill_n(scale, constraints(), Real(1)); }

void System::position_scale(const Real*, Real* scale) const { std::fill_n(scale, position_constraints(), Real(1)); }

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
