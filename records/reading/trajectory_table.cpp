// SPDX-License-Identifier: BSD-3-Clause
#include "records/reading/trajectory_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <limits>
#include <stdexcept>

#include "support/errors.hpp"
#include "support/files.hpp"

namespace kreisel {

namespace {

std::vector<std::string> split(const std::string& text, char separator) {
    std::vector<std::string> parts;
    std::size_t begin = 0;
    for (std::size_t end = text.find(separator); end != std::string::npos; end = text.find(separator, begin)) {
        parts.push_back(text.substr(begin, end - begin));
        begin = end + 1;
    }
    parts.push_back(text.substr(begin));
    return parts;
}

double field(const std::string& text) {
    if (text.empty()) { return std::numeric_limits<double>::quiet_NaN(); }
    char* end = nullptr;
    const double value = std::strtod(text.c_str(), &end);
    if (*end != '\0') { throw std::invalid_argument("not a number"); }
    return value;
}

void read_header(const std::string& line, TrajectoryTable& table) {
    for (const std::string& title : split(line, ',')) {
        const auto bracket = title.rfind(" [");
        if (bracket == std::string::npos || title.back() != ']') {
            throw std::invalid_argument("a column has no unit");
        }
        table.names.push_back(title.substr(0, bracket));
        table.units.push_back(title.substr(bracket + 2, title.size() - bracket - 3));
    }
    table.columns.resize(table.names.size());
}

void read_sample(const std::string& line, TrajectoryTable& table) {
    if (line.empty()) { return; }
    const auto fields = split(line, ',');
    if (fields.size() != table.names.size()) { throw std::invalid_argument("wrong number of columns"); }
    for (std::size_t k = 0; k < fields.size(); ++k) { table.columns[k].push_back(field(fields[k])); }
}

}  // namespace

const std::vector<double>* TrajectoryTable::find(const std::string& name) const {
    const auto at = std::find(names.begin(), names.end(), name);
    return at == names.end() ? nullptr : &columns[static_cast<std::size_t>(at - names.begin())];
}

std::string TrajectoryTable::unit(const std::string& name) const {
    const auto at = std::find(names.begin(), names.end(), name);
    return at == names.end() ? "" : units[static_cast<std::size_t>(at - names.begin())];
}

TrajectoryTable read_trajectory(const ResultRow& row) {
    const auto file = *row.folder / "trajectories" / (row.cell + ".csv");
    TrajectoryTable table;
    long number = 0;
    const bool whole = for_each_line(file, [&](std::uint64_t, const std::string& line) {
        try {
            ++number;
            number == 1 ? read_header(line, table) : read_sample(line, table);
        } catch (const std::exception& error) {
            throw FileError(fmt::format("{}:{}: damaged: {}", file.string(), number, error.what()));
        }
    });
    if (!whole) { throw FileError(fmt::format("{}:{}: damaged: its last line is torn", file.string(), number + 1)); }
    return table;
}

}  // namespace kreisel
