// SPDX-License-Identifier: BSD-3-Clause
#include "driver/config/reading/begin.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <regex>
#include <set>
#include <vector>

#include "driver/config/keys/keys.hpp"
#include "records/json/model_keys.hpp"
#include "records/json/writer.hpp"

namespace kreisel {

namespace {

constexpr const char* expected_state = "a state: an object with \"t\" and \"bodies\", or with the \"file\" of samples";
constexpr std::size_t most_digits = 64;

// Counts its errors, so that what is half read is not taken for a state.
class StateReader {
  public:
    bool ok() const { return ok_; }

    Number number(const Node& node, const char* pattern, const std::string& expected) {
        if (!node.is_string()) {
            const auto value = node.number(expected);
            return value ? Number{*value, json_number(*value)} : missed();
        }
        const auto& text = node.json().get_ref<const std::string&>();
        if (text.size() > most_digits || !std::regex_match(text, std::regex(pattern))) {
            node.mismatch(expected);
            return missed();
        }
        const double value = std::strtod(text.c_str(), nullptr);
        if (!(std::abs(value) <= largest_number)) {
            node.violates(Rule::begin, fmt::format("at most {} in size", largest_number), node.shown());
            return missed();
        }
        return {value, text};
    }
    Number time(const Node& node) {
        const std::string expected = "the time of the sample, at least 0 (s)";
        const Number t = number(node, positive_digits_pattern, expected);
        if (t.value >= 0) { return t; }
        node.mismatch(expected);
        return missed();
    }
    std::array<Number, 3> vector(const std::optional<Node>& node) {
        std::array<Number, 3> all;
        if (!is_three(node, "three numbers")) { return all; }
        for (std::size_t i = 0; i < 3; ++i) { all[i] = number(node->element(i), digits_pattern, "a number"); }
        return all;
    }
    std::array<Number, 9> rotation(const std::optional<Node>& node) {
        std::array<Number, 9> all;
        if (!is_three(node, "three rows of three numbers")) { return all; }
        for (std::size_t i = 0; i < 3; ++i) {
            const auto row = vector(node->element(i));
            std::copy(row.begin(), row.end(), all.begin() + static_cast<std::ptrdiff_t>(3 * i));
        }
        return all;
    }
    ReportedBody body(const Node& node) {
        ReportedBody body;
        if (!keep(node.require_object("the state of a body: an object"))) { return body; }
        node.only_keys(names_of(begin_body_keys()));
        const auto of = [&](const char* key) { return find_key(node, begin_body_keys(), key); };
        const auto named = of("name");
        const auto name = named ? named->text("the name of a body", most_digits) : std::nullopt;
        if (keep(name.has_value())) { body.name = *name; }
        body.x = vector(of("x")), body.R = rotation(of("R"));
        body.v = vector(of("v")), body.omega = vector(of("omega"));
        return body;
    }
    void turns(const Node& node, std::map<std::string, long>& all) {
        if (!keep(node.require_object("an object: the full turns of each torsion spring"))) { return; }
        for (const auto& [name, count] : node.json().items()) {
            const Node entry(count, pointer_below(node.pointer(), name), node.sink());
            const auto read = entry.count(-largest_whole, largest_whole, "a number of full turns");
            if (keep(read.has_value())) { all[name] = *read; }
        }
    }
    bool keep(bool fine) {
        ok_ = ok_ && fine;
        return fine;
    }

  private:
    Number missed() {
        ok_ = false;
        return {};
    }
    bool is_three(const std::optional<Node>& node, const char* expected) {
        const bool three = node && node->is_array() && node->json().size() == 3;
        if (node && !three) { node->mismatch(expected); }
        return keep(three);
    }
    bool ok_ = true;
};

void read_bodies(const Node& node, StateReader& reader, BeginState& state) {
    if (!reader.keep(node.is_array() && !node.json().empty())) {
        node.mismatch("a list of the states of all bodies");
        return;
    }
    std::set<std::string> names;
    for (const Node& entry : node.elements_or_self()) {
        state.bodies.push_back(reader.body(entry));
        const std::string& name = state.bodies.back().name;
        if (name.empty() || names.insert(name).second) { continue; }
        entry.violates(Rule::own_name, "each body once", "a second " + in_quotes(name));
        reader.keep(false);
    }
}

// The keys of a state; "file", which has been replaced by one, is what another key may have been meant to be.
bool has_keys_of_state(const Node& node) {
    std::vector<std::string> names = names_of(begin_keys());
    names.push_back(begin_file_keys().front().name);
    node.only_keys(names);
    const auto known = [&](const auto& entry) {
        return std::find(names.begin(), names.end(), entry.key()) != names.end();
    };
    const auto entries = node.json().items();
    return node.find("bodies") || std::all_of(entries.begin(), entries.end(), known);
}

}  // namespace

std::shared_ptr<const BeginState> read_begin(const Node& node) {
    if (!node.require_object(expected_state) || !has_keys_of_state(node)) { return nullptr; }
    BeginState state;
    StateReader reader;
    const auto t = find_key(node, begin_keys(), "t");
    if (reader.keep(t.has_value())) { state.t = reader.time(*t); }
    const auto bodies = find_key(node, begin_keys(), "bodies");
    if (reader.keep(bodies.has_value())) { read_bodies(*bodies, reader, state); }
    if (const auto turns = find_key(node, begin_keys(), "turns")) { reader.turns(*turns, state.turns); }
    return reader.ok() ? std::make_shared<const BeginState>(std::move(state)) : nullptr;
}

}  // namespace kreisel
