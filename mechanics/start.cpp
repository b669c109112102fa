// SPDX-License-Identifier: BSD-3-Clause
#include "mechanics/start.hpp"

#include <Eigen/Cholesky>
#include <Eigen/QR>
#include <sstream>

#include "lie/so3.hpp"
#include "mechanics/formulation.hpp"
#include "mechanics/joints/joint_rows.hpp"
#include "mechanics/model/scales.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

namespace {

/// By how much of its scale a start may violate a row: data have about ten digits.
const Real tolerance = Real(1) / 1000000000;
/// Round-off of data that came through double precision, relative to distances from the origin and to speeds; and
/// the round-off of arithmetic on them.
const Real data_round_off = Real(1) / 281474976710656, noise = Real(1) / 10000000000000;
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
          size_(extent(model)),
          place_(remoteness(model)),
          scale_(m_) {
        system_->row_scale(scale_.data());
    }

    System& system() { return *system_; }
    Real* q() { return y_.data(); }
    Real* v() { return system_->v(y_.data()); }
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
        const VecX weights = scale_.head(rows).cwiseInverse();
        const MatX C = weights.asDiagonal() * jacobian().topRows(rows), root = mass_root();
        const auto L = root.triangularView<Eigen::Lower>();
        const MatX A = L.solve(MatX(C.transpose())).transpose();
        const Eigen::Index rank = geometric_rank(C);
        if (rank == 0) return VecX::Zero(n_);
        Eigen::CompleteOrthogonalDecomposition<MatX> solver;
        solver.setThreshold(threshold_of(rank, A));
        solver.compute(A);
        return root.transpose().triangularView<Eigen::Upper>().solve(
            VecX(solver.solve(VecX(-weights.cwiseProduct(residual.head(rows))))));
    }
    /// Norm of a residual, each row divided by its scale.
    Real size_of(const VecX& residual) const { return residual.cwiseQuotient(scale_).norm(); }

    /// Whether every row of Phi is round-off of its terms.
    bool is_round_off(const VecX& phi) {
        VecX terms = VecX::Zero(m_);
        system_->position_scale(q(), terms.data());
        return (phi.cwiseAbs().array() <= epsilon * terms.array()).all();
    }
    /// Throws unless every row of Phi is at most 1e-9 of its scale, plus round-off.
    void require_positions() {
        VecX terms = VecX::Zero(m_);
        system_->position_scale(q(), terms.data());
        require(position_residual(), tolerance * scale_ + data_round_off * terms, "position", "");
    }
    /// Throws unless every row of C v + b is at most 1e-9 of its scale times the rate of the motion, plus round-off.
    void require_velocities() {
        VecX allowed = tolerance * rate() * scale_;
        const Real round_off = data_round_off * speed_round_off();
        each_row([&](std::size_t joint, int k, Eigen::Index row) {
            if (!is_direction_row(model_.joints[joint].type, k)) allowed[row] += round_off;
        });
        require(velocity_residual(), allowed, "velocity", "/s");
    }
    /// Rate of the motion (1/s): the largest of |omega|, |v| over the extent, the frequencies of driven rods, and the
    /// rates the forces cause from rest, sqrt(|force| / (mass extent)) and sqrt(|torque| / moment of inertia).
    Real rate() {
        VecX force(n_);
        system_->applied_force(0, q(), v(), force.data());
        Real rate = speed();
        for (const Joint& joint : model_.joints) rate = max(rate, Real(abs(joint.amplitude * joint.frequency)));
        for (std::size_t i = 0; i < model_.bodies.size(); ++i) {
            const Body& body = model_.bodies[i];
            const auto at = 6 * static_cast<Eigen::Index>(i);
            rate = max(rate, Real(sqrt(force.segment<3>(at + 3).norm() / (body.J.trace() / 2))));
            if (size_ > 0) rate = max(rate, Real(sqrt(force.segment<3>(at).norm() / (body.mass * size_))));
        }
        return rate;
    }
    /// The largest of |omega| and |v| over the extent (1/s).
    Real speed() {
        const Real linear = size_ > 0 ? Real(largest_part(0) / size_) : Real(0);
        return max(linear, largest_part(3));
    }
    /// Projecting out a motion that the joints do not allow leaves round-off: zero it.
    void stop_noise(const Real& speed_before) {
        if (speed() <= noise * speed_before) velocities().setZero();
    }
    /// Whether a correction is round-off of arithmetic on the data. A position's round-off rotates a body by that
    /// over the size of the mechanism.
    bool is_noise(const StartCorrection& moved) {
        const Real apart = size_ > 0 ? Real(1 + place_ / size_) : Real(1);
        return moved.position <= noise * max(size_, place_) && moved.rotation <= noise * apart &&
               moved.velocity <= noise * max(Real(rate() * size_), speed_round_off()) &&
               moved.omega <= noise * rate() * apart;
    }

    /// Rows of C that are lengths.
    std::vector<Eigen::Index> length_rows() const {
        std::vector<Eigen::Index> rows;
        each_row([&](std::size_t joint, int k, Eigen::Index row) {
            if (!is_direction_row(model_.joints[joint].type, k)) rows.push_back(row);
        });
        return rows;
    }

  private:
    /// L of M = L L^T, masses in the mechanism's unit.
    MatX mass_root() {
        std::vector<Real> blocks(static_cast<std::size_t>(n_ * system_->mass_block()));
        system_->mass(q(), blocks.data());
        MatX root = MatX::Zero(n_, n_);
        const Real unit = mass_unit(model_);
        for (Eigen::Index i = 0; i < n_; i += 6) {
            const Mat6 M = Eigen::Map<const Mat6>(&blocks[static_cast<std::size_t>(6 * i)]) / unit;
            root.block<6, 6>(i, i) = M.llt().matrixL();
        }
        return root;
    }
    /// Rank of C, torques divided by lengths and rows by their norms: independent of masses and units.
    Eigen::Index geometric_rank(MatX C) const {
        const std::vector<Real> lengths = body_lengths(model_);
        for (std::size_t i = 0; i < lengths.size(); ++i)
            if (lengths[i] > 0) C.middleCols(6 * static_cast<Eigen::Index>(i) + 3, 3) /= lengths[i];
        Eigen::ColPivHouseholderQR<MatX> qr;
        qr.setThreshold(Real(1) / 1000000);
        qr.compute(MatX(C.transpose()).colwise().normalized());
        return qr.rank();
    }
    /// A threshold between the pivots of A that yields this rank.
    static Real threshold_of(Eigen::Index rank, const MatX& A) {
        const Eigen::ColPivHouseholderQR<MatX> qr(A);
        const auto pivot = [&](Eigen::Index i) {
            return i < min(A.rows(), A.cols()) ? Real(abs(qr.matrixQR()(i, i))) : Real(0);
        };
        return (pivot(rank - 1) + pivot(rank)) / (2 * qr.maxPivot());
    }
    /// Largest |v| (part 0) or |omega| (part 3) of a body.
    Real largest_part(Eigen::Index part) {
        Real largest = 0;
        for (Eigen::Index i = part; i < n_; i += 6) largest = max(largest, Real(velocities().segment<3>(i).norm()));
        return largest;
    }
    /// What speeds and distances from the origin contribute (m/s).
    Real speed_round_off() { return largest_part(0) + largest_part(3) * place_; }
    void require(const VecX& residual, const VecX& allowed, const char* level, const char* second) const {
        if ((residual.cwiseAbs().array() <= allowed.array()).all()) return;
        throw ParameterError("", std::string("the start violates the joints at ") + level +
                                     " level; residual of each: " + by_joint(residual, second));
    }
    /// "joint 1 (upper - lower, spherical): 0.02 m" for each joint; rows that compare directions have no length.
    std::string by_joint(const VecX& residual, const char* second) const {
        std::vector<Real> lengths(model_.joints.size(), 0), directions = lengths;
        each_row([&](std::size_t joint, int k, Eigen::Index row) {
            (is_direction_row(model_.joints[joint].type, k) ? directions : lengths)[joint] +=
                residual[row] * residual[row];
        });
        std::ostringstream out;
        for (std::size_t j = 0; j < model_.joints.size(); ++j) {
            out << (j > 0 ? ", " : "") << model_.name_of_joint(j) << ": " << to_double(sqrt(lengths[j])) << " m"
                << second;
            if (has_direction_rows(model_.joints[j].type))
                out << " and " << to_double(sqrt(directions[j])) << (*second ? " 1" : "") << second;
        }
        return out.str();
    }
    /// Calls f(joint, its row, row of C) for all rows.
    template <class F>
    void each_row(F f) const {
        Eigen::Index position = 0, velocity = system_->position_constraints();
        for (std::size_t j = 0; j < model_.joints.size(); ++j)
            for (int k = 0; k < rows_of(model_.joints[j].type); ++k)
                f(j, k, k < position_rows_of(model_.joints[j].type) ? position++ : velocity++);
    }

    const Model& model_;
    std::unique_ptr<System> system_;
    std::vector<Real> y_;
    Eigen::Index m_, n_;
    Real size_, place_;
    VecX scale_;
};

