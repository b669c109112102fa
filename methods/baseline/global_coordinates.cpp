// SPDX-License-Identifier: BSD-3-Clause
#include "methods/baseline/global_coordinates.hpp"

#include <algorithm>
#include <boost/numeric/odeint/stepper/runge_kutta4.hpp>

#include "mechanics/system.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

namespace {

using Flat = std::vector<Real>;

class GlobalRk4 final : public Integrator {
  public:
    GlobalRk4(System& system, std::shared_ptr<const RotationCoordinates> coordinates)
        : system_(system),
          coordinates_(std::move(coordinates)),
          bodies_(system.bodies()),
          translations_(system.group().dim() == 6 * bodies_ ? 3 : 0),
          w_(static_cast<std::size_t>(bodies_ * (translations_ + coordinates_->size()) + system.velocities())),
          y_(static_cast<std::size_t>(system.state_group().size())),
          z_(static_cast<std::size_t>(system.state_group().dim())) {
        stepper_.adjust_size(w_);
    }

    Status step(const Real& t, const Real& h, Real* y) override {
        // Coordinates may not depend on every entry of R: a NaN would be repaired silently.
        if (!Eigen::Map<const VecX>(y, system_.state_group().size()).allFinite()) return Status::non_finite;
        read(y);
        status_ = Status::ok, h_ = h;
        stepper_.do_step([this](const Flat& w, Flat& dw, const Real& s) { derivative(w, dw, s); }, w_, t, h);
        if (status_ != Status::ok) return status_;
        Real* w = w_.data();
        for (int i = 0; i < bodies_; ++i, w += stride()) coordinates_->finish(w + translations_);
        write(w_, y);
        return Status::ok;
    }

  private:
    int stride() const { return translations_ + coordinates_->size(); }

    void read(const Real* y) {
        std::copy(y, y + y_.size(), y_.begin());  // turn labels, which are not part of a pose
        Real* w = w_.data();
        const Real* v = system_.v(y);
        for (int i = 0; i < bodies_; ++i, y += translations_ + 9, w += stride()) {
            std::copy_n(y, translations_, w);
            coordinates_->from_matrix(y + translations_, w + translations_);
        }
        std::copy_n(v, system_.velocities(), w);
    }

    void write(const Flat& flat, Real* y) const {
        const Real* w = flat.data();
        Real* v = system_.v(y);
        for (int i = 0; i < bodies_; ++i, y += translations_ + 9, w += stride()) {
            std::copy_n(w, translations_, y);
            coordinates_->to_matrix(w + translations_, y + translations_);
        }
        std::copy_n(w, system_.velocities(), v);
    }

    /// w' = (x', z', v'). The first failure of a step is kept; Odeint has no way to stop inside one.
    void derivative(const Flat& flat, Flat& dflat, const Real& t) {
        write(flat, y_.data());
        const Status status = system_.vector_field(t, y_.data(), z_.data());
        if (status_ == Status::ok) status_ = status;
        const Real *w = flat.data(), *z = z_.data();
        Real* dw = dflat.data();
        for (int i = 0; i < bodies_; ++i, w += stride(), dw += stride(), z += translations_ + 3) {
            std::copy_n(z, translations_, dw);
            const bool regular = coordinates_->derivative(w + translations_, z + translations_, h_, dw + translations_);
            if (!regular && status_ == Status::ok) status_ = Status::chart_singularity;
        }
        std::copy_n(z, system_.velocities(), dw);
    }

    System& system_;
    std::shared_ptr<const RotationCoordinates> coordinates_;
    int bodies_, translations_;
    Flat w_, y_, z_;
    Status status_ = Status::ok;
    Real h_ = 0;
    boost::numeric::odeint::runge_kutta4<Flat, Real> stepper_;
};

}  // namespace

Factory global_rk4(const std::function<std::shared_ptr<const RotationCoordinates>(const OptionValues&)>& coordinates,
                   std::vector<OptionDescription> options) {
    Factory factory;
    factory.make = [coordinates](System& system, const OptionValues& values, const MethodDescription&) {
        return std::make_unique<GlobalRk4>(system, coordinates(values));
    };
    factory.options = std::move(options);
    factory.stages = 4;
    return factory;
}

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
