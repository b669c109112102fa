// SPDX-License-Identifier: BSD-3-Clause
#include "records/begin.hpp"

#include "records/json/lists.hpp"
#include "records/json/writer.hpp"

namespace kreisel {

namespace {

std::string json_body(const ReportedBody& body) {
    return ObjectWriter()
        .member("name", json_text(body.name))
        .member("x", json_list(body.x, json_digits))
        .member("R", json_rows(body.R, json_digits))
        .member("v", json_list(body.v, json_digits))
        .member("omega", json_list(body.omega, json_digits))
        .text();
}

}  // namespace

std::string json_digits(const Number& number) {
    return json_number(number.value) == number.text ? number.text : json_text(number.text);
}

std::string json_begin(const BeginState& begin) {
    ObjectWriter object;
    object.member("t", json_digits(begin.t)).member("bodies", json_list(begin.bodies, json_body));
    if (begin.turns.empty()) { return object.text(); }
    ObjectWriter turns;
    for (const auto& [spring, count] : begin.turns) { turns.member(spring, std::to_string(count)); }
    return object.member("turns", turns.text()).text();
}

}  // namespace kreisel
