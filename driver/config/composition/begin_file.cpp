// SPDX-License-Identifier: BSD-3-Clause
#include "driver/config/composition/begin_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <limits>

#include "driver/config/catalogue.hpp"
#include "driver/config/keys/keys.hpp"
#include "records/begin.hpp"
#include "records/folder/damage.hpp"
#include "records/json/node.hpp"
#include "records/json/strict.hpp"
#include "records/results.hpp"
#include "support/errors.hpp"
#include "support/files.hpp"
#include "support/paths/at_path.hpp"

namespace kreisel {

namespace {

namespace fs = std::filesystem;
using nlohmann::json;

constexpr const char* begin_place = "/time/begin";
constexpr const char* expected_samples = "the path of a trajectory, relative to this file's folder";
constexpr const char* time_title = "t [s]";
constexpr double same_time = 1e-9;  // relative: times are sums of steps

std::vector<std::string> fields_of(const std::string& line) {
    std::vector<std::string> fields(1);
    for (const char c : line) { c == ',' ? fields.emplace_back() : fields.back() += c; }
    return fields;
}

[[noreturn]] void refuse_samples(const fs::path& file, long line, const std::string& reason) {
    throw FileError(fmt::format("{}:{}: damaged: {}", file.string(), line, reason));
}

// One sample of a file, as text.
struct Sample {
    std::vector<std::string> titles, fields;
    long line = 0;
    double t = 0;
};

// Looks for the sample at a time, or for the last.
class SampleSearch {
  public:
    SampleSearch(const fs::path& file, std::optional<double> wanted) : file_(file), wanted_(wanted) {
        const bool whole = for_each_line(file, [&](std::uint64_t, const std::string& line) { take(line); });
        if (!whole) { refuse_samples(file, line_ + 1, "its last line is torn"); }
        if (best_.fields.empty()) { refuse_samples(file, line_ + 1, "it has no sample"); }
    }
    const Sample& nearest() const { return best_; }
    bool found() const { return !wanted_ || std::abs(best_.t - *wanted_) <= same_time * std::abs(*wanted_); }
    double first() const { return first_; }
    double last() const { return last_; }

  private:
    void take(const std::string& line) {
        std::vector<std::string> fields = fields_of(line);
        if (++line_ == 1) {
            best_.titles = std::move(fields);
            return;
        }
        if (fields.size() != best_.titles.size()) { refuse_samples(file_, line_, "wrong number of columns"); }
        char* end = nullptr;
        const double t = std::strtod(fields[0].c_str(), &end);
        if (fields[0].empty() || *end != '\0' || !std::isfinite(t)) {
            refuse_samples(file_, line_, "its time is no number");
        }
        if (line_ == 2) { first_ = t; }
        last_ = t;
        const double off = wanted_ ? std::abs(t - *wanted_) : -t;
        if (!best_.fields.empty() && off >= off_) { return; }
        off_ = off;
        best_.fields = std::move(fields), best_.line = line_, best_.t = t;
    }

    const fs::path& file_;
    std::optional<double> wanted_;
    Sample best_;
    long line_ = 0;
    double first_ = 0, last_ = 0, off_ = 0;
};

// The state that a sample has.
class StateOfSample {
  public:
    StateOfSample(const fs::path& file, const Sample& sample) : file_(file), sample_(sample) {}

    BeginState read() const {
        BeginState state;
        state.t = number(time_title);
        for (const std::string& title : sample_.titles) {
            if (title.ends_with(".x1 [m]")) { state.bodies.push_back(body(title.substr(0, title.size() - 7))); }
            if (title.starts_with("turns.") && title.ends_with(" [1]")) {
                const std::string spring = title.substr(6, title.size() - 10);
                state.turns[spring] = std::lround(number(title).value);
            }
        }
        if (state.bodies.empty()) { refuse_samples(file_, 1, "expected samples of bodies, such as top.x1 [m]"); }
        return state;
    }

  private:
    Number number(const std::string& title) const {
        const auto found = std::find(sample_.titles.begin(), sample_.titles.end(), title);
        if (found == sample_.titles.end()) { refuse_samples(file_, 1, fmt::format("it has no column {}", title)); }
        const std::string& text = sample_.fields[static_cast<std::size_t>(found - sample_.titles.begin())];
        char* end = nullptr;
        const double value = std::strtod(text.c_str(), &end);
        if (text.empty() || *end != '\0' || !(std::abs(value) <= largest_number)) {
            refuse_samples(file_, sample_.line, fmt::format("{} is no number", title));
        }
        return {value, text};
    }
    std::array<Number, 3> vector(const std::string& quantity, const char* unit) const {
        std::array<Number, 3> all;
        for (std::size_t i = 0; i < 3; ++i) { all[i] = number(fmt::format("{}{} [{}]", quantity, i + 1, unit)); }
        return all;
    }
    ReportedBody body(const std::string& name) const {
        ReportedBody body;
        body.name = name;
        body.x = vector(name + ".x", "m");
        for (std::size_t i = 0; i < 9; ++i) {
            body.R[i] = number(fmt::format("{}.R{}{} [1]", name, i / 3 + 1, i % 3 + 1));
        }
        body.v = vector(name + ".v", "m/s"), body.omega = vector(name + ".omega", "rad/s");
        return body;
    }

