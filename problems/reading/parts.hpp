// SPDX-License-Identifier: BSD-3-Clause
//
// What the readers of bodies, joints and forces share.
#pragma once

#include <array>
#include <string>
#include <unordered_map>

#include "mechanics/model/model.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

namespace reading {

std::string text(const Real& x);  ///< ten digits, for messages
std::string place(const char* list, std::size_t entry);

/// The bodies of a model by name; refers to it.
class NamedBodies {
  public:
    explicit NamedBodies(const Model& model);
    /// Index of a body, or `ground`. Throws ParameterError with all names that exist.
    int index(const std::string& name, const std::string& path) const;
    /// Both of them, which must differ.
    std::array<int, 2> between(const std::array<std::string, 2>& names, const std::string& path,
                               const std::string& who) const;

  private:
    const Model& model_;
    std::unordered_map<std::string, int> indices_;
};
/// A point in the axes of a body; of a point mass it must be the mass centre, to 1e-9 of its coordinates.
Vec3 point_on(const Model& model, int body, const Vector3& point, const std::string& path, const std::string& who);
/// An axis that is not zero.
Vec3 axis(const Vector3& value, const std::string& path, const std::string& who);
/// A number at least 0.
Real not_negative(double value, const std::string& path, const std::string& what);

}  // namespace reading

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
