// SPDX-License-Identifier: BSD-3-Clause
#include "records/csv.hpp"

#include <algorithm>
#include <map>
#include <nlohmann/json.hpp>

namespace kreisel {

namespace {

using nlohmann::json;

// Reads the scalars of one line as text, so that no number changes its digits. Only the objects named here are entered.
class FieldReader final : public nlohmann::json_sax<json> {
  public:
    std::vector<std::pair<std::string, std::string>> fields;

    bool null() override { return true; }
    bool boolean(bool value) override { return add(value ? "true" : "false"); }
    bool number_integer(number_integer_t value) override { return add(std::to_string(value)); }
    bool number_unsigned(number_unsigned_t value) override { return add(std::to_string(value)); }
    bool number_float(number_float_t, const string_t& text) override { return add(text); }
    bool string(string_t& value) override { return add(value); }
    bool binary(binary_t&) override { return false; }
    bool key(string_t& name) override {
        key_ = name;
        return true;
    }
    bool start_object(std::size_t) override { return enter(); }
    bool end_object() override { return leave(); }
    bool start_array(std::size_t) override { return enter(); }
    bool end_array() override { return leave(); }
    bool parse_error(std::size_t, const std::string&, const nlohmann::detail::exception&) override { return false; }

  private:
    bool enter() {
        ++depth_;
        if (depth_ == 2) { group_ = key_; }
        return true;
    }
    bool leave() {
        --depth_;
        if (depth_ == 1) { group_.clear(); }
        return true;
    }
    bool add(const std::string& text) {
        const bool table_group =
            group_ == "options" || group_ == "projection_options" || group_ == "metrics" || group_ == "cost";
        if (depth_ == 1) {
            fields.emplace_back(key_, text);
        } else if (depth_ == 2 && table_group) {
            fields.emplace_back(group_ == "metrics" ? key_ : group_ + "." + key_, text);
        }
        return true;
    }

    int depth_ = 0;
    std::string key_, group_;
};

// Identity first, then options, status, metrics, costs; within a group by first appearance.
int group_rank(const std::string& column) {
    static const std::vector<std::string> heads = {
        "cell", "problem", "label",  "formulation", "method",     "projection", "precision",  "steps",
        "h",    "t_end",   "status", "detail",      "steps_done", "t_reached",  "trajectory", "trajectory_sum"};
    const auto head = std::find(heads.begin(), heads.end(), column);
    if (head != heads.end()) { return static_cast<int>(head - heads.begin()); }
    const int base = static_cast<int>(heads.size());
    if (column.starts_with("options.")) { return base; }
    if (column.starts_with("projection_options.")) { return base + 1; }
    return column.starts_with("cost.") ? base + 3 : base + 2;
}

}  // namespace

std::string csv_field(const std::string& text) {
    if (text.find_first_of(",\"\n\r") == std::string::npos) { return text; }
    std::string quoted = "\"";
    for (const char c : text) { quoted += c == '"' ? std::string("\"\"") : std::string(1, c); }
    return quoted + "\"";
}

std::string results_table(const std::vector<std::string>& lines) {
    std::vector<std::string> columns;
    std::vector<std::map<std::string, std::string>> rows;
    for (const std::string& line : lines) {
        FieldReader reader;
        json::sax_parse(line, &reader);
        for (const auto& [name, text] : reader.fields) {
            if (std::find(columns.begin(), columns.end(), name) == columns.end()) { columns.push_back(name); }
        }
        rows.emplace_back(reader.fields.begin(), reader.fields.end());
    }
    std::stable_sort(columns.begin(), columns.end(),
                     [](const auto& a, const auto& b) { return group_rank(a) < group_rank(b); });
    std::string text;
    for (const std::string& column : columns) { text += (text.empty() ? "" : ",") + csv_field(column); }
    for (const auto& row : rows) {
        for (std::size_t i = 0; i < columns.size(); ++i) {
            const auto field = row.find(columns[i]);
            text += (i == 0 ? "\n" : ",") + (field == row.end() ? "" : csv_field(field->second));
        }
    }
    return text + "\n";
}

}  // namespace kreisel