/// Throws where the axes of a torsion spring have parted so far that its turns have no meaning.
void check_springs(const Model& model) {
    if (model.torsion_springs.empty()) return;
    const auto system = formulation(coordinates).make(model);
    const std::vector<Real> y = initial_state(*system, model);
    if (system->begin_step(0, 0, y.data()) != Status::ok) throw ParameterError("", system->reason(Status::turn_lost));
}

}  // namespace

void check_start(const Model& model) {
    check_springs(model);
    if (model.joints.empty()) return;
    Start start(model);
    start.require_positions();
    start.require_velocities();
    System& system = start.system();
    std::vector<Real> dv(static_cast<std::size_t>(system.velocities()));
    if (system.accelerations(0, start.q(), start.v(), dv.data(), nullptr) == Status::singular_kkt)
        throw ParameterError("", "the joints contradict each other in the initial configuration, or lose rank there: " +
                                     system.reason(Status::singular_kkt));
}

StartCorrection project_start(Model& model) {
    if (model.joints.empty()) return {};
    Start start(model);
    const System& system = start.system();
    const Eigen::Index positions = system.position_constraints();
    constexpr int most_steps = 50;
    VecX phi = start.position_residual();
    for (int i = 0; i < most_steps; ++i) {
        const Real before = start.size_of(phi);
        const VecX step = start.correction(positions, phi);
        system.group().append_exp(start.q(), step.data(), start.q());
        phi = start.position_residual();
        if (start.is_round_off(phi)) break;
        if (i > 2 && start.size_of(phi) > before / 2) break;  // round-off amplified, or no convergence
    }
    start.require_positions();
    const Real speed = start.speed();
    for (int i = 0; i < 2; ++i) start.velocities() += start.correction(system.constraints(), start.velocity_residual());
    start.stop_noise(speed);
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
    moved.noise = start.is_noise(moved);
    start.require_velocities();
    for (std::size_t i = 0; i < states.size(); ++i) model.bodies[i].start = states[i];
    return moved;
}

