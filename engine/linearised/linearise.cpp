// SPDX-License-Identifier: BSD-3-Clause
#include "engine/linearised/linearise.hpp"

#include <Eigen/QR>
#include <stdexcept>

#include "engine/linearised/derivative.hpp"
#include "engine/linearised/motion_parts.hpp"
#include "engine/linearised/spectrum.hpp"
#include "engine/linearised/steady_motion.hpp"
#include "engine/report/report.hpp"
#include "support/number_text.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

namespace {

/// Pivots below this fraction of the first are zero: starts meet joints, and steady motions the equations, to 1e-9.
const Real least_pivot = Real(1) / 10000000;
const Real steady_enough = Real(1) / 1000000000;

/// Fields of generators are of size 1 in units of the mechanism: a column that is round-off of that is zero, where
/// ranks, which are relative, would count it.
MatX without_noise(MatX B) {
    for (Eigen::Index i = 0; i < B.cols(); ++i)
        if (B.col(i).norm() <= least_pivot) B.col(i).setZero();
    return B;
}

/// Orthonormal columns: first those of the range of B, their number `rank`, then those of its complement.
struct Split {
    MatX Q;
    Eigen::Index rank = 0;
    MatX range() const { return Q.leftCols(rank); }
    MatX complement() const { return Q.rightCols(Q.cols() - rank); }
};

Split split(const MatX& B) {
    const Eigen::Index size = B.rows();
    if (B.cols() == 0) return {MatX::Identity(size, size), 0};
    Eigen::ColPivHouseholderQR<MatX> qr;
    qr.setThreshold(least_pivot);
    qr.compute(B);
    return {qr.householderQ() * MatX::Identity(size, size), qr.rank()};
}

/// The x of least norm that minimises |B x - b|.
VecX least_squares(const MatX& B, const VecX& b) {
    const MatX V = split(MatX(B.transpose())).range();  // x lies in the span of the rows
    if (V.cols() == 0) return VecX::Zero(B.cols());
    return V * (B * V).colPivHouseholderQr().solve(b);
}

/// A start, its symmetries and the steady motion through it.
class LinearisedStart {
  public:
    LinearisedStart(const Model& model, const std::string& formulation, const Model& begun)
        : model_(model),
          motion_(model, formulation, begun),
          space_(space_symmetries(model)),
          spins_(spin_symmetries(model)) {
        orbit_ = MatX(motion_.size(), columns(space_) + columns(spins_));
        orbit_ << generated(space_), generated(spins_);
        find_generator();
    }

    const Generator& generator() const { return generator_; }
    const Real& rate() const { return motion_.rate(); }
    Real residual() const { return residual_; }
    bool is_steady() const { return residual_ <= steady_enough * rate(); }

    /// The spectra on the symmetries' orbit and on the quotient, with derivatives by steps from h on.
    struct Spectra {
        Eigen::Index dimension = 0;
        std::vector<SpectrumEntry> orbit, others;
    };
    Spectra spectra(const Real& h) {
        const MatX T = tangent_space(h);
        MatX image(motion_.size(), T.cols());
        const auto relative = [&](const VecX& z) {
            const auto y = motion_.state(z);
            return VecX(motion_.field(y) - motion_.generated(y, generator_));
        };
        for (Eigen::Index i = 0; i < T.cols(); ++i)
            image.col(i) = derivative_at_zero([&](const Real& s) { return relative(s * T.col(i)); }, h);
        const MatX A = T.transpose() * image;
        const Split parts = split(without_noise(T.transpose() * orbit_));
        const MatX along = parts.range(), across = parts.complement();
        return {T.cols(), spectrum(along.transpose() * A * along, rate()),
                spectrum(across.transpose() * A * across, rate())};
    }

  private:
    static Eigen::Index columns(const std::vector<Generator>& all) { return static_cast<Eigen::Index>(all.size()); }

    MatX generated(const std::vector<Generator>& all) {
        const auto start = motion_.state(VecX::Zero(motion_.size()));
        MatX fields(motion_.size(), columns(all));
        for (std::size_t i = 0; i < all.size(); ++i)
            fields.col(static_cast<Eigen::Index>(i)) = motion_.generated(start, all[i]);
        return fields;
    }

