// SPDX-License-Identifier: BSD-3-Clause
#include "engine/reference/taylor/force_series.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

namespace {

class LoadSeries final : public ForceSeries {
  public:
    LoadSeries(const Load& load, const BodyAt& at)
        : load_(load),
          body_(at(load.body)),
          arm_(body_, load.point),
          turned_force_(body_, load.force),
          turned_torque_(body_, load.torque),
          factor_(scalars(body_)),
          force_(vectors(body_)) {}

    void start(const Real& t) override { modulate(load_.amplitude, load_.frequency, t, factor_); }

    void act(std::size_t k) override {
        for (Attached* attached : {&arm_, &turned_force_, &turned_torque_}) attached->update(k);
        const bool turns = load_.axes == Load::Axes::body;
        const auto modulated = [&](const Vec3& fixed, const Attached& turned) -> Vec3 {
            return turns ? product(factor_, turned.series(), k) : Vec3(factor_[k] * fixed);
        };
        force_[k] = modulated(load_.force, turned_force_);
        body_.act(force_[k], cross(arm_.series(), force_, k) + modulated(load_.torque, turned_torque_), k);
    }

  private:
    Load load_;
    BodySeries& body_;
    Attached arm_, turned_force_, turned_torque_;
    Scalars factor_;
    Vectors force_;
};

const SeriesRegistration<Load, LoadSeries> load_series;

}  // namespace

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
