// SPDX-License-Identifier: BSD-3-Clause
#include "methods/conditions/tableau_options.hpp"

#include <map>
#include <mutex>

#include "methods/conditions/tableau_orders.hpp"
#include "methods/conditions/written_tableau.hpp"

namespace kreisel {

namespace {

using orders::Rational;
using orders::WrittenTableau;

/// Roundings of several coefficients meet in a condition.
constexpr int several = 100;

long count_of(const OptionValues& options, const std::string& name) { return std::get<long>(options.at(name)); }

std::string brief(const Rational& x) {
    const std::string text = x.str();
    return text.size() <= 24 ? text : x.convert_to<orders::Float100>().str(12);
}

void check_nodes(const WrittenTableau& written, const Rational& slack) {
    for (std::size_t i = 0; i < written.nodes.size(); ++i) {
        Rational sum = 0;
        for (const Rational& entry : written.exact.a[i]) sum += entry;
        if (abs(Rational(sum - written.nodes[i])) > slack)
            throw OptionError("c", "expected the sum of each row of a, got " + brief(written.nodes[i]) + " for row " +
                                       std::to_string(i + 1) + ", which sums to " + brief(sum));
    }
}

void check_order(const std::string& option, long declared, int found, const std::string& missed) {
    if (declared == found) return;
    throw OptionError(option, "expected " + std::to_string(found) + ", the order that the weights have, got " +
                                  std::to_string(declared) + (found < declared ? ": " + missed : ""));
}

void check_orders(const OptionValues& options, const WrittenTableau& written, const Rational& slack) {
    const long order = count_of(options, "order"), order_hat = count_of(options, "order_hat");
    const bool pair = !written.exact.b_hat.empty();
    if (pair != (order_hat > 0))
        throw OptionError("order_hat", pair ? "expected the order of the weights b_hat, got none"
                                            : "expected 0, as there is no b_hat, got " + std::to_string(order_hat));
    const orders::TableauOrders found = orders::tableau_orders(written.exact, slack);
    check_order("order", order, found.step, found.missed);
    if (!pair) return;
    check_order("order_hat", order_hat, found.embedded, found.missed_embedded);
    if (order == order_hat)
        throw OptionError("order_hat", "expected another order than that of b, of which the error is estimated, got " +
                                           std::to_string(order_hat) + " twice");
}

std::string key_of(const OptionValues& options) {
    std::string key = std::to_string(count_of(options, "order")) + "|" + std::to_string(count_of(options, "order_hat"));
    for (const char* name : {"a", "b", "b_hat", "c"}) key += "|" + std::get<std::string>(options.at(name));
    return key;
}

}  // namespace

std::vector<OptionDescription> tableau_options() {
    return {{.name = "a",
             .summary = "rows of the tableau, from the second; by default those of rkmk/rk4",
             .standard = "1/2; 0 1/2; 0 0 1",
             .text = OptionText::rows},
            {.name = "b", .summary = "weights", .standard = "1/6 1/3 1/3 1/6", .text = OptionText::numbers},
            {.name = "b_hat",
             .summary = "weights of an embedded solution, to choose steps to a tolerance by",
             .standard = "",
             .text = OptionText::numbers},
            {.name = "c",
             .summary = "nodes, for a check: a row that does not sum to its node is named",
             .standard = "",
             .text = OptionText::numbers},
            {.name = "order",
             .summary = "order of the tableau, which is verified before it runs",
             .standard = 4L,
             .count_min = 1,
             .count_max = orders::most_order},
            {.name = "order_hat",
             .summary = "order of the embedded solution, likewise",
             .standard = 0L,
             .count_min = 0,
             .count_max = orders::most_order},
            {.name = "label",
             .summary = "what tables and figures call the tableau",
             .standard = "",
             .text = OptionText::label}};
}

const Tableau& verified_tableau(const OptionValues& options) {
    static std::map<std::string, WrittenTableau> verified;
    static std::mutex mutex;
    const std::scoped_lock lock(mutex);
    const std::string key = key_of(options);
    if (const auto known = verified.find(key); known != verified.end()) return known->second.tableau;
    WrittenTableau written = orders::read_tableau(options);
    const Rational slack = several * orders::rounding(written.rounded);
    check_nodes(written, slack);
    check_orders(options, written, slack);
    return verified.emplace(key, std::move(written)).first->second.tableau;
}

int estimate_of_tableau(const OptionValues& options) {
    const long lower = std::min(count_of(options, "order"), count_of(options, "order_hat"));
    return lower > 0 ? static_cast<int>(lower) + 1 : 0;
}

}  // namespace kreisel
