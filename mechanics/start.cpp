// SPDX-License-Identifier: BSD-3-Clause
#include <Eigen/Cholesky>
#include <Eigen/QR>
#include <sstream>

#include "lie/so3.hpp"
#include "mechanics/formulation.hpp"
#include "mechanics/joint_rows.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

namespace {

const Real tolerance = Real(1) / 1000000000;
constexpr const char* coordinates = "SO3xR3";

/// A model's start in the coordinates of SO3xR3, with the residuals of its rows.
class Start {
  public:
    explicit Start(const Model& model)
        : model_(model),
          system_(formulation(coordinates).make(model)),
          y_(initial_state(*system_, model)),
          m_(system_->constraints()),
          n_(system_->velocities()),
          scale_(m_) {
        system_->row_scale(scale_.data());
    }

    System& system() { return *system_; }
    Real* q() { return y_.data(); }
    Real* v() { return y_.data() + system_->group().size(); }
    Eigen::Map<VecX> velocities() { return Eigen::Map<VecX>(v(), n_); }

    VecX position_residual() {
        VecX phi = VecX::Zero(m_);
        system_->position_residual(0, q(), phi.data());
        return phi;
    }
    VecX velocity_residual() {
        VecX rate(m_);
        system_->velocity_residual(0, q(), v(), rate.data());
        return rate;
    }
    MatX jacobian() {
        MatX C(m_, n_);
        system_->jacobian(0, q(), C.data());
        return C;
    }
    /// The least change in the metric M with C change = -residual, rows divided by their scale.
    VecX correction(Eigen::Index rows, const VecX& residual) {
        std::vector<Real> blocks(static_cast<std::size_t>(n_ * system_->mass_block()));
        system_->mass(q(), blocks.data());
        MatX root = MatX::Zero(n_, n_);  // M = L L^T
        for (Eigen::Index i = 0; i < n_; i += 6)
            root.block<6, 6>(i, i) = Eigen::Map<const Mat6>(&blocks[static_cast<std::size_t>(6 * i)]).llt().matrixL();
        const auto L = root.triangularView<Eigen::Lower>();
        const VecX weights = scale_.head(rows).cwiseInverse();
        const MatX A = L.solve(MatX((weights.asDiagonal() * jacobian().topRows(rows)).transpose())).transpose();
        Eigen::CompleteOrthogonalDecomposition<MatX> solver;
        solver.setThreshold(Real(1) / 1000000);
        solver.compute(A);
        return root.transpose().triangularView<Eigen::Upper>().solve(VecX(solver.solve(VecX(-weights.cwiseProduct(residual.head(rows))))));
    }

    /// Throws unless every row is at most 1e-9 of its size: its scale, times `rate` at velocity level.
    void require_small(const VecX& residual, const Real& rate, const char* level, const char* second) {
        if ((residual.cwiseAbs().array() <= tolerance * rate * scale_.array()).all()) return;
        throw ParameterError("", std::string("the start violates the joints at ") + level +
                                     " level; residual of each: " + by_joint(residual, second));
    }
    /// Largest of 1/s, |omega| and |v| over the arms of the joints.
    Real rate() const {
        const Real length = m_ > 0 ? scale_.maxCoeff() : Real(1);
        Real rate = 1;
        for (const Body& body : model_.bodies)
            rate = max(rate, max(Real(body.start.omega.norm()), Real(body.start.v.norm() / length)));
        return rate;
    }

  private:
    /// "joint 1 (upper - lower, spherical): 0.02 m" for each joint; rows that compare directions have no length.
    std::string by_joint(const VecX& residual, const char* second) const {
        std::ostringstream out;
        Eigen::Index position = 0, velocity = system_->position_constraints();
        for (std::size_t j = 0; j < model_.joints.size(); ++j) {
            const JointType type = model_.joints[j].type;
            Real lengths = 0, directions = 0;
            for (int k = 0; k < rows_of(type); ++k) {
                const Real r = residual[k < position_rows_of(type) ? position++ : velocity++];
                (is_direction_row(type, k) ? directions : lengths) += r * r;
            }
            out << (j > 0 ? ", " : "") << model_.name_of_joint(j) << ": " << to_double(sqrt(lengths)) << " m" << second;
            if (has_direction_rows(type)) out << " and " << to_double(sqrt(directions)) << (*second ? " 1" : "") << second;
        }
        return out.str();
    }

