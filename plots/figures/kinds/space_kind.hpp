// SPDX-License-Identifier: BSD-3-Clause
//
// Figures in space: the path of the mass centre of one body, with its shadow on the floor.
#pragma once

#include <array>
#include <optional>

#include "plots/figures/kind.hpp"
#include "plots/figures/kinds/drawn_top.hpp"
#include "plots/figures/panels.hpp"
#include "records/reading/trajectory_table.hpp"

namespace kreisel {

/// The sampled states of one body.
struct BodyPath {
    std::vector<double> t;
    std::vector<Point3> x;
    std::vector<std::array<double, 9>> R;  ///< row by row
    std::vector<Point3> v = {};            ///< m/s; empty where it was not sampled
};

/// A line in space at one instant.
struct TimedLine {
    double t;
    std::vector<Point3> points;
};

/// What such a figure shows, in a cube.
struct SpaceData {
    Point3 low{}, high{};  ///< m
    std::array<double, 2> view{};
    BodyPath path;  ///< smooth, without rotations
    std::vector<TimedLine> lines;
    std::optional<double> width;            ///< of the page, cm
    double font_size = standard_font_size;  ///< points
};

class SpaceKind : public Figure {
  public:
    std::string body;
    std::array<double, 2> view = {65, 35};
    std::optional<double> until;
    std::optional<double> width;            ///< of the page, mm
    double font_size = standard_font_size;  ///< points

    std::string drawn_body() const override { return body; }
    std::optional<double> drawn_until() const override { return until; }

    /// Throws FigureError, FileError.
    SpaceData data(const Results& results) const;
    void write(const Results& results, const std::filesystem::path& folder) const final;

  protected:
    /// What is drawn besides the path.
    virtual std::vector<TimedLine> drawn_bodies(const BodyPath& /*path*/, const ResultRow& /*row*/,
                                                const TrajectoryTable& /*samples*/) const {
        return {};
    }
};

/// The path of a body among samples. Throws FigureError where columns are missing.
BodyPath path_of_body(const TrajectoryTable& samples, const std::string& body);

/// The keys of such kinds.
std::vector<FigureKey> space_keys();

}  // namespace kreisel
