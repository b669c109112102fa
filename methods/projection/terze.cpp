// SPDX-License-Identifier: BSD-3-Clause
//
// The projection of the seed, as printed [terzezlatarmueller, eq. 12]: positions and velocities together,
//   min || (p - p^, v - v^) ||_W^2   subject to   Phi(p) = 0,   R_i R_i^T = I,   C(p) v + b = 0,
// with p = (x, R), R any 3x3 matrix, and six orthogonality rows per body (the upper triangle). Solved by linearising
// the rows g at z = (p, v): [W G^T; G 0] [delta; mu] = [W (z^ - z); -g].
// Option `weight`: `identity`, or `mass`: the mass matrix for v, m for x, and for R the metric tr(dR D dR^T) with
// D = tr(J)/2 I - J, which is J on tangential dR = R hat(theta). D may be singular (a flat body), W then is too; the
// whole matrix is not, because G fixes those directions. Hence a pivoted LU of it and not a Schur complement in W.
// Either weight adds metres to seconds: how a correction is shared between positions and velocities depends on the unit
// of time.
#include <Eigen/LU>

#include "mechanics/system.hpp"
#include "methods/projection/gauss_newton.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

namespace {

constexpr int most_terze_steps = 50;
const Real tolerance = 45 * epsilon;  // 1e-14 in double
constexpr int body_size = 12;         // x and the columns of R

class TerzeProjection final : public Projection {
  public:
    TerzeProjection(System& system, bool mass_weighted, bool once)
        : system_(system),
          once_(once),
          configuration_(system.group().size()),
          unknowns_(system.state_group().size()),
          joint_rows_(2 * system.constraints()),
          rows_(joint_rows_ + 6 * system.bodies()),
          weight_(MatX::Identity(unknowns_, unknowns_)),
          joint_jacobian_(joint_rows_, unknowns_),
          jacobian_(MatX::Zero(rows_, unknowns_)),
          column_unit_(VecX::Ones(unknowns_)),
          row_unit_(VecX::Ones(rows_)),
          row_scale_(system.constraints()),
          terms_(system.constraints()),
          residual_(rows_),
          start_(unknowns_),
          shift_(unknowns_),
          kkt_(MatX::Zero(unknowns_ + rows_, unknowns_ + rows_)),
          rhs_(unknowns_ + rows_),
          solution_(unknowns_ + rows_),
          lu_(unknowns_ + rows_) {
        system.row_scale(row_scale_.data());
        if (mass_weighted) set_mass_weight();
        set_units(mass_weighted);
        kkt_.topLeftCorner(unknowns_, unknowns_) = weight_;
    }

    Status project(const Real& t, Real* y) override {
        Eigen::Map<VecX> z(y, unknowns_);
        start_ = z;
        system_.position_scale(y, terms_.data());
        Real residual_before = std::numeric_limits<Real>::max();
        Real step = 0, step_before = 1;  // the first step is predicted to be followed by one of its square
        for (int i = 0; i < most_terze_steps; ++i) {
            linearise(t, y);
            if (!residual_.allFinite()) return Status::non_finite;
            const Real residual = relative_residual(y);
            const bool on_rows = residual <= tolerance;
            // At round-off the rows stop decreasing; above it that means no convergence.
            const bool still = 2 * residual > residual_before && residual <= 100 * tolerance;
            // Steps shrink at a linear rate along the rows, due to the curvature times the multipliers: the nearest
            // state is reached later than the rows.
            const bool nearest = step * step <= tolerance * step_before || 2 * step > step_before;
            if ((on_rows || still) && nearest) return Status::ok;
            residual_before = residual;
            shift_ = (start_ - z).cwiseQuotient(column_unit_);  // in a product it would be evaluated into a temporary
            rhs_.head(unknowns_).noalias() = weight_ * shift_;
            rhs_.tail(rows_) = -residual_.cwiseProduct(row_unit_);
            lu_.compute(kkt_);
            solution_ = lu_.solve(rhs_);
            if (i > 0) step_before = step;
            step = relative_step(y);
            z += solution_.head(unknowns_).cwiseProduct(column_unit_);
            ++iterations_;
            if (once_) return Status::ok;
        }
        return Status::projection_failed;
    }

  private:
    /// Largest row: position rows relative to their terms, velocity rows to the fastest motion of their arm,
    /// orthogonality rows as they are.
    Real relative_residual(const Real* y) const {
        const Eigen::Index m = system_.constraints();
        Real linear = 0, angular = 0;
        for (const Real* v = system_.v(y); v != y + unknowns_; v += 6)
            linear = max(linear, Real(vec3(v).norm())), angular = max(angular, Real(vec3(v + 3).norm()));
        Real largest = residual_.tail(rows_ - joint_rows_).lpNorm<Eigen::Infinity>();
        for (Eigen::Index i = 0; i < m; ++i) {
            if (residual_[i] != 0) largest = max(largest, Real(abs(residual_[i]) / terms_[i]));
            const Real speed = linear + angular * row_scale_[i];
            if (residual_[m + i] != 0) largest = max(largest, Real(abs(residual_[m + i]) / speed));
        }
        return largest;
    }

