// SPDX-License-Identifier: BSD-3-Clause
#include "engine/reference/taylor_series.hpp"

#include <Eigen/QR>
#include <algorithm>
#include <array>
#include <stdexcept>

namespace kreisel {
inline namespace KREISEL_PRECISION {

namespace {

/// Below this ratio of pivots a row counts as dependent: a start may violate its joints by 1e-9.
const Real dependence = Real(1) / 10000000;
/// Pivots of S are squares of those, except for the masses: below this fraction of its diagonal, rank is determined
/// anew.
const Real doubtful = Real(1) / 10000000000;

}  // namespace

TaylorSeries::TaylorSeries(const Model& model, int order) : order_(static_cast<std::size_t>(order)) {
    if (order < 2) throw std::invalid_argument("a Taylor series of motion needs an order of at least 2");
    for (const Body& body : model.bodies) bodies_.emplace_back(body, order_ + 2);
    bodies_.push_back(BodySeries::fixed(order_ + 2));
    add_forces(model);
    for (const Joint& joint : model.joints) {
        joints_.emplace_back(joint, at(joint.first), at(joint.second));
        for (int row = 0; row < joints_.back().rows(); ++row)
            rows_.push_back({joints_.size() - 1, row, joints_.back().scale(row)});
    }
    for (const BodySeries& body : bodies_) lengths_.push_back(body.radius());
    for (const Joint& joint : model.joints)
        for (const auto& [body, arm] : {std::pair(joint.first, joint.r_first), std::pair(joint.second, joint.r_second)})
            if (body != ground) {
                Real& length = lengths_[static_cast<std::size_t>(body)];
                length = max(length, Real(arm.norm()));
            }
    reaction_.resize(bodies_.size());
    A_.resize(6 * static_cast<Eigen::Index>(model.bodies.size()), static_cast<Eigen::Index>(rows_.size()));
}

void TaylorSeries::add_forces(const Model& model) {
    for (std::size_t i = 0; i < model.bodies.size(); ++i)
        forces_.push_back(std::make_unique<GravitySeries>(model.gravity, model.bodies[i].mass, bodies_[i]));
    for (const Load& load : model.loads) forces_.push_back(std::make_unique<LoadSeries>(load, at(load.body)));
    for (const Spring& spring : model.springs)
        forces_.push_back(std::make_unique<SpringSeries>(spring, at(spring.first), at(spring.second)));
    for (const TorsionSpring& spring : model.torsion_springs)
        forces_.push_back(std::make_unique<TorsionSpringSeries>(spring, at(spring.first), at(spring.second)));
}

void TaylorSeries::weigh() {
    A_.setZero();
    for (std::size_t c = 0; c < rows_.size(); ++c) {
        const auto& [index, row, scale] = rows_[c];
        const JointSeries& joint = joints_[index];
        const auto add = [&, size = scale](const BodySeries& body, const JointSeries::Wrench& wrench) {
            if (body.is_fixed()) return;
            const auto place = 6 * static_cast<Eigen::Index>(&body - bodies_.data());
            A_.block<6, 1>(place, static_cast<Eigen::Index>(c)) += body.weighted(wrench.force, wrench.moment) / size;
        };
        add(joint.first(), joint.on_first(row)), add(joint.second(), joint.on_second(row));
    }
}

/// False where the rank has changed since the first expansion.
bool TaylorSeries::decompose() {
    weigh();
    if ((factored_ = rank_ == A_.cols() && factor() > doubtful)) return true;
    const Eigen::Index rank = geometric_rank();
    if (rank_ < 0) rank_ = rank;
    if (rank != rank_) return false;
    if ((factored_ = rank == A_.cols() && factor() > 0)) return true;
    if (rank == 0) {
        inverse_.setZero(A_.cols(), A_.rows());
        return true;
    }
    Eigen::CompleteOrthogonalDecomposition<MatX> decomposition(A_.rows(), A_.cols());
    const auto pivot = [&, qr = Eigen::ColPivHouseholderQR<MatX>(A_)](Eigen::Index i) {
        return i < min(A_.rows(), A_.cols()) ? Real(abs(qr.matrixQR()(i, i))) : Real(0);
    };
    decomposition.setThreshold((pivot(rank - 1) + pivot(rank)) / (2 * pivot(0)));
    decomposition.compute(A_);
    inverse_ = decomposition.pseudoInverse();
    return decomposition.rank() == rank;
}

/// Of C^T with torques over lengths of their bodies and columns of length 1: independent of masses and units.
Eigen::Index TaylorSeries::geometric_rank() const {
    MatX C = MatX::Zero(A_.rows(), A_.cols());
    for (std::size_t c = 0; c < rows_.size(); ++c) {
        const JointSeries& joint = joints_[rows_[c].joint];
        const auto add = [&](const BodySeries& body, const JointSeries::Wrench& wrench) {
            if (body.is_fixed()) return;
            const Real& length = lengths_[static_cast<std::size_t>(&body - bodies_.data())];
            Eigen::Matrix<Real, 6, 1> both;
            both << wrench.force, wrench.moment / (length > 0 ? length : Real(1));
            C.block<6, 1>(6 * (&body - bodies_.data()), static_cast<Eigen::Index>(c)) += both;
        };
        add(joint.first(), joint.on_first(rows_[c].row)), add(joint.second(), joint.on_second(rows_[c].row));
    }
    Eigen::ColPivHouseholderQR<MatX> qr;
    qr.setThreshold(dependence);
    qr.compute(C.colwise().normalized());
    return qr.rank();
}

/// S = L L^T, entry by entry: most joints share no body.
Real TaylorSeries::factor() {
    MatX S = MatX::Zero(A_.cols(), A_.cols());
    const auto share = [&](std::size_t a, std::size_t b, Eigen::Index i, Eigen::Index j) {
        for (const BodySeries* body : {&joints_[a].first(), &joints_[a].second()}) {
            if (body->is_fixed() || (body != &joints_[b].first() && body != &joints_[b].second())) continue;
            const auto place = 6 * (body - bodies_.data());
            S(i, j) += A_.block<6, 1>(place, i).dot(A_.block<6, 1>(place, j));
        }
    };
    for (Eigen::Index i = 0; i < S.rows(); ++i)
        for (Eigen::Index j = 0; j <= i; ++j)
            share(rows_[static_cast<std::size_t>(i)].joint, rows_[static_cast<std::size_t>(j)].joint, i, j);
    cholesky_.compute(S);
    const auto& L = cholesky_.matrixLLT();
    if (cholesky_.info() != Eigen::Success) return 0;
    Real smallest = 1;
    for (Eigen::Index i = 0; i < S.rows(); ++i) smallest = min(smallest, Real(L(i, i) * L(i, i) / S(i, i)));
    return smallest;
}

VecX TaylorSeries::solve(const VecX& residual) const {
    return factored_ ? VecX(cholesky_.solve(residual)) : VecX(inverse_ * (inverse_.transpose() * residual));
}

VecX TaylorSeries::terms() const {
    VecX sizes = VecX::Zero(A_.cols());
    for (std::size_t c = 0; c < rows_.size(); ++c) {
        const auto& [index, row, scale] = rows_[c];
        const JointSeries& joint = joints_[index];
        const auto add = [&, size = scale](const BodySeries& body, const JointSeries::Wrench& wrench) {
            if (body.is_fixed()) return;
            sizes[static_cast<Eigen::Index>(c)] +=
                (wrench.force.norm() * body.acceleration_size() + wrench.moment.norm() * body.turning_size()) / size +
                body.omega[0].squaredNorm();
        };
        add(joint.first(), joint.on_first(row)), add(joint.second(), joint.on_second(row));
    }
    return sizes;
}

/// Whether the residual has a part outside the range of S above round-off and drift of its terms.
bool TaylorSeries::contradicts(const VecX& residual) const {
    if (rank_ == A_.cols()) return false;
    const Real rest = (residual - A_.transpose() * (inverse_.transpose() * residual)).norm();
    return rest > (residual.norm() + terms().norm()) / 1000000;
}

/// Coefficient k of the multipliers, and their effects.
Status TaylorSeries::react(std::size_t k) {
    for (JointSeries& joint : joints_) joint.update(k);
    if (k == 0 && !decompose()) return Status::singular_kkt;
    VecX residual(A_.cols());
    for (std::size_t c = 0; c < rows_.size(); ++c)
        residual[static_cast<Eigen::Index>(c)] = joints_[rows_[c].joint].acceleration(rows_[c].row, k) / rows_[c].scale;
    if (k == 0 && contradicts(residual)) return Status::singular_kkt;
    const VecX lambda = solve(residual);
    for (JointSeries::Wrench& sum : reaction_) sum = {Vec3::Zero(), Vec3::Zero()};
    for (std::size_t c = 0; c < rows_.size(); ++c) {
        const auto& [index, row, scale] = rows_[c];
        JointSeries& joint = joints_[index];
        const Real value = lambda[static_cast<Eigen::Index>(c)] / scale;
        joint.set_multiplier(row, k, value);
        const auto add = [&](BodySeries& body, const JointSeries::Wrench& wrench) {
            if (k == 0) body.notice(value * wrench.force, value * wrench.moment);
            JointSeries::Wrench& sum = reaction_[static_cast<std::size_t>(&body - bodies_.data())];
            sum.force -= value * wrench.force, sum.moment -= value * wrench.moment;
        };
        add(joint.first(), joint.on_first(row)), add(joint.second(), joint.on_second(row));
    }
    for (std::size_t i = 0; i + 1 < bodies_.size(); ++i) bodies_[i].correct(reaction_[i].force, reaction_[i].moment, k);
    for (JointSeries& joint : joints_) joint.update(k);
    return Status::ok;
}

Status TaylorSeries::expand(const Real& t, const std::vector<BodyState>& states) {
    Real sum = 0;
    for (const BodyState& s : states) sum += s.x.sum() + s.R.sum() + s.v.sum() + s.omega.sum();
    if (!isfinite(sum)) return Status::non_finite;
    for (std::size_t i = 0; i < states.size(); ++i) bodies_[i].start(states[i]);
    for (const auto& force : forces_) {
        force->start(t);
        if (force->has_parted(0)) return Status::turn_lost;
    }
    for (JointSeries& joint : joints_) joint.start(t);
    for (std::size_t k = 0; k < order_; ++k) {
        for (BodySeries& body : bodies_) body.begin(k);
        for (const auto& force : forces_) force->act(k);
        for (JointSeries& joint : joints_) joint.react(k);
        for (std::size_t i = 0; i < states.size(); ++i) bodies_[i].advance(k);
        if (joints_.empty()) continue;
        if (const Status status = react(k); status != Status::ok) return status;
    }
    for (const BodySeries& body : bodies_)
        for (const Real& last : {body.v[order_].sum(), body.omega[order_].sum(), body.R[order_].sum()})
            if (!isfinite(last)) return Status::non_finite;
    return Status::ok;
}

void TaylorSeries::move_on(const Real& s) {
    for (const auto& force : forces_) force->move_on(s);
}

bool TaylorSeries::has_parted(const Real& s) const {
    return std::any_of(forces_.begin(), forces_.end(), [&](const auto& force) { return force->has_parted(s); });
}

Real TaylorSeries::reach(const Real& limit) const {
    // Squared norms of the coefficients, over all bodies.
    std::vector<std::array<Real, 4>> squares(order_ + 1);
    for (std::size_t k = 0; k <= order_; ++k)
        for (const BodySeries& body : bodies_) {
            squares[k][0] += body.x[k].squaredNorm(), squares[k][1] += body.R[k].squaredNorm();
            squares[k][2] += body.v[k].squaredNorm(), squares[k][3] += body.omega[k].squaredNorm();
        }
    Real linear = 0, angular = 0;
    for (const BodySeries& body : bodies_) {
        const Real a = body.acceleration_size(), alpha = body.turning_size();
        linear += a * a, angular += alpha * alpha;
    }
    const auto small = [&](const Real& s) {
        const Real square = s * s;
        std::array<Real, 4> largest = {linear * square * square, 0, linear * square, angular * square};
        Real power = 1;
        for (std::size_t k = 0; k <= order_; ++k, power *= square)
            for (std::size_t part = 0; part < largest.size(); ++part) {
                const Real term = squares[k][part] * power;
                if (k + 1 >= order_ && term > epsilon * epsilon * largest[part]) return false;
                largest[part] = max(largest[part], term);
            }
        return true;
    };
    Real s = limit;
    while (!small(s)) s = 7 * s / 8;
    return s;
}

std::vector<BodyState> TaylorSeries::states(const Real& s) const {
    std::vector<BodyState> result;
    for (std::size_t i = 0; i + 1 < bodies_.size(); ++i) {
        const BodySeries& body = bodies_[i];
        BodyState state{body.x[order_], body.R[order_], body.v[order_], body.omega[order_]};
        for (std::size_t k = order_; k-- > 0;) {
            state.x = state.x * s + body.x[k], state.R = state.R * s + body.R[k];
            state.v = state.v * s + body.v[k], state.omega = state.omega * s + body.omega[k];
        }
        result.push_back(state);
    }
    return result;
}

std::vector<Real> TaylorSeries::multipliers() const {
    std::vector<Real> lambda;
    for (const bool velocity : {false, true})
        for (const Row& row : rows_)
            if (joints_[row.joint].is_velocity(row.row) == velocity)
                lambda.push_back(joints_[row.joint].multiplier(row.row));
    return lambda;
}

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
