// SPDX-License-Identifier: BSD-3-Clause
#include "methods/projection/dependent_coordinates.hpp"

#include <numeric>

namespace kreisel {
inline namespace KREISEL_PRECISION {

namespace {

class DependentCoordinates final : public Correction {
  public:
    explicit DependentCoordinates(System& system)
        : system_(system),
          rows_(system),
          joint_rows_(system.constraint_rows()),
          unit_(VecX::Ones(system.velocities())),
          row_unit_(system.constraints()),
          work_(system.constraints(), system.velocities()),
          right_(system.constraints()),
          columns_(static_cast<std::size_t>(system.velocities())) {}

    void start() override { pivot_at_choice_ = 0; }

    Status solve(const Real& t, const Real* q, const Real* c, Real* delta) override {
        if (!rows_.evaluate(system_, t, q)) return Status::non_finite;
        set_units();
        right_ = Eigen::Map<const VecX>(c, right_.size()).cwiseQuotient(row_unit_);
        const bool keeps = pivot_at_choice_ > 0 && 10 * eliminate() >= pivot_at_choice_;
        if (!keeps) {
            choose();
            right_ = Eigen::Map<const VecX>(c, right_.size()).cwiseQuotient(row_unit_);
            pivot_at_choice_ = eliminate();
            if (!(pivot_at_choice_ > dependent_pivot)) return Status::singular_kkt;
        }
        substitute(delta);
        return Status::ok;
    }

  private:
    /// Divides each row by its largest entry, translations over the longest arm: all pivots are at most about 1.
    void set_units() {
        const Real arm = longest_arm();
        if (arm > 0)
            for (Eigen::Index i = 0; i < unit_.size(); i += 6) unit_.segment<3>(i).setConstant(power_of_two_below(arm));
        for (Eigen::Index i = 0; i < row_unit_.size(); ++i) {
            Real largest = 0;
            for (Eigen::Index j = 0; j < unit_.size(); ++j) largest = max(largest, Real(abs(rows_.C(i, j) * unit_[j])));
            row_unit_[i] = largest > 0 ? largest : Real(1);
        }
    }

    /// The largest entry of rotations in rows that are lengths, m.
    Real longest_arm() const {
        Real arm = 0;
        for (Eigen::Index i = 0; i < rows_.C.rows(); ++i)
            for (Eigen::Index j = 3; j < rows_.C.cols(); j += 6)
                if (!joint_rows_[static_cast<std::size_t>(i)].direction)
                    arm = max(arm, rows_.C.block<1, 3>(i, j).lpNorm<Eigen::Infinity>());
        return arm;
    }

    Real entry(Eigen::Index i, Eigen::Index j) const { return rows_.C(i, j) * unit_[j] / row_unit_[i]; }
    Eigen::Index column(Eigen::Index k) const { return columns_[static_cast<std::size_t>(k)]; }

    /// By complete pivoting: the columns of the pivots become the first ones. Of pivots nearly the same the first
    /// one: rows over their largest entry have many that are 1 but for round-off, which would choose else.
    void choose() {
        constexpr double even = 1 + 1.0 / 1024;
        for (Eigen::Index j = 0; j < work_.cols(); ++j)
            for (Eigen::Index i = 0; i < work_.rows(); ++i) work_(i, j) = entry(i, j);
        std::iota(columns_.begin(), columns_.end(), Eigen::Index(0));
        for (Eigen::Index k = 0; k < rows_.rank; ++k) {
            Eigen::Index row = k, best = k;
            for (Eigen::Index j = k; j < work_.cols(); ++j)
                for (Eigen::Index i = k; i < work_.rows(); ++i)
                    if (abs(work_(i, j)) > even * abs(work_(row, best))) row = i, best = j;
            if (work_(row, best) == 0) return;  // `eliminate` meets the same pivot
            work_.row(k).swap(work_.row(row));
            work_.col(k).swap(work_.col(best));
            std::swap(columns_[static_cast<std::size_t>(k)], columns_[static_cast<std::size_t>(best)]);
            for (Eigen::Index i = k + 1; i < work_.rows(); ++i) clear(i, k, work_.cols());
        }
    }

    /// Gaussian elimination of the dependent columns and of right_, by rows. Returns the least pivot.
    Real eliminate() {
        for (Eigen::Index k = 0; k < rows_.rank; ++k)
            for (Eigen::Index i = 0; i < work_.rows(); ++i) work_(i, k) = entry(i, column(k));
        Real least = std::numeric_limits<Real>::max();
        for (Eigen::Index k = 0; k < rows_.rank; ++k) {
            Eigen::Index row = k;
            for (Eigen::Index i = k; i < work_.rows(); ++i)
                if (abs(work_(i, k)) > abs(work_(row, k))) row = i;
            const Real pivot = abs(work_(row, k));
            if (!(pivot > 0)) return 0;
            least = min(least, pivot);
            work_.row(k).swap(work_.row(row));
            std::swap(right_[k], right_[row]);
            for (Eigen::Index i = k + 1; i < work_.rows(); ++i) right_[i] -= clear(i, k, rows_.rank) * right_[k];
        }
        return least;
    }

    /// Clears entry (i, k) by row k, in the columns before `end`. Returns the factor.
    Real clear(Eigen::Index i, Eigen::Index k, Eigen::Index end) {
        const Real factor = work_(i, k) / work_(k, k);
        if (factor != 0)
            for (Eigen::Index j = k; j < end; ++j) work_(i, j) -= factor * work_(k, j);
        return factor;
    }

    void substitute(Real* delta) {
        std::fill_n(delta, unit_.size(), Real(0));
        for (Eigen::Index k = rows_.rank; k-- > 0;) {
            Real x = right_[k];
            for (Eigen::Index j = k + 1; j < rows_.rank; ++j) x -= work_(k, j) * right_[j];
            right_[k] = x / work_(k, k);
            delta[column(k)] = right_[k] * unit_[column(k)];
        }
    }

    System& system_;
    DenseRows rows_;
    std::vector<ConstraintRow> joint_rows_;
    VecX unit_, row_unit_;  // of columns and rows
    MatX work_;
    VecX right_;
    std::vector<Eigen::Index> columns_;  // the dependent ones first
    Real pivot_at_choice_ = 0;           // the least; 0: none has been made
};

}  // namespace

std::unique_ptr<Correction> in_dependent_coordinates(System& system) {
    return std::make_unique<DependentCoordinates>(system);
}

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
