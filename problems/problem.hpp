// SPDX-License-Identifier: BSD-3-Clause
//
// A problem is data: a function from parameters to a model, registered by one line in its own file.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "mechanics/model/model.hpp"
#include "problems/description.hpp"
#include "support/registration.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

/// The parameters of one instance, read as Real. All names exist: the reader filled in the defaults.
class Parameters {
  public:
    explicit Parameters(const ParameterValues& values) : values_(values) {}
    Real scalar(const std::string& name) const { return decimal(std::get<double>(values_.at(name))); }
    Real mass(const std::string& name) const { return to_mass(std::get<double>(values_.at(name)), "/" + name); }
    /// A number of the kind `count`. Throws ParameterError if it is not one.
    int count(const std::string& name) const;
    Vec3 vector(const std::string& name) const { return to_vec3(std::get<Vector3>(values_.at(name))); }
    Mat3 rotation(const std::string& name) const {
        return to_rotation(std::get<Matrix3>(values_.at(name)), "/" + name);
    }
    Mat3 inertia(const std::string& name, TriangleInequality rule, std::vector<std::string>& warnings) const {
        return to_inertia(std::get<Matrix3>(values_.at(name)), "/" + name, rule, warnings);
    }
    const std::vector<BodyData>& bodies(const std::string& name) const {
        return std::get<std::vector<BodyData>>(values_.at(name));
    }
    const std::vector<JointData>& joints(const std::string& name) const {
        return std::get<std::vector<JointData>>(values_.at(name));
    }
    const std::vector<ForceData>& forces(const std::string& name) const {
        return std::get<std::vector<ForceData>>(values_.at(name));
    }
    bool flag(const std::string& name) const { return std::get<bool>(values_.at(name)); }

  private:
    const ParameterValues& values_;
};

struct Problem {
    ProblemDescription description;
    Model (*build)(const Parameters&);
    /// The exact state at time t, where it is known in closed form; null otherwise.
    std::vector<BodyState> (*closed_form)(const Parameters&, const Real& t);
    std::string file;
};

const std::vector<Problem>& problems();
/// Throws std::out_of_range for an unknown name.
const Problem& problem(const std::string& name);

/// Records a problem; a static object of this type is what KREISEL_PROBLEM declares.
struct ProblemRegistration {
    ProblemRegistration(const char* file, Model (*build)(const Parameters&), ProblemDescription description,
                        std::vector<BodyState> (*closed_form)(const Parameters&, const Real&) = nullptr);
};

/// KREISEL_PROBLEM(build, {description}) or KREISEL_PROBLEM(build, {description}, closed_form).
#define KREISEL_PROBLEM(build, ...) KREISEL_REGISTER(::kreisel::ProblemRegistration, __FILE__, build, __VA_ARGS__)

inline constexpr Matrix3 diagonal(double a, double b, double c) { return {a, 0, 0, 0, b, 0, 0, 0, c}; }

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
