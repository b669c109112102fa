// SPDX-License-Identifier: BSD-3-Clause
//
// Measurements along a run, step by step: constraint defects on three levels, orthogonality, first integrals. Only
// requested metrics are computed.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "engine/engine.hpp"
#include "mechanics/system.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

/// Least-squares line through (t, y), kept by running means (one pass, no cancellation).
class LineFit {
  public:
    void add(const Real& t, const Real& y);
    Real slope() const { return t_t_ > 0 ? t_y_ / t_t_ : Real(0); }
    /// Standard error of the slope; needs three points.
    Real slope_error() const;
    long points() const { return points_; }

  private:
    long points_ = 0;
    Real t_ = 0, y_ = 0, t_t_ = 0, t_y_ = 0, y_y_ = 0;
};

class Monitor {
  public:
    Monitor(System& system, std::vector<std::string> patterns);
    bool idle() const { return defects_.empty() && integrals_.empty(); }
    /// Measures the state y at time t; the first call fixes the initial values of the integrals.
    void observe(const Real& t, const Real* y);
    /// The requested metrics, in a fixed order. For an unfinished run only the maxima, which hold for the part that
    /// was run: there is no final value, and slopes over different spans are not comparable.
    std::vector<std::pair<std::string, Number>> metrics(bool finished) const;
    /// Columns and current values for a trajectory: each quantity and its running maximum.
    std::vector<Column> columns() const;
    void append_values(std::vector<Real>& row) const;
    long evaluations() const { return evaluations_; }

  private:
    enum class Level { position, velocity, acceleration, orthogonality };
    struct Defect {
        Level level;
        bool direction;  ///< of rows that compare directions, else of lengths
        std::string name, unit;
        Real now = 0, worst = 0;
    };
    struct Integral {
        const FirstIntegral* source;
        std::string name;
        Real start = 0, now = 0, worst = 0;
        bool has_relative = false;
        LineFit fit = {};
    };
    /// Puts the rows of a level into rows_.
    void measure(Level level, const Real& t, const Real* y);
    Real norm(bool direction) const;

    System& system_;
    std::vector<std::string> patterns_;
    std::vector<Defect> defects_;
    std::vector<Integral> integrals_;
    std::vector<BodyState> states_;
    std::vector<ConstraintRow> directions_;
    std::vector<SpringAngle> springs_;
    std::vector<Real> angles_;
    VecX rows_, xi_, bias_, dv_;
    bool started_ = false, measured_ = true;
    long evaluations_ = 0;
};

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
