// SPDX-License-Identifier: BSD-3-Clause
#include "plots/figures/overlay/overlay_files.hpp"

#include <fmt/format.h>

#include <boost/tokenizer.hpp>
#include <charconv>
#include <cmath>

#include "plots/figures/overlay/overlay.hpp"
#include "records/json/node.hpp"
#include "support/errors.hpp"
#include "support/files.hpp"
#include "support/nearest.hpp"
#include "support/paths/at_path.hpp"

namespace kreisel {

namespace {

using nlohmann::json;

constexpr const char* expected_path = "the path of a CSV file, relative to this file's folder";

std::vector<std::string> fields_of(const std::string& line, const std::string& place) {
    try {
        const boost::tokenizer<boost::escaped_list_separator<char>> fields(line);
        return {fields.begin(), fields.end()};
    } catch (const boost::escaped_list_error& error) {
        throw UsageError(
            fmt::format("{}: expected fields separated by commas, got {} ({})", place, in_quotes(line), error.what()));
    }
}

std::string without_unit(const std::string& title) { return title.substr(0, title.find(" [")); }

// A CSV file whose first line has titles.
class CsvFile {
  public:
    explicit CsvFile(std::filesystem::path file) : file_(std::move(file)), lines_(read_lines(file_)) {
        if (lines_.empty()) {
            throw UsageError(fmt::format("{}: expected a line of titles, got none", file_.string()));
        }
        titles_ = fields_of(lines_.front(), place(0));
    }

    std::size_t column(const Node& key) const {
        const auto title = key.text("the title of a column", 200);
        if (!title) { return 0; }
        for (std::size_t i = 0; i < titles_.size(); ++i) {
            if (titles_[i] == *title || without_unit(titles_[i]) == *title) { return i; }
        }
        key.violates(Rule::file, fmt::format("a column of {} ({})", file_.string(), fmt::join(titles_, ", ")),
                     in_quotes(*title));
        return 0;
    }

    // Pairs of numbers; null where a field is empty.
    json points(std::size_t x, std::size_t y) const {
        json all = json::array();
        for (std::size_t i = 1; i < lines_.size(); ++i) {
            if (lines_[i].empty() || lines_[i] == "\r") { continue; }
            const auto fields = fields_of(lines_[i], place(i));
            if (fields.size() != titles_.size()) {
                throw UsageError(
                    fmt::format("{}: expected {} fields, got {}", place(i), titles_.size(), fields.size()));
            }
            all.push_back({number(fields[x], i), number(fields[y], i)});
            if (all.size() > most_overlay_points) {
                throw UsageError(fmt::format("{}: expected at most {} points", file_.string(), most_overlay_points));
            }
        }
        if (all.empty()) { throw UsageError(fmt::format("{}: expected points, got titles only", file_.string())); }
        return all;
    }

  private:
    std::string place(std::size_t i) const { return fmt::format("{}:{}", file_.string(), i + 1); }

    json number(std::string field, std::size_t line) const {
        while (!field.empty() && (field.back() == '\r' || field.back() == ' ')) { field.pop_back(); }
        const std::size_t first = field.find_first_not_of(" +");
        if (first == std::string::npos) { return nullptr; }
        double value = 0;
        const char* end = field.data() + field.size();
        const auto read = std::from_chars(field.data() + first, end, value);
        if (read.ec == std::errc() && read.ptr == end && std::abs(value) <= largest_number) { return value; }
        throw UsageError(fmt::format("{}: expected a number of at most {:g} in size, got {}", place(line),
                                     largest_number, in_quotes(field)));
    }

    std::filesystem::path file_;
    std::vector<std::string> lines_, titles_;
};

// The overlay at `pointer` with points in place of its file.
json with_points(const Document& document, const std::string& pointer) {
    Diagnostics sink(document);
    const Node overlay(document.value.at(json::json_pointer(pointer)), pointer, sink);
    const auto x = overlay.require("x", "the title of a column"), y = overlay.require("y", "the title of a column");
    const Node written = *overlay.find("file");
    const auto path = written.text(expected_path, 4096);
    sink.raise();
    const std::filesystem::path file = (folder_of(document, pointer + "/file") / *path).lexically_normal();
    if (!leads_to_file(file)) {
        written.violates(Rule::file, expected_path, which_is_no_file(in_quotes(*path), file));
        sink.raise();
    }
    const CsvFile csv(file);
    const std::size_t x_column = csv.column(*x), y_column = csv.column(*y);
    sink.raise();
    json changed = overlay.json();
    for (const char* key : {"file", "x", "y"}) { changed.erase(key); }
    changed["points"] = csv.points(x_column, y_column);
    return changed;
}

// The pointers of an object, or of the objects of a list.
std::vector<std::string> objects_at(const Document& document, const std::string& pointer) {
    const json::json_pointer place(pointer);
    std::vector<std::string> found;
    if (!document.value.contains(place) && !pointer.empty()) { return found; }
    const json& value = document.value.at(place);
    if (value.is_object()) { found.push_back(pointer); }
    for (std::size_t i = 0; value.is_array() && i < value.size(); ++i) {
        if (value[i].is_object()) { found.push_back(fmt::format("{}/{}", pointer, i)); }
    }
    return found;
}

}  // namespace

void insert_overlay_files(Document& document, const std::string& pointer) {
    for (const std::string& figure : objects_at(document, pointer)) {
        for (const std::string& overlay : objects_at(document, figure + "/overlay")) {
            const json::json_pointer place(overlay);
            if (!document.value.at(place).contains("file")) { continue; }
            json changed = with_points(document, overlay);
            document.layers = layers_of(document);
            document.value[place] = std::move(changed);
            document.text = document.value.dump(2);
        }
    }
}

}  // namespace kreisel
