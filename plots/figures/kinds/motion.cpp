// SPDX-License-Identifier: BSD-3-Clause
//
// The motion as a sequence of pictures, coloured by time, over the path of a mass centre and its shadow: of a top, or
// of all bodies of a mechanism.
#include <fmt/format.h>

#include <cmath>
#include <optional>

#include "plots/figures/kinds/drawn_top.hpp"
#include "plots/figures/kinds/space_kind.hpp"
#include "plots/mechanism/outline.hpp"
#include "records/geometry.hpp"
#include "records/reading/trajectory_table.hpp"

namespace kreisel {

namespace {

// Sample indices of `count` instants, the first and the last sample among them.
std::vector<std::size_t> sampled_instants(std::size_t samples, long count) {
    std::vector<std::size_t> indices;
    const auto last = static_cast<double>(samples - 1);
    for (long i = 0; i < count; ++i) {
        const double part = count == 1 ? 0 : static_cast<double>(i) / static_cast<double>(count - 1);
        indices.push_back(static_cast<std::size_t>(std::lround(part * last)));
    }
    return indices;
}

class MotionFigure final : public SpaceKind {
  public:
    long instants = 9;
    double radius = 0.3;          // m
    std::optional<Point3> lever;  // from the tip of the drawn top to the mass centre, body axes, m

  private:
    std::vector<TimedLine> drawn_bodies(const BodyPath& path, const ResultRow& row,
                                        const TrajectoryTable& samples) const override {
        const std::optional<Point3> tip_to_centre = lever_of(row);
        return tip_to_centre ? drawn_tops(path, *tip_to_centre) : drawn_mechanism(row, samples);
    }

    std::vector<TimedLine> drawn_tops(const BodyPath& path, const Point3& tip_to_centre) const {
        std::vector<TimedLine> lines;
        for (const std::size_t k : sampled_instants(path.t.size(), instants)) {
            for (auto& line : drawn_top(path.x[k], path.R[k], tip_to_centre, radius)) {
                lines.push_back({path.t[k], std::move(line)});
            }
        }
        return lines;
    }

    std::vector<TimedLine> drawn_mechanism(const ResultRow& row, const TrajectoryTable& samples) const {
        const auto mechanisms = read_geometry(row.folder);
        const CellGeometry* known = geometry_of(mechanisms, row.cell);
        if (known == nullptr) {
            throw FigureError(
                fmt::format("{}: problem {} has no lever; give \"lever\" in the figure, or let kreisel run "
                            "--resume write geometry.json, which lists all bodies",
                            name, row.problem));
        }
        std::vector<TimedLine> lines;
        for (const BodyGeometry& part : known->geometry.bodies) {
            const BodyPath path = path_of_body(samples, part.name);
            const auto outline = outline_of(part, known->geometry, known->shapes);
            for (const std::size_t k : sampled_instants(path.t.size(), instants)) {
                for (const auto& line : outline) { lines.push_back({path.t[k], moved(line, path.x[k], path.R[k])}); }
            }
        }
        return lines;
    }

    // That of the figure, else that of the problem; nothing where it has none.
    std::optional<Point3> lever_of(const ResultRow& row) const {
        Point3 found{};
        const JsonValue parameters = parse_exactly(*row.parameters);
        const JsonValue* parameter = parameters.find("lever");
        if (lever) {
            found = *lever;
        } else if (parameter != nullptr && parameter->elements.size() == found.size()) {
            for (std::size_t i = 0; i < found.size(); ++i) { found[i] = parameter->elements[i].number(); }
        } else {
            return std::nullopt;
        }
        if (!(std::hypot(found[0], found[1], found[2]) > 0)) { throw FigureError(name + ": the lever is zero"); }
        return found;
    }
};

std::vector<FigureKey> motion_keys() {
    auto keys = space_keys();
    keys.push_back(figure_key("instants", &MotionFigure::instants, figure_value::count(1, 100, "instants"),
                              "how many pictures, evenly spaced over time"));
    keys.push_back(figure_key("radius", &MotionFigure::radius, figure_value::positive("a number greater than 0"),
                              "of the drawn rim of a top, m"));
    keys.push_back(figure_key("lever", &MotionFigure::lever, figure_value::numbers<3>("three numbers"),
                              "from the tip of the drawn top to the mass centre, body axes, m",
                              "the problem's; without one all bodies are drawn"));
    return keys;
}

}  // namespace

KREISEL_FIGURE(MotionFigure,
               {.name = "motion",
                .summary = "the motion of a top or of all bodies of a mechanism as a sequence of pictures",
                .draws = FigureData::samples,
                .script = "motion",
                .keys = motion_keys()});

}  // namespace kreisel
