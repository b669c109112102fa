// SPDX-License-Identifier: BSD-3-Clause
#include "driver/config/values.hpp"

#include <fmt/format.h>

#include "records/json/model_keys.hpp"

namespace kreisel {

std::string expectation(ParameterKind kind) {
    switch (kind) {
        case ParameterKind::scalar:
            return "a number";
        case ParameterKind::positive:
            return "a number greater than 0";
        case ParameterKind::count:
            return fmt::format("a whole number from 1 to {}", largest_parameter_count);
        case ParameterKind::vector:
            return expectation(ValueKind::vector);
        case ParameterKind::inertia:
            return expectation(ValueKind::inertia);
        case ParameterKind::rotation:
            return expectation(ValueKind::matrix);
        case ParameterKind::bodies:
            return "a list of bodies, at least one";
        case ParameterKind::joints:
            return "a list of joints";
        case ParameterKind::forces:
            return "a list of forces";
        case ParameterKind::flag:
            return "true or false";
    }
    return "";
}

std::optional<Vector3> read_vector(const Node& node, const std::string& expected) {
    if (!node.is_array() || node.json().size() != 3) {
        node.mismatch(expected);
        return std::nullopt;
    }
    Vector3 vector{};
    bool good = true;
    const auto components = node.elements_or_self();
    for (std::size_t i = 0; i < 3; ++i) {
        const auto number = components[i].number();
        good = good && number;
        vector[i] = number.value_or(0);
    }
    return good ? std::optional(vector) : std::nullopt;
}

std::optional<Matrix3> read_matrix(const Node& node, const std::string& expected) {
    if (!node.is_array() || node.json().size() != 3) {
        node.mismatch(expected);
        return std::nullopt;
    }
    Matrix3 matrix{};
    bool good = true;
    const auto rows = node.elements_or_self();
    for (std::size_t i = 0; i < 3; ++i) {
        const auto row = read_vector(rows[i], expected);
        good = good && row;
        for (std::size_t j = 0; j < 3 && row; ++j) { matrix[3 * i + j] = (*row)[j]; }
    }
    return good ? std::optional(matrix) : std::nullopt;
}

std::optional<Matrix3> read_rotation(const Node& node, const PrintedNumbers& printed) {
    const auto matrix = read_matrix(node, expectation(ValueKind::matrix));
    return matrix ? std::optional(printed.rotation(node, *matrix)) : std::nullopt;
}

std::optional<Matrix3> read_inertia(const Node& node, const PrintedNumbers& printed) {
    const std::string expected = expectation(ValueKind::inertia);
    const bool diagonal = node.is_array() && !node.json().empty() && !node.json().front().is_array();
    std::optional<Matrix3> matrix;
    if (diagonal) {
        const auto moments = read_vector(node, expected);
        if (moments) { matrix = Matrix3{(*moments)[0], 0, 0, 0, (*moments)[1], 0, 0, 0, (*moments)[2]}; }
    } else {
        matrix = read_matrix(node, expected);
    }
    if (!matrix) { return std::nullopt; }
    for (const std::size_t i : {0U, 4U, 8U}) {
        if ((*matrix)[i] < least_positive) {
            node.mismatch(expected + ", with moments greater than 0");
            return std::nullopt;
        }
    }
    return printed.inertia(node, *matrix);
}

}  // namespace kreisel
