// SPDX-License-Identifier: BSD-3-Clause
#include "problems/reading/forces.hpp"

#include <map>

#include "problems/reading/parts.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

namespace {

using reading::not_negative;

/// Adds one spring or load to a model.
class ForceReader {
  public:
    ForceReader(Model& model, const ForceData& data, std::size_t index)
        : model_(model), data_(data), path_(reading::place("forces", index)), who_("force " + std::to_string(index)) {}

    void read() {
        const auto reader = readers().find(data_.type);
        if (reader != readers().end()) return (this->*reader->second)();
        std::vector<std::string> names;
        for (const auto& [name, function] : readers()) names.push_back(name);
        throw ParameterError(path_ + "/type", who_ + ": there is no force of type \"" + data_.type + "\"", data_.type,
                             std::move(names));
    }

  private:
    using Reader = void (ForceReader::*)();
    static const std::map<std::string, Reader>& readers() {
        static const std::map<std::string, Reader> all = {{"spring", &ForceReader::read_spring},
                                                          {"torsion_spring", &ForceReader::read_torsion_spring},
                                                          {"force", &ForceReader::read_force},
                                                          {"torque", &ForceReader::read_torque}};
        return all;
    }

    std::array<int, 2> ends() {
        who_ += " (" + data_.between[0] + " - " + data_.between[1] + ", " + data_.type + ")";
        return reading::bodies_between(model_, data_.between, path_, who_);
    }
    bool is_point(int body) const { return body != ground && model_.bodies[static_cast<std::size_t>(body)].point; }

    void read_spring() {
        const auto [first, second] = ends();
        Spring spring{.first = first, .second = second};
        spring.r_first = reading::point_on(model_, first, data_.points[0], path_ + "/points/0", who_);
        spring.r_second = reading::point_on(model_, second, data_.points[1], path_ + "/points/1", who_);
        spring.stiffness = not_negative(data_.stiffness, path_ + "/stiffness", "stiffness");
        spring.damping = not_negative(data_.damping, path_ + "/damping", "damping");
        const Real initial = (to_vec3(data_.points[0]) - to_vec3(data_.points[1])).norm();
        spring.length = data_.rest ? not_negative(*data_.rest, path_ + "/length", "free length") : initial;
        if (initial == 0 && (spring.length != 0 || spring.damping != 0))
            throw ParameterError(path_ + "/points",
                                 who_ +
                                     ": expected two different points, since the force of a spring with "
                                     "a free length or damping acts along their line");
        model_.springs.push_back(spring);
    }

    void read_torsion_spring() {
        const auto bodies = ends();
        for (std::size_t k = 0; k < 2; ++k)
            if (is_point(bodies[k])) refuse_torque(path_ + "/between/" + std::to_string(k), bodies[k]);
        const Mat3 axes = axes_about(reading::axis(data_.axis, path_ + "/axis", who_));
        TorsionSpring spring{.first = bodies[0], .second = bodies[1]};
        spring.axes_first = model_.axes_of(bodies[0], axes), spring.axes_second = model_.axes_of(bodies[1], axes);
        spring.stiffness = not_negative(data_.stiffness, path_ + "/stiffness", "stiffness");
        spring.damping = not_negative(data_.damping, path_ + "/damping", "damping");
        spring.angle = decimal(data_.rest.value_or(0));
        spring.turns = data_.turns;
        model_.torsion_springs.push_back(spring);
    }

    /// A load without force and torque.
    Load load() {
        const std::string& name = data_.between[1];
        who_ += " (" + name + ", " + data_.type + ")";
        Load load{.body = reading::body_named(model_, name, path_ + "/body")};
        if (load.body == ground)
            throw ParameterError(path_ + "/body", who_ + ": expected a body that moves, got \"ground\"");
        load.axes = data_.body_axes ? Load::Axes::body : Load::Axes::space;
        load.amplitude = decimal(data_.amplitude), load.frequency = decimal(data_.frequency);
        return load;
    }

    void read_force() {
        Load force = load();
        force.force = to_vec3(data_.value);
        if (data_.point) force.point = reading::point_on(model_, force.body, *data_.point, path_ + "/point", who_);
        model_.loads.push_back(force);
    }

    void read_torque() {
        Load torque = load();
        if (is_point(torque.body)) refuse_torque(path_ + "/body", torque.body);
        torque.torque = to_vec3(data_.value);
        model_.loads.push_back(torque);
    }

    [[noreturn]] void refuse_torque(const std::string& path, int body) const {
        throw ParameterError(path, who_ + ": expected a rigid body; \"" + model_.name_of(body) +
                                       "\" is a point mass, on which no torque can act");
    }

    Model& model_;
    const ForceData& data_;
    std::string path_, who_;
};

}  // namespace

void read_forces(Model& model, const std::vector<ForceData>& forces) {
    for (std::size_t i = 0; i < forces.size(); ++i) ForceReader(model, forces[i], i).read();
}

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
