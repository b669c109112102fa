// SPDX-License-Identifier: BSD-3-Clause
#include "problems/reading/forces.hpp"

#include "mechanics/forces/entry.hpp"
#include "mechanics/parts/force_type.hpp"
#include "problems/reading/parts.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

namespace {

using reading::not_negative;

const ForceReader& reader_of(const ForceData& data, const std::string& path, const std::string& who) {
    if (const ForceReader* reader = Registered<ForceReader>::find(data.type)) return *reader;
    std::vector<std::string> names;
    for (const ForceReader& reader : Registered<ForceReader>::all()) names.push_back(reader.name);
    throw ParameterError(path + "/type", who + ": there is no force of type \"" + data.type + "\"", data.type,
                         std::move(names));
}

/// Checks an entry, key by key.
class EntryReader {
  public:
    EntryReader(const Model& model, const reading::NamedBodies& bodies, const ForceData& data, std::size_t index)
        : model_(model), bodies_(bodies), data_(data) {
        entry_.path = reading::place("forces", index), entry_.who = "force " + std::to_string(index);
    }
    const ForceReader& reader() const { return reader_of(data_, entry_.path, entry_.who); }

    ForceEntry read(const ForceKind& kind) {
        kind.has("body") ? read_body() : read_between();
        if (kind.rigid_only) require_rigid(kind);
        if (kind.has("points")) read_points();
        if (kind.has("point") && data_.point) read_point(kind);
        if (kind.has("constant") || kind.has("mu")) read_masses();
        if (kind.has("axis")) read_axis();
        if (kind.has("axes")) read_axes();
        read_numbers(kind);
        return std::move(entry_);
    }

  private:
    void name(const std::string& bodies) { entry_.who += " (" + bodies + ", " + data_.type + ")"; }
    Vec3 point_on(int body, const Vector3& point, const std::string& key) const {
        return reading::point_on(model_, body, point, entry_.path + "/" + key, entry_.who);
    }

    void read_body() {
        name(data_.between[1]);
        entry_.second = bodies_.index(data_.between[1], entry_.path + "/body");
        if (entry_.second == ground) entry_.refuse("body", "expected a body that moves, got \"ground\"");
    }
    void read_between() {
        name(data_.between[0] + " - " + data_.between[1]);
        const auto bodies = bodies_.between(data_.between, entry_.path, entry_.who);
        entry_.first = bodies[0], entry_.second = bodies[1];
    }
    void require_rigid(const ForceKind& kind) const {
        const auto check = [&](int body, const std::string& key) {
            if (body == ground || !model_.bodies[static_cast<std::size_t>(body)].point) return;
            entry_.refuse(key, "expected a rigid body; \"" + model_.name_of(body) +
                                   "\" is a point mass, on which no torque can act");
        };
        check(entry_.first, "between/0"), check(entry_.second, kind.has("body") ? "body" : "between/1");
    }
    void read_points() {
        entry_.r_first = point_on(entry_.first, data_.points[0], "points/0");
        entry_.r_second = point_on(entry_.second, data_.points[1], "points/1");
        entry_.distance = (to_vec3(data_.points[0]) - to_vec3(data_.points[1])).norm();
    }
    void read_point(const ForceKind& kind) {
        entry_.point = entry_.r_second = point_on(entry_.second, *data_.point, "point");
        if (kind.has("axes")) entry_.r_first = point_on(entry_.first, *data_.point, "point");
    }
    void read_masses() {
        const Vec3 centre = to_vec3(data_.point.value_or(Vector3{}));
        const auto place = [&](int body) { return body == ground ? centre : at(body).start.x; };
        const auto mass = [&](int body) { return body == ground ? Real(0) : at(body).mass; };
        if (entry_.first == ground) entry_.r_first = centre;
        entry_.distance = (place(entry_.second) - place(entry_.first)).norm();
        entry_.mass_first = mass(entry_.first), entry_.mass_second = mass(entry_.second);
    }
    const Body& at(int body) const { return model_.bodies[static_cast<std::size_t>(body)]; }
    void read_axes() {
        const Mat3 axes = to_rotation(data_.axes, entry_.path + "/axes");
        entry_.axes_first = model_.axes_of(entry_.first, axes);
        entry_.axes_second = model_.axes_of(entry_.second, axes);
    }
    void read_axis() {
        const Mat3 axes = axes_about(reading::axis(data_.axis, entry_.path + "/axis", entry_.who));
        entry_.axes_first = model_.axes_of(entry_.first, axes);
        entry_.axes_second = model_.axes_of(entry_.second, axes);
    }
    void read_numbers(const ForceKind& kind) {
        entry_.stiffness = not_negative(data_.stiffness, entry_.path + "/stiffness", "stiffness");
        entry_.damping = not_negative(data_.damping, entry_.path + "/damping", "damping");
        if (data_.rest)
            entry_.rest = kind.has("length") ? not_negative(*data_.rest, entry_.path + "/length", "free length")
                                             : decimal(*data_.rest);
        entry_.turns = data_.turns;
        for (const double coefficient : data_.coefficients) entry_.coefficients.push_back(decimal(coefficient));
        for (std::size_t i = 0; i < 2; ++i)
            entry_.stiffnesses[i] = to_vec3(data_.stiffnesses[i]), entry_.dampings[i] = to_vec3(data_.dampings[i]);
        entry_.attraction = not_negative(data_.attraction, entry_.path + (kind.has("mu") ? "/mu" : "/constant"),
                                         "constant of gravitation");
        entry_.value = to_vec3(data_.value), entry_.body_axes = data_.body_axes;
        entry_.amplitude = decimal(data_.amplitude), entry_.frequency = decimal(data_.frequency);
    }

    const Model& model_;
    const reading::NamedBodies& bodies_;
    const ForceData& data_;
    ForceEntry entry_;
};

}  // namespace

void read_forces(Model& model, const std::vector<ForceData>& forces) {
    const reading::NamedBodies bodies(model);
    for (std::size_t i = 0; i < forces.size(); ++i) {
        EntryReader entry(model, bodies, forces[i], i);
        const ForceReader& force = entry.reader();
        force.read(entry.read(force_kind(force.name)), model);
    }
}

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
