// SPDX-License-Identifier: BSD-3-Clause
#include "plots/report/motion.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>

#include "mechanics/parts/joint_type.hpp"
#include "plots/mechanism/shape.hpp"
#include "plots/report/forces.hpp"
#include "plots/report/poses.hpp"
#include "records/geometry.hpp"
#include "records/json/lists.hpp"
#include "records/json/writer.hpp"
#include "records/reading/trajectory_table.hpp"

namespace kreisel {

namespace {

constexpr std::size_t fewest_instants = 80, bytes_of_pose = 59, bytes_of_time = 11;

std::string point_json(const Vector3& point) { return json_list(point, json_number); }

std::string shape_json(const BodyGeometry& body, const Shapes& shapes) {
    static const char* const kinds[] = {"point", "sphere", "cylinder", "box"};
    const BodyShape shape = shape_of(body, shapes);
    return ObjectWriter()
        .member("name", json_text(body.name))
        .member("shape", json_text(kinds[static_cast<std::size_t>(shape.kind)]))
        .member("sizes", point_json(shape.sizes))
        .member("axes", json_list(shape.axes, point_json))
        .member("mass", json_number(body.mass))
        .text();
}

std::string drawn_link_json(const LinkGeometry& link) {
    return ObjectWriter()
        .member("name", json_text(link.name))
        .member("type", json_text(link.type))
        .member("force", find_joint_kind(link.type) == nullptr ? "true" : "false")
        .member("between", json_list(link.between, [](const std::string& name) { return json_text(name); }))
        .member("points", json_list(link.points, point_json))
        .member("axes", json_list(link.axes, point_json))
        .member("length", json_number(link.length))
        .text();
}

std::string drawn_mechanism_json(const CellGeometry& mechanism) {
    const auto draw_body = [&](const BodyGeometry& body) { return shape_json(body, mechanism.shapes); };
    return ObjectWriter()
        .member("bodies", json_list(mechanism.geometry.bodies, draw_body))
        .member("links", json_list(mechanism.geometry.links, drawn_link_json))
        .text();
}

// A cell that is shown, and its place among all.
struct ShownCell {
    std::size_t row;
    const ResultRow* result;
};

// How much of which motions fits into the page.
struct MotionSelection {
    std::vector<ShownCell> cells;
    std::size_t instants = most_instants;
};

// Fewer instants of all cells, and where these become too few the first cells only.
MotionSelection selection_of(std::vector<ShownCell> cells, const TrajectoryTable& one, std::size_t room) {
    const std::size_t bodies = std::max<std::size_t>(bodies_in(one).size(), 1), shown = std::min(bodies, most_bodies);
    const std::size_t bytes = bytes_of_pose * shown + bytes_of_time + bytes_of_forces(one) * shown / bodies;
    const std::size_t most_cells = std::max<std::size_t>(room / (bytes * fewest_instants), 1);
    if (cells.size() > most_cells) { cells.resize(most_cells); }
    const std::size_t instants = room / (bytes * std::max<std::size_t>(cells.size(), 1));
    return {std::move(cells), std::clamp<std::size_t>(instants, 2, most_instants)};
}

class MotionWriter {
  public:
    explicit MotionWriter(const std::filesystem::path& folder) : mechanisms_(read_geometry(folder)) {}

    std::string json(const std::vector<ShownCell>& all, std::size_t room) {
        std::string list;
        if (!all.empty()) {
            const MotionSelection selection = selection_of(all, read_trajectory(*all.front().result), room);
            for (const ShownCell& cell : selection.cells) {
                list += (list.empty() ? "" : ",") + cell_json(cell, selection.instants);
            }
            remark(all.size(), selection);
        }
        return ObjectWriter()
            .member("mechanisms", json_list(mechanisms_, drawn_mechanism_json))
            .member("cells", "[" + list + "]")
            .member("remarks", json_value(remarks_))
            .text();
    }

  private:
    std::string cell_json(const ShownCell& cell, std::size_t most) {
        const TrajectoryTable trajectory = read_trajectory(*cell.result);
        std::vector<std::string> bodies = bodies_in(trajectory);
        fewer_bodies_ = std::max(fewer_bodies_, bodies.size());
        if (bodies.size() > most_bodies) { bodies.resize(most_bodies); }
        const std::size_t samples = trajectory.columns.empty() ? 0 : trajectory.columns.front().size();
        const auto instants = thinned(samples, most);
        most_samples_ = std::max(most_samples_, samples);
        most_shown_ = std::max(most_shown_, instants.size());
        const PackedPoses poses = packed_poses(trajectory, bodies, instants);
        const CellGeometry* known = geometry_of(mechanisms_, cell.result->cell);
        return ObjectWriter()
            .member("row", std::to_string(cell.row))
            .member("mechanism", mechanism_json(cell.result->cell))
            .member("bodies", json_value(bodies))
            .member("t", json_text(poses.t))
            .member("x", json_text(poses.x))
            .member("q", poses.q.empty() ? "null" : json_text(poses.q))
            .member("v", poses.v.empty() ? "null" : json_text(poses.v))
            .member("forces", known == nullptr ? "[]" : forces_json(trajectory, known->geometry, bodies, instants))
            .member("applied", applied_json(parse_exactly(*cell.result->parameters), trajectory))
            .text();
    }

    std::string mechanism_json(const std::string& cell) const {
        for (std::size_t i = 0; i < mechanisms_.size(); ++i) {
            const auto& cells = mechanisms_[i].cells;
            if (std::find(cells.begin(), cells.end(), cell) != cells.end()) { return std::to_string(i); }
        }
        return "null";
    }

    void remark(std::size_t all, const MotionSelection& selection) {
        if (most_shown_ < most_samples_) {
            remarks_.push_back(fmt::format("Of up to {} samples a cell, {} are shown.", most_samples_, most_shown_));
        }
        if (fewer_bodies_ > most_bodies) {
            remarks_.push_back(fmt::format("Of {} bodies, the first {} are shown.", fewer_bodies_, most_bodies));
        }
        if (selection.cells.size() < all) {
            remarks_.push_back(
                fmt::format("Of {} cells with samples, the first {} are shown.", all, selection.cells.size()));
        }
        if (mechanisms_.empty()) {
            remarks_.emplace_back(
                "geometry.json is not there or damaged: bodies are shown as points. "
                "kreisel run --resume writes it.");
        }
    }

    std::vector<CellGeometry> mechanisms_;
    std::vector<std::string> remarks_;
    std::size_t fewer_bodies_ = 0, most_samples_ = 0, most_shown_ = 0;
};

}  // namespace

std::size_t room_for_motion(std::size_t others) {
    constexpr std::size_t most = 990000, least = 100000, data_of_page = 2250000;
    return others + most <= data_of_page ? most : std::max(data_of_page - std::min(others, data_of_page), least);
}

std::string report_motion(const Results& results, const std::filesystem::path& folder, std::size_t room) {
    std::vector<ShownCell> cells;
    for (std::size_t i = 0; i < results.rows.size(); ++i) {
        if (results.rows[i].has_trajectory) { cells.push_back({i, &results.rows[i]}); }
    }
    return MotionWriter(folder).json(cells, room);
}

}  // namespace kreisel
