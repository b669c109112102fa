// SPDX-License-Identifier: BSD-3-Clause
//
// Poincare sections: where a trajectory passes through the surface on which one quantity has a given value.
#include <fmt/format.h>

#include "plots/figures/kinds/phase_kind.hpp"
#include "records/reading/trajectory_table.hpp"

namespace kreisel {

namespace {

class PoincareFigure final : public PhaseKind {
  public:
    std::string section = "x2";  ///< of phase_quantities()
    double at = 0;               ///< in the unit of the quantity
    std::string direction = "up";

  private:
    // Between two samples all quantities are taken as linear in time.
    std::vector<Point> points_of(const TrajectoryTable& samples, const std::string& prefix) const override {
        const auto &s = column(samples, prefix, section), &xs = column(samples, prefix, x),
                   &ys = column(samples, prefix, y);
        std::vector<Point> points;
        for (std::size_t i = 1; i < s.size(); ++i) {
            const double before = s[i - 1] - at, after = s[i] - at;
            if (!passes(before, after)) { continue; }
            const double part = before / (before - after);
            points.push_back({xs[i - 1] + part * (xs[i] - xs[i - 1]), ys[i - 1] + part * (ys[i] - ys[i - 1])});
        }
        return points;
    }
    std::string lacking() const override {
        return fmt::format("no trajectory passes {} = {} {}", section, at,
                           direction == "both" ? "either way" : direction + "wards");
    }
    // A sample on the surface belongs to the interval that ends there.
    bool passes(double before, double after) const {
        const bool up = before < 0 && after >= 0, down = before > 0 && after <= 0;
        return (up && direction != "down") || (down && direction != "up");
    }
};

std::vector<FigureKey> poincare_keys() {
    auto keys = phase_keys();
    keys.push_back(figure_key("section", &PoincareFigure::section, phase_quantity(), "whose passages are drawn"));
    keys.push_back(figure_key("at", &PoincareFigure::at, figure_value::number("a number"),
                              "the value that it passes, in its unit"));
    keys.push_back(figure_key("direction", &PoincareFigure::direction,
                              figure_value::choice("direction", {"up", "down", "both"}), "which passages"));
    return keys;
}

}  // namespace

KREISEL_FIGURE(PoincareFigure, {.name = "poincare",
                                .summary = "two components of a body where a third passes a value; between samples "
                                           "linear",
                                .draws = FigureData::samples,
                                .script = "points",
                                .keys = poincare_keys()});

}  // namespace kreisel