    const Model& model_;
    std::unique_ptr<System> system_;
    std::vector<Real> y_;
    Eigen::Index m_, n_;
    VecX scale_;
};

}  // namespace

void check_start(const Model& model) {
    if (model.joints.empty()) return;
    Start start(model);
    start.require_small(start.position_residual(), 1, "position", "");
    start.require_small(start.velocity_residual(), start.rate(), "velocity", "/s");
    System& system = start.system();
    std::vector<Real> dv(static_cast<std::size_t>(system.velocities()));
    if (system.accelerations(0, start.q(), start.v(), dv.data(), nullptr) == Status::singular_kkt)
        throw ParameterError("", "the joints contradict each other in the initial configuration, or lose rank there: " +
                                     system.singularity());
}

StartCorrection project_start(Model& model) {
    if (model.joints.empty()) return {};
    Start start(model);
    const System& system = start.system();
    const Eigen::Index positions = system.position_constraints();
    constexpr int most_steps = 50;
    VecX phi = start.position_residual();
    for (int i = 0; i < most_steps; ++i) {
        const Real before = phi.norm();
        const VecX step = start.correction(positions, phi);
        system.group().append_exp(start.q(), step.data(), start.q());
        phi = start.position_residual();
        if (i > 2 && phi.norm() > before / 2) break;  // round-off, or no convergence
    }
    start.require_small(phi, 1, "position", "");
    for (int i = 0; i < 2; ++i) start.velocities() += start.correction(system.constraints(), start.velocity_residual());
    std::vector<BodyState> states(model.bodies.size());
    system.read(start.q(), states.data());
    StartCorrection moved;
    for (std::size_t i = 0; i < states.size(); ++i) {
        const BodyState& old = model.bodies[i].start;
        moved.position = max(moved.position, Real((states[i].x - old.x).norm()));
        moved.rotation = max(moved.rotation, Real(SO3::log(old.R.transpose() * states[i].R).norm()));
        moved.velocity = max(moved.velocity, Real((states[i].v - old.v).norm()));
        moved.omega = max(moved.omega, Real((states[i].omega - old.omega).norm()));
    }
    start.require_small(start.velocity_residual(), start.rate(), "velocity", "/s");
    for (std::size_t i = 0; i < states.size(); ++i) model.bodies[i].start = states[i];
    return moved;
}

void complete_velocities(Model& model, const std::vector<bool>& given) {
    std::vector<Eigen::Index> unknown;  // columns of x' of the bodies that have none
    for (std::size_t i = 0; i < given.size(); ++i) {
        if (given[i]) continue;
        model.bodies[i].start.v.setZero();
        for (Eigen::Index k = 0; k < 3; ++k) unknown.push_back(6 * static_cast<Eigen::Index>(i) + k);
    }
    if (unknown.empty() || model.joints.empty()) return;
    Start start(model);
    const MatX C = start.jacobian();
    MatX columns(C.rows(), static_cast<Eigen::Index>(unknown.size()));
    for (Eigen::Index k = 0; k < columns.cols(); ++k) columns.col(k) = C.col(unknown[static_cast<std::size_t>(k)]);
    const VecX v = columns.completeOrthogonalDecomposition().solve(VecX(-start.velocity_residual()));
    for (Eigen::Index k = 0; k < v.size(); ++k) {
        const Eigen::Index column = unknown[static_cast<std::size_t>(k)];
        model.bodies[static_cast<std::size_t>(column / 6)].start.v[column % 6] = v[k];
    }
}

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