    /// Of all c that come nearest to F the one that moves space least: what spins can do is left to them.
    void find_generator() {
        const VecX field = motion_.field(motion_.state(VecX::Zero(motion_.size())));
        const MatX of_space = orbit_.leftCols(columns(space_)), of_spins = orbit_.rightCols(columns(spins_));
        const MatX rest = split(of_spins).complement();
        const VecX a = least_squares(without_noise(rest.transpose() * of_space), rest.transpose() * field);
        const VecX left_over = field - of_space * a;
        const VecX b = least_squares(of_spins, left_over);
        residual_ = (left_over - of_spins * b).norm();
        VecX both(a.size() + b.size());
        both << a, b;
        std::vector<Generator> all = space_;
        all.insert(all.end(), spins_.begin(), spins_.end());
        generator_ = combination(all, both);
        generator_.spins.resize(model_.bodies.size(), Vec3::Zero());
    }

    /// Of {Phi = 0, C v + b = 0} at the start, without what has no meaning; orthonormal columns.
    MatX tangent_space(const Real& h) {
        const int size = motion_.size();
        const auto rows = motion_.residuals(motion_.state(VecX::Zero(size))).size();
        MatX normals = MatX::Zero(size, rows + size);
        for (int i = 0; i < size; ++i) {
            const auto along = [&](const Real& s) { return motion_.residuals(motion_.state(s * VecX::Unit(size, i))); };
            if (rows > 0) normals.row(i).head(rows) = derivative_at_zero(along, h).transpose();
            if (motion_.is_idle(i)) normals(i, rows + i) = 1;
        }
        return split(normals).complement();
    }

    const Model& model_;
    SteadyMotion motion_;
    std::vector<Generator> space_, spins_;
    MatX orbit_;
    Generator generator_;
    Real residual_ = 0;
};

std::vector<Eigenvalue> reported(const std::vector<SpectrumEntry>& entries, const Real& unit) {
    std::vector<Eigenvalue> all;
    for (const SpectrumEntry& one : entries) {
        const bool zero = abs(one.real) + abs(one.imaginary) <= same_eigenvalue(unit);
        const Real x = zero ? Real(0) : one.real, y = zero ? Real(0) : one.imaginary;
        all.push_back({to_number(x), to_number(y), one.multiplicity});
    }
    return all;
}

std::string refused(const LinearisedStart& start, const Model& model) {
    std::string nearest;
    for (const MotionPart& part : motion_parts(model, start.generator(), start.rate()))
        nearest += (nearest.empty() ? "" : ", ") + part.name;
    return "it is neither an equilibrium nor a steady motion: the accelerations differ from those of " +
           (nearest.empty() ? "rest" : "the nearest steady motion (" + nearest + ")") + " by " +
           brief_text(to_double(start.residual() / start.rate())) + " of the rate of the motion";
}

}  // namespace

Linearisation linearised(const Model& model, const std::string& formulation) {
    return linearised(model, formulation, model);
}

Linearisation linearised(const Model& model, const std::string& formulation, const Model& begun) {
    Linearisation result;
    result.refusal = why_not_autonomous(model);
    if (!result.refusal.empty()) return result;
    try {
        LinearisedStart start(model, formulation, begun);
        result.rate = to_number(start.rate());
        result.residual = to_number(start.residual());
        if (!start.is_steady()) {
            result.refusal = refused(start, model);
            return result;
        }
        result.motion = motion_parts(model, start.generator(), start.rate());
        const auto spectra = start.spectra(Real(1) / 8), again = start.spectra(Real(3) / 32);
        result.dimension = static_cast<int>(spectra.dimension);
        result.of_symmetries = reported(spectra.orbit, start.rate());
        result.eigenvalues = reported(spectra.others, start.rate());
        result.uncertainty =
            to_double(max(distance(spectra.orbit, again.orbit), distance(spectra.others, again.others)));
    } catch (const std::domain_error& error) { result.refusal = error.what(); }
    return result;
}

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
