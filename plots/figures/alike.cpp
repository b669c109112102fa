// SPDX-License-Identifier: BSD-3-Clause
#include "plots/figures/alike.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>

#include "plots/figures/layout.hpp"

namespace kreisel {

namespace {

constexpr double half_a_mark = 1.0 / 80;  // of the length of an axis

// Along an axis, from 0 to 1.
double place_of(double value, const AxisRange& range, bool logarithmic) {
    return logarithmic ? std::log(value / range.low) / std::log(range.high / range.low)
                       : (value - range.low) / (range.high - range.low);
}

// The axes of a panel, on which points lie.
class PanelAxes {
  public:
    explicit PanelAxes(const Panel& panel) : panel_(panel), ranges_(axis_ranges(panel)) {}

    bool are_together(const std::vector<Point>& a, const std::vector<Point>& b) const {
        return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                          [&](const Point& p, const Point& q) { return are_together(p, q); });
    }

  private:
    bool are_together(const Point& p, const Point& q) const {
        const bool drawn = is_drawable(p, panel_);
        if (!drawn || !is_drawable(q, panel_)) { return drawn == is_drawable(q, panel_); }
        const auto near = [](double a, double b, const AxisRange& range, bool logarithmic) {
            return std::abs(place_of(a, range, logarithmic) - place_of(b, range, logarithmic)) < half_a_mark;
        };
        return near(p.x, q.x, ranges_.first, panel_.log_x) && near(p.y, q.y, ranges_.second, panel_.log_y);
    }

    const Panel& panel_;
    std::pair<AxisRange, AxisRange> ranges_;
};

auto axes_of(const Panel& panel) {
    return std::tie(panel.x_label, panel.y_label, panel.log_x, panel.log_y, panel.from_zero, panel.x_range,
                    panel.y_range);
}

}  // namespace

bool look_alike(const Panel& a, const Panel& b) {
    if (axes_of(a) != axes_of(b)) { return false; }
    const PanelAxes axes(a);
    return std::equal(a.curves.begin(), a.curves.end(), b.curves.begin(), b.curves.end(),
                      [&](const Curve& p, const Curve& q) {
                          return p.label == q.label && p.style == q.style && axes.are_together(p.points, q.points) &&
                                 axes.are_together(p.fitted, q.fitted);
                      });
}

std::vector<Panel> each_look_once(std::vector<Panel> panels) {
    std::vector<Panel> drawn;
    std::vector<std::string> titles;
    for (Panel& panel : panels) {
        const auto same = std::find_if(drawn.begin(), drawn.end(), [&](const Panel& known) {
            return !panel.title.empty() && !known.title.empty() && look_alike(known, panel);
        });
        if (same == drawn.end()) {
            titles.push_back(panel.title);
            drawn.push_back(std::move(panel));
        } else {
            titles[static_cast<std::size_t>(same - drawn.begin())] += ", " + panel.title;
        }
    }
    for (std::size_t i = 0; i < drawn.size(); ++i) { drawn[i].title = titles[i]; }
    return drawn;
}

}  // namespace kreisel
