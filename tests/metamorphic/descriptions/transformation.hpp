// SPDX-License-Identifier: BSD-3-Clause
//
// Descriptions of one motion that must give the same result, and how closely.
#pragma once

#include <optional>

#include "tests/metamorphic/descriptions/change.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {
namespace metamorphic {

/// How closely two descriptions agree: bit by bit; up to round-off; up to the errors of the method, because stages
/// leave the constraints by O(h^2), where rows that are equal on them differ.
enum class Agreement { bits, round_off, truncation };
const char* to_text(Agreement agreement);

/// A changed model, with its units of time and the map back.
struct Transformed {
    Model model;
    Real time = 1;         ///< h is to be multiplied by this
    Real length = 1;       ///< x of the changed model over x of the original one
    bool restart = false;  ///< the method drops its memory in the middle
    std::function<Outcome(const Outcome&)> back;
};

struct Transformation {
    std::string name;
    /// Nothing if there is nothing to change.
    std::function<std::optional<Transformed>(const Model&)> apply;
    std::function<Agreement(const Model&, const Combination&)> agreement;
};

const std::vector<Transformation>& transformations();
/// Throws std::out_of_range for an unknown name.
const Transformation& transformation(const std::string& name);

/// Whether some rows are redundant.
bool has_redundant_rows(const Model& model);

/// The body with the largest inertia becomes two, held together by a fixed joint (split.cpp).
std::optional<Transformed> split(const Model& model);
/// Frames of torsion springs turned about their axes, with the rest angle (torsion_zero.cpp).
std::optional<Transformed> moved_zero(const Model& model);

}  // namespace metamorphic
}  // namespace KREISEL_PRECISION
}  // namespace kreisel