    const fs::path& file_;
    const Sample& sample_;
};

// Of samples in a results folder: throws where their cell records another sum.
void check_sum_of_samples(const fs::path& file) {
    const fs::path folder = file.parent_path().parent_path(), results = folder / "results.jsonl";
    if (file.parent_path().filename() != "trajectories" || !leads_to_file(results)) { return; }
    const std::string cell = file.stem().string();
    for (const std::string& line : read_lines(results)) {
        if (line.find(cell) == std::string::npos) { continue; }
        const ResultRow row = read_result_line(line);
        if (row.cell != cell || row.trajectory_sum.empty()) { continue; }
        const std::string damage = trajectory_damage(folder, cell, row.trajectory_sum);
        if (!damage.empty()) { throw FileError(damage); }
    }
}

fs::path file_named(const Document& config, const Node& begin, const Diagnostics& sink) {
    const Node written = *begin.find("file");
    const auto path = written.text(expected_samples, 4096);
    sink.raise();
    const fs::path file = (folder_of(config, std::string(begin_place) + "/file") / *path).lexically_normal();
    if (path->empty() || !leads_to_file(file)) {
        written.violates(Rule::file, expected_samples, which_is_no_file(in_quotes(*path), file));
        sink.raise();
    }
    return file;
}

// Other tables are not damaged: they are no samples.
void require_samples(const fs::path& file, const Node& begin, const Diagnostics& sink) {
    std::string first;
    std::getline(std::ifstream(file), first);
    const std::string column = fields_of(first).front();
    if (column == time_title) { return; }
    const bool has_trajectories = fs::is_directory(file.parent_path() / "trajectories");
    begin.find("file")->violates(
        Rule::file, fmt::format("{}: a table whose first column is \"{}\"", expected_samples, time_title),
        column.empty() ? "one that begins with an empty line"
                       : fmt::format("one whose first line begins with {}{}", in_quotes(column),
                                     has_trajectories ? "; trajectories of cells are in the folder \"trajectories\" "
                                                        "beside it"
                                                      : ""));
    sink.raise();
}

std::optional<double> time_wanted(const Node& begin, const Diagnostics& sink) {
    const auto node = begin.find("t");
    if (!node) { return std::nullopt; }
    const std::string expected = "the time of a sample, at least 0 (s)";
    const auto t = node->number(expected);
    if (t && *t < 0) { node->mismatch(expected); }
    sink.raise();
    return t;
}

json state_in(const fs::path& file, const Node& begin, const Diagnostics& sink) {
    const auto wanted = time_wanted(begin, sink);
    require_samples(file, begin, sink);
    check_sum_of_samples(file);
    const SampleSearch search(file, wanted);
    if (!search.found()) {
        begin.find("t")->violates(
            Rule::begin,
            fmt::format("the time of a sample of {}, from {} to {} s", file.string(), search.first(), search.last()),
            fmt::format("{}, to which that at {} s is nearest", *wanted, search.nearest().t));
        sink.raise();
    }
    return json::parse(json_begin(StateOfSample(file, search.nearest()).read()));
}

bool names_samples(const json& config) {
    if (!config.is_object() || !config.contains("time") || !config["time"].is_object()) { return false; }
    const json& time = config["time"];
    return time.contains("begin") && time["begin"].is_object() && time["begin"].contains("file");
}

}  // namespace

void insert_begin_file(Document& config) {
    if (!names_samples(config.value)) { return; }
    Diagnostics sink(config);
    const Node begin(config.value[json::json_pointer(begin_place)], begin_place, sink);
    begin.only_keys(names_of(begin_file_keys()));
    sink.raise();
    const fs::path file = file_named(config, begin, sink);
    json state = state_in(file, begin, sink);
    Document sample{fmt::format("{} as JSON", file.string()), state.dump(2), state};
    config.layers = layers_of(config);
    // Before the layers of the config: what is wrong with the state as a whole is said where that names it.
    config.layers.insert(config.layers.begin(), {begin_place, std::make_shared<const Document>(std::move(sample))});
    config.value[json::json_pointer(begin_place)] = std::move(state);
    config.text = config.value.dump(2);
}

}  // namespace kreisel
