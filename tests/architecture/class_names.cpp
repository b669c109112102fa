// SPDX-License-Identifier: BSD-3-Clause
//
// Two classes of one name in one namespace are one class to the linker, which keeps the member functions of either: the
// other file then works on memory laid out for something else. No compiler warns, since each sees one of them only. The
// inline namespaces of the precisions are their parents to whoever reads a name, so that they count as these.
#include <algorithm>
#include <array>
#include <map>
#include <regex>

#include "tests/architecture/rules.hpp"

namespace architecture {

namespace {

struct Scope {
    std::string name;  // of a namespace; empty: unnamed
    bool is_namespace = false;
};

/// "kreisel::", or nothing where what is defined here has no name outside of its file or function.
std::string path_of(const std::vector<Scope>& scopes) {
    std::string path;
    for (const Scope& scope : scopes) {
        if (!scope.is_namespace || scope.name.empty()) { return ""; }
        if (scope.name != "KREISEL_PRECISION") { path += scope.name + "::"; }
    }
    return path;
}

struct Definition {
    std::string name;  // with its namespaces
    int line = 0;
};

/// Classes, structs and enumerations that a file defines at namespace scope, not in an unnamed namespace.
std::vector<Definition> definitions(const Source& source) {
    static const std::regex token(
        R"(\bnamespace\s*([\w:]*)\s*\{|\b(?:class|struct)\s+(\w+)\s*(?:final\s*)?(?::[^{};()]*)?\{|\{|\})");
    std::vector<Definition> found;
    std::vector<Scope> scopes;
    for (std::sregex_iterator i(source.code.begin(), source.code.end(), token), end; i != end; ++i) {
        const std::string text = i->str();
        if (text == "}") {
            if (!scopes.empty()) { scopes.pop_back(); }
            continue;
        }
        if ((*i)[2].matched) {
            const std::string path = path_of(scopes);
            if (!path.empty()) {
                found.push_back({path + (*i)[2].str(), source.line_of(static_cast<std::size_t>(i->position()))});
            }
        }
        scopes.push_back({(*i)[1].str(), text.rfind("namespace", 0) == 0});
    }
    return found;
}

bool is_linked_into_the_program(const Source& source) {
    static const std::array<std::string, 10> folders = {"lie",    "mechanics", "problems", "methods", "peers",
                                                        "engine", "records",   "plots",    "driver",  "support"};
    return source.is_cpp() && std::find(folders.begin(), folders.end(), source.folder()) != folders.end();
}

}  // namespace

std::vector<Finding> check_class_names(const std::vector<Source>& tree) {
    std::map<std::string, std::string> known;
    std::vector<Finding> findings;
    for (const Source& source : tree) {
        if (!is_linked_into_the_program(source)) { continue; }
        for (const Definition& definition : definitions(source)) {
            const auto [entry, is_new] = known.insert({definition.name, source.path});
            if (!is_new && entry->second != source.path) {
                findings.push_back({source.path, definition.line, "class",
                                    definition.name + " is defined in " + entry->second + " too"});
            }
        }
    }
    return findings;
}

}  // namespace architecture