    /// Largest entry of the last solution: places over the unit of length, R as it is, velocities to the fastest of
    /// them.
    Real relative_step(const Real* y) const {
        const auto velocities = Eigen::Map<const VecX>(y, unknowns_).tail(unknowns_ - configuration_);
        const Real rate = velocities.cwiseQuotient(column_unit_.tail(velocities.size())).lpNorm<Eigen::Infinity>();
        const auto change = solution_.head(unknowns_).cwiseAbs();
        const Real placed = change.head(configuration_).maxCoeff(), moved = change.tail(velocities.size()).maxCoeff();
        return rate > 0 ? max(placed, Real(moved / rate)) : placed;
    }

    /// Powers of two that make the matrix nearly free of units, so that pivoting compares like with like: lengths over
    /// one of the mechanism, and masses over one of its masses.
    void set_units(bool mass_weighted) {
        if (row_scale_.size() == 0) return;
        const Real length = power_of_two_below(row_scale_.maxCoeff());
        for (int body = 0; body < system_.bodies(); ++body)
            for (const Eigen::Index first : {Eigen::Index(body_size * body), configuration_ + 6 * body})
                column_unit_.segment<3>(first).setConstant(length);
        row_unit_.head(joint_rows_).setConstant(1 / length);
        const Real unit = mass_weighted ? Real(power_of_two_below(weight_(0, 0)) * length * length) : Real(1);
        weight_ = column_unit_.asDiagonal() * weight_ * column_unit_.asDiagonal() / unit;
    }

    /// Fills residual_, jacobian_ and kkt_.
    void linearise(const Real& t, const Real* y) {
        const Real* v = system_.v(y);
        system_.position_residual(t, y, residual_.data());
        system_.velocity_residual(t, y, v, residual_.data() + system_.constraints());
        system_.ambient_jacobian(t, y, v, joint_jacobian_.data());
        jacobian_.topRows(joint_rows_) = joint_jacobian_;
        for (int body = 0; body < system_.bodies(); ++body) add_orthogonality(body, mat3(y + body_size * body + 3));
        kkt_.bottomLeftCorner(rows_, unknowns_) = row_unit_.asDiagonal() * jacobian_ * column_unit_.asDiagonal();
        kkt_.topRightCorner(unknowns_, rows_) = kkt_.bottomLeftCorner(rows_, unknowns_).transpose();
    }

    /// Rows (R R^T - I)_jk, j <= k: sum_c R_jc R_kc.
    void add_orthogonality(int body, const Mat3& R) {
        Eigen::Index row = joint_rows_ + 6 * body;
        const Eigen::Index first = body_size * body + 3;
        for (int j = 0; j < 3; ++j)
            for (int k = j; k < 3; ++k, ++row) {
                residual_[row] = R.row(j).dot(R.row(k)) - (j == k ? 1 : 0);
                for (int c = 0; c < 3; ++c) {
                    jacobian_(row, first + 3 * c + j) = R(k, c) * (j == k ? 2 : 1);
                    if (j != k) jacobian_(row, first + 3 * c + k) = R(j, c);
                }
            }
    }

    void set_mass_weight() {
        std::vector<Real> blocks(static_cast<std::size_t>(36 * system_.bodies()));
        system_.mass(nullptr, blocks.data());
        for (int body = 0; body < system_.bodies(); ++body) {
            const Eigen::Map<const Eigen::Matrix<Real, 6, 6>> M(&blocks[static_cast<std::size_t>(36 * body)]);
            const Eigen::Index x = body_size * body;
            weight_.block<3, 3>(x, x) = M.topLeftCorner<3, 3>();
            const Mat3 J = M.bottomRightCorner<3, 3>();
            const Mat3 D = J.trace() / 2 * Mat3::Identity() - J;
            for (int j = 0; j < 3; ++j)
                for (int k = 0; k < 3; ++k)
                    weight_.block<3, 3>(x + 3 + 3 * j, x + 3 + 3 * k) = D(j, k) * Mat3::Identity();
            weight_.block<6, 6>(configuration_ + 6 * body, configuration_ + 6 * body) = M;
        }
    }

    System& system_;
    bool once_;
    Eigen::Index configuration_, unknowns_, joint_rows_, rows_;
    MatX weight_, joint_jacobian_, jacobian_;
    VecX column_unit_, row_unit_, row_scale_, terms_;
    VecX residual_, start_, shift_;
    MatX kkt_;
    VecX rhs_, solution_;
    Eigen::PartialPivLU<MatX> lu_;
};

}  // namespace

KREISEL_PROJECTION(
    {.name = "terze",
     .summary = "the seed's projection: positions and velocities jointly, R in R^{3x3} with orthogonality rows",
     .cites = {"terzezlatarmueller"},
     .options = {{.name = "weight",
                  .summary = "norm of the minimisation",
                  .standard = "identity",
                  .choices = {"identity", "mass"}},
                 iterations_option()},
     .formulations = {"SO3xR3"},
     .positions = true,
     .velocities = true,
     .ambient = true},
    [](System& system, const OptionValues& options) {
        const bool mass_weighted = std::get<std::string>(options.at("weight")) == "mass";
        return std::make_unique<TerzeProjection>(system, mass_weighted, is_once(options));
    });

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
