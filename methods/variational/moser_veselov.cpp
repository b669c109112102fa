// SPDX-License-Identifier: BSD-3-Clause
#include "methods/variational/moser_veselov.hpp"

#include <Eigen/LU>
#include <algorithm>

#include "mechanics/free_body/free_rotation.hpp"
#include "mechanics/free_body/inertias.hpp"
#include "methods/contract/integrator.hpp"
#include "methods/contract/take_over.hpp"
#include "methods/variational/modified_moments.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

namespace {

/// c of the step and the momentum after it, in principal axes.
class MoserVeselovStep {
  public:
    MoserVeselovStep(const Vec3& m, const Vec3& inverse_moments, const Real& h)
        : J_(inverse_moments.cwiseInverse()), a_(h / 2 * m.cwiseProduct(inverse_moments)), h_(h) {
        difference_ = {J_[1] - J_[2], J_[2] - J_[0], J_[0] - J_[1]};
        ratio_ = difference_.cwiseProduct(inverse_moments);
    }
    /// Newton's method for c = alpha a + ratio (c_2 c_3, c_3 c_1, c_1 c_2), from a.
    Status solve(long& iterations) {
        constexpr int most_iterations = 40;
        c_ = a_;
        Real before = 0;
        for (int i = 0; i < most_iterations; ++i, ++iterations) {
            Mat3 slope = -2 * a_ * c_.transpose();
            slope.diagonal().array() += 1;
            for (int k = 0; k < 3; ++k) {
                const int next = (k + 1) % 3, last = (k + 2) % 3;
                slope(k, next) -= ratio_[k] * c_[last], slope(k, last) -= ratio_[k] * c_[next];
            }
            const Vec3 residual = c_ - (1 + c_.squaredNorm()) * a_ - ratio_.cwiseProduct(products());
            const Vec3 correction = slope.inverse() * residual;
            const Real size = correction.norm();
            if (!isfinite(size)) return isfinite(Real(a_.sum())) ? Status::newton_failed : Status::non_finite;
            c_ -= correction;
            // What no longer decreases is round-off, or there is no solution.
            const bool stands = i > 0 && 2 * size > before;
            if (size <= epsilon * c_.norm() || (stands && size <= 64 * epsilon * c_.norm())) return Status::ok;
            before = size;
        }
        return Status::newton_failed;
    }
    const Vec3& c() const { return c_; }
    Vec3 gained_momentum() const { return 4 / (h_ * (1 + c_.squaredNorm())) * difference_.cwiseProduct(products()); }

  private:
    Vec3 products() const { return {c_[1] * c_[2], c_[2] * c_[0], c_[0] * c_[1]}; }

    Vec3 J_, a_, difference_, ratio_, c_;
    Real h_;
};

/// A body in principal axes.
struct MoserVeselovBody {
    MoserVeselovBody(const Mat3& J, int terms) : axes(principal_axes(J)), moments(axes.I, terms) {}
    PrincipalAxes axes;
    ModifiedMoments moments;
};

class MoserVeselov final : public Integrator {
  public:
    MoserVeselov(System& system, int terms)
        : system_(system),
          terms_(terms),
          inertias_(system),
          y_(static_cast<std::size_t>(system.state_group().size())),
          u_(static_cast<std::size_t>(system.velocities())) {
        bodies_.reserve(static_cast<std::size_t>(inertias_.bodies()));
    }

    Status step(const Real& t, const Real& h, Real* y) override {
        if (h == 0) return system_.accelerations(t, y, system_.v(y), u_.data(), nullptr);
        weigh(y);
        std::copy_n(y, y_.size(), y_.begin());
        system_.count_evaluation();
        Real *v = system_.v(y_.data()), *u = u_.data();
        for (const MoserVeselovBody& body : bodies_) {
            if (inertias_.in_space()) {
                store(Vec3(h * vec3(v)), u);
                u += 3, v += 3;
            }
            if (const Status status = turn(body, h, v, u); status != Status::ok) return status;
            u += 3, v += 3;
        }
        system_.group().append_cay(y_.data(), u_.data(), y_.data());
        ++work_.exponentials;
        return take_over(y_, y);
    }

  private:
    /// cay(2 c) is the rotation of (1, c).
    Status turn(const MoserVeselovBody& body, const Real& h, Real* omega, Real* u) {
        const auto& [I, Q] = body.axes;
        const Vec3 m = I.cwiseProduct(Q.transpose() * vec3(omega));
        MoserVeselovStep step(m, body.moments.inverse(m, h), h);
        const Status status = step.solve(work_.newton_iterations);
        store(Vec3(2 * (Q * step.c())), u);
        store(Vec3(vec3(omega) + Q * step.gained_momentum().cwiseQuotient(I)), omega);
        return status;
    }

    void weigh(const Real* q) {
        if (!inertias_.weigh(q)) return;
        bodies_.clear();
        for (int i = 0; i < inertias_.bodies(); ++i) bodies_.emplace_back(inertias_.of(i), terms_);
    }

    System& system_;
    int terms_;
    BodyInertias inertias_;
    std::vector<Real> y_, u_;
    std::vector<MoserVeselovBody> bodies_;
};

/// A force that vanishes at such places and times vanishes.
bool has_force(const System& system) {
    std::vector<Real> q(static_cast<std::size_t>(system.group().size()));
    std::vector<Real> u(static_cast<std::size_t>(system.velocities())), f(u);
    system.group().identity(q.data());
    for (int place = 1; place <= 3; ++place) {
        for (std::size_t i = 0; i < u.size(); ++i) u[i] = cos(Real(place * 7 + static_cast<int>(i)));
        system.group().append_exp(q.data(), u.data(), q.data());
        system.conservative_force(Real(place) * pi() / 7, q.data(), f.data());
        if (std::any_of(f.begin(), f.end(), [](const Real& entry) { return entry != 0; })) return true;
    }
    return system.is_dissipative();
}

std::string why_not_free(const System& system) {
    const std::string reason = BodyInertias::why_not(system);
    return reason.empty() && has_force(system) ? "forces" : reason;
}

}  // namespace

std::vector<Claim> preserved_by_moser_veselov() {
    return {{Property::symmetric, Domain::free}, {Property::momentum, Domain::free}, {Property::energy, Domain::free}};
}

Factory moser_veselov(int terms) {
    Factory factory;
    factory.make = [terms](System& system, const OptionValues&, const MethodDescription&) {
        return std::make_unique<MoserVeselov>(system, terms);
    };
    factory.declines = why_not_free;
    return factory;
}

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
