// SPDX-License-Identifier: BSD-3-Clause
#include "tests/judges/steps/recorded_steps.hpp"

#include <Eigen/LU>
#include <Eigen/QR>
#include <stdexcept>

#include "lie/s3.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

namespace {

void require_ok(Status status, const std::string& what) {
    if (status != Status::ok) throw std::domain_error(what + " ends in " + name(status));
}

/// Inverse of MatrixGroup::matrix: the position stands in the last column of a body that has one.
VecX stored(const MatX& g, Eigen::Index size) {
    VecX q(size);
    const Mat3 R = g.topLeftCorner(3, 3);
    const bool quaternion = size == S3::size || size == 3 + S3::size;
    if (quaternion)
        q.tail(4) = S3::of_rotation(R);
    else
        q.tail(9) = Eigen::Map<const VecX>(R.data(), 9);
    if (size > (quaternion ? 4 : 9)) q.head(3) = g.block(g.rows() - 4, g.cols() - 1, 3, 1);
    return q;
}

}  // namespace

MatrixGroup matrix_group(const std::string& formulation) {
    if (formulation == "SO3-LiePoisson") return matrix_so3();  // its configurations
    for (const MatrixGroup& group : {matrix_so3(), matrix_s3(), matrix_so3xr3(), matrix_s3xr3(), matrix_se3()})
        if (group.name == formulation) return group;
    throw std::out_of_range("no dense matrices for formulation " + formulation);
}

DenseBodies::DenseBodies(const std::string& formulation)
    : body_(matrix_group(formulation)), size_(body_.group->size()), dim_(body_.group->dim()) {}

VecX DenseBodies::increment(const VecX& q, const VecX& next, Side side) const {
    VecX u(q.size() / size_ * dim_);
    for (Eigen::Index i = 0; (i + 1) * size_ <= q.size(); ++i) {
        const MatX a = body_.matrix(q.data() + i * size_), b = body_.matrix(next.data() + i * size_);
        const MatX inverse = a.partialPivLu().inverse();
        const MatX U = dense_log(side == Side::right ? MatX(inverse * b) : MatX(b * inverse));
        u.segment(i * dim_, dim_) = body_.vee(U);
        const Real off = MatX(U - body_.hat(u.segment(i * dim_, dim_))).cwiseAbs().maxCoeff();
        if (!(off < equations_tolerance())) u[i * dim_] = std::numeric_limits<Real>::quiet_NaN();
    }
    return u;
}

VecX DenseBodies::pulled_back(const VecX& u, const VecX& v) const {
    VecX rate(u.size());
    for (Eigen::Index i = 0; i < u.size(); i += dim_)
        rate.segment(i, dim_) = dense_dexpinv_left(body_, VecX(u.segment(i, dim_)), VecX(v.segment(i, dim_)));
    return rate;
}

VecX DenseBodies::moved(const VecX& q, const VecX& u) const {
    VecX next = q;  // labels of torsion springs stand behind the poses
    for (Eigen::Index i = 0; (i + 1) * size_ <= q.size(); ++i) {
        const MatX step = dense_exp(body_.hat(u.segment(i * dim_, dim_)));
        next.segment(i * size_, size_) = stored(MatX(body_.matrix(q.data() + i * size_) * step), size_);
    }
    return next;
}

VecX DenseBodies::bracket(const VecX& u, const VecX& v) const {
    VecX w(u.size());
    for (Eigen::Index i = 0; i < u.size(); i += dim_)
        w.segment(i, dim_) = dense_ad(body_, u.segment(i, dim_)) * v.segment(i, dim_);
    return w;
}

RecordedRun::RecordedRun(const Method& method, const OptionValues& options, const Model& model,
                         const std::string& formulation, const Real& step, int steps)
    : bodies(formulation), h(step), system_(make_system(model, formulation)) {
    std::vector<Real> y = initial_state(*system_, model);
    const auto integrator = method.bind(*system_, options);
    const Real start = Real(1) / 3;
    const auto keep = [&](const Real& t, const VecX& lambda) {
        const Eigen::Map<const VecX> all(y.data(), static_cast<Eigen::Index>(y.size()));
        states.push_back({t, all.head(system_->group().size()), all.tail(system_->velocities()), lambda});
    };
    require_ok(integrator->start(start, y.data()), "the start");
    keep(start, VecX());
    for (int i = 0; i < steps; ++i) {
        require_ok(integrator->step(start + i * h, h, y.data()), "step " + std::to_string(i + 1));
        const Real* lambda = integrator->multipliers();
        keep(start + (i + 1) * h, lambda ? VecX(Eigen::Map<const VecX>(lambda, system_->constraints())) : VecX());
    }
}

