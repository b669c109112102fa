// SPDX-License-Identifier: BSD-3-Clause
//
// What a kind of experiments or figures is like is stated in its file, and nowhere else asked by name.
#include <algorithm>
#include <regex>
#include <set>

#include "tests/architecture/matching.hpp"
#include "tests/architecture/rules.hpp"

namespace architecture {

namespace {

bool registers(const Source& source) {
    return source.is_cpp() && (source.code.find("\nKREISEL_EXPERIMENT(") != std::string::npos ||
                               source.code.find("\nKREISEL_FIGURE(") != std::string::npos ||
                               source.code.find("\nKREISEL_TABLE(") != std::string::npos);
}

std::set<std::string> names_of_kinds(const std::vector<Source>& tree) {
    static const std::regex registration(R"re(\nKREISEL_(?:EXPERIMENT|FIGURE)\([^"]*\.name = "([a-z0-9_]+)")re");
    std::set<std::string> names;
    for (const Source& source : tree) {
        if (!registers(source)) { continue; }
        each_match(source.text, registration, [&](const std::smatch& match) { names.insert(match[1]); });
    }
    return names;
}

/// In the driver and in plots a literal is enough. Files of results have members called like kinds ("trajectory"), and
/// files that register one name it and what it draws, so that there only comparisons count.
bool asks(const Source& source, std::size_t at, std::size_t end) {
    const std::string folder = source.folder();
    if (folder != "records" && folder != "driver" && folder != "plots") { return false; }
    if (folder != "records" && !registers(source)) { return true; }
    const auto compares = [](const std::string& text) {
        return text.find("==") != std::string::npos || text.find("!=") != std::string::npos;
    };
    return compares(source.code.substr(at < 4 ? 0 : at - 4, 4)) || compares(source.code.substr(end, 4));
}

}  // namespace

std::vector<Finding> check_kinds(const std::vector<Source>& tree) {
    static const std::regex literal(R"re("([a-z0-9_]+)")re");
    const std::set<std::string> kinds = names_of_kinds(tree);
    std::vector<Finding> findings;
    for (const Source& source : tree) {
        if (!source.is_cpp()) { continue; }
        each_match(source.text, literal, [&](const std::smatch& match) {
            const std::size_t at = offset(match), end = at + match.str().size();
            const bool in_code = source.code[at] == '"' && source.code[end - 1] == '"';
            if (!in_code || kinds.count(match[1]) == 0 || !asks(source, at, end)) { return; }
            findings.push_back({source.path, source.line_of(at), "kind",
                                match.str() + " is a kind: what depends on it belongs to the file that registers it"});
        });
    }
    return findings;
}

}  // namespace architecture