void complete_velocities(Model& model, const std::vector<bool>& given) {
    std::vector<Eigen::Index> unknown;  // columns of x' of bodies without a given velocity
    for (std::size_t i = 0; i < given.size(); ++i) {
        if (given[i]) continue;
        model.bodies[i].start.v.setZero();
        for (Eigen::Index k = 0; k < 3; ++k) unknown.push_back(6 * static_cast<Eigen::Index>(i) + k);
    }
    if (unknown.empty() || model.joints.empty()) return;
    Start start(model);
    // Rows that compare directions do not depend on x', and their residuals have another unit.
    const std::vector<Eigen::Index> rows = start.length_rows();
    const MatX C = start.jacobian();
    const VecX residual = start.velocity_residual();
    MatX columns(static_cast<Eigen::Index>(rows.size()), static_cast<Eigen::Index>(unknown.size()));
    VecX wanted(columns.rows());
    for (Eigen::Index i = 0; i < columns.rows(); ++i) {
        const Eigen::Index row = rows[static_cast<std::size_t>(i)];
        wanted[i] = -residual[row];
        for (Eigen::Index k = 0; k < columns.cols(); ++k) columns(i, k) = C(row, unknown[static_cast<std::size_t>(k)]);
    }
    const VecX v = columns.completeOrthogonalDecomposition().solve(wanted);
    for (Eigen::Index k = 0; k < v.size(); ++k) {
        const Eigen::Index column = unknown[static_cast<std::size_t>(k)];
        model.bodies[static_cast<std::size_t>(column / 6)].start.v[column % 6] = v[k];
    }
}

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