VecX RecordedRun::index1_rate(const RecordedState& state) {
    VecX rate(system_->velocities());
    require_ok(system_->accelerations(state.t, state.q.data(), state.v.data(), rate.data(), nullptr),
               "the index-1 form");
    return rate;
}

VecX RecordedRun::index1_multipliers(const RecordedState& state) {
    VecX rate(system_->velocities()), lambda(system_->constraints());
    require_ok(system_->accelerations(state.t, state.q.data(), state.v.data(), rate.data(), lambda.data()),
               "the index-1 form");
    return lambda;
}

VecX RecordedRun::rate(const RecordedState& state) {
    const Eigen::Index n = system_->velocities(), m = system_->constraints();
    if (state.lambda.size() != m) throw std::domain_error("reports no multipliers");
    VecX rates(n), gyroscopic(n);
    system_->applied_force(state.t, state.q.data(), state.v.data(), rates.data());
    system_->gyroscopic_force(state.q.data(), state.v.data(), gyroscopic.data());
    MatX C(m, n);
    system_->jacobian(state.t, state.q.data(), C.data());
    MatX force = rates + gyroscopic - C.transpose() * state.lambda;
    solve_mass(state.q, force);
    return force;
}

void RecordedRun::solve_mass(const VecX& q, MatX& rates) {
    const Eigen::Index rows = system_->mass_block();
    MatX blocks(rows, rates.rows());
    system_->mass(q.data(), blocks.data());
    for (Eigen::Index i = 0; i < rates.rows(); i += rows)
        rates.middleRows(i, rows) =
            MatX(blocks.middleCols(i, rows)).partialPivLu().solve(MatX(rates.middleRows(i, rows))).eval();
}

MatX RecordedRun::mass(const VecX& q) {
    const Eigen::Index rows = system_->mass_block(), n = system_->velocities();
    MatX blocks(rows, n), M = MatX::Zero(n, n);
    system_->mass(q.data(), blocks.data());
    for (Eigen::Index i = 0; i < n; i += rows) M.block(i, i, rows, rows) = blocks.middleCols(i, rows);
    return M;
}

MatX RecordedRun::position_rows(const RecordedState& state) {
    MatX C(system_->constraints(), system_->velocities());
    system_->jacobian(state.t, state.q.data(), C.data());
    return C.topRows(system_->position_constraints());
}

VecX RecordedRun::position_defect(const RecordedState& state) {
    VecX rows(system_->position_constraints());
    system_->position_residual(state.t, state.q.data(), rows.data());
    return rows;
}

VecX RecordedRun::velocity_defect(const RecordedState& state) {
    VecX rows(system_->constraints());
    system_->velocity_residual(state.t, state.q.data(), state.v.data(), rows.data());
    return rows;
}

RecordedState state_before(RecordedRun& run, const RecordedState& state, const std::string& method_name) {
    const Method& known = method(method_name);
    const auto integrator = known.bind(run.system(), stepping::default_options(known.description.options));
    VecX y(state.q.size() + state.v.size());
    y << state.q, state.v;
    if (integrator->step(state.t, -run.h, y.data()) != Status::ok) throw std::domain_error("the step back fails");
    return {.t = state.t - run.h, .q = y.head(state.q.size()), .v = y.tail(state.v.size()), .lambda = {}};
}

void Violations::see(const std::string& equation, const VecX& residual) {
    if (residual.size() == 0) return;
    const Real size = residual.allFinite() ? residual.cwiseAbs().maxCoeff() : std::numeric_limits<Real>::infinity();
    if (size > largest_) largest_ = size, worst_ = equation;
}

Objection Violations::objection(const Real& tolerance) const {
    return largest_ < tolerance ? "" : worst_ + " is missed by " + to_text(largest_);
}

VecX solved_square(const MatX& S, const VecX& r) { return S.partialPivLu().solve(r); }

VecX outside_range(const MatX& T, const VecX& r) {
    if (T.cols() == 0) return r;
    return r - T * VecX(T.colPivHouseholderQr().solve(r));
}

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
