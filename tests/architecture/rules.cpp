// SPDX-License-Identifier: BSD-3-Clause
//
// Rules on includes, licences and citations.
#include "tests/architecture/rules.hpp"

#include <algorithm>
#include <map>
#include <stdexcept>

#include "tests/architecture/matching.hpp"
#include "tests/architecture/rooms.hpp"

namespace architecture {

namespace {

/// Headers that talk to files or to a terminal: the numerical rooms know neither.
const Names talking = {"iostream", "fstream", "cstdio", "filesystem", "stdio.h", "print"};

/// What a room that knows the operating system is held to as well.
const Names third_parties = {"Eigen/", "boost/", "nlohmann/", "CLI/", "fmt/", "gsl/"};

/// Written by the build, so in no folder.
const Names generated = {"kreisel_build.hpp"};

/// The methods in global coordinates, which come from Boost.Odeint.
bool is_baseline(const std::string& path) { return path.starts_with("methods/baseline/"); }

bool contains(const Names& names, const std::string& name) {
    return std::find(names.begin(), names.end(), name) != names.end();
}

bool any_prefix(const Names& prefixes, const std::string& of) {
    return std::any_of(prefixes.begin(), prefixes.end(), [&](const std::string& p) { return of.starts_with(p); });
}

std::string join(const Names& names) {
    std::string list;
    for (const auto& name : names) { list += (list.empty() ? "" : ", ") + name; }
    return list.empty() ? "none" : list;
}

/// Why `source` may not include the library header `header`; empty if it may.
std::string library_breach(const Source& source, const std::string& header) {
    const Room* room = room_of(source.path);
    if (room == nullptr) { return ""; }
    if (!room->talks && contains(talking, header)) {
        return "<" + header + ">: " + room->name + " knows no file and no terminal";
    }
    const bool standard = header.find('/') == std::string::npos && header.find(".h") == std::string::npos;
    if (standard || (room->talks && !any_prefix(third_parties, header))) { return ""; }
    if (any_prefix(room->libraries, header)) { return ""; }
    if (is_baseline(source.path) && any_prefix({"boost/numeric/odeint"}, header)) { return ""; }
    return "<" + header + ">: of libraries, " + room->name + " may include only " + join(room->libraries);
}

/// Why `source` may not include our header `header`; empty if it may.
std::string own_breach(const Source& source, const std::string& header, const std::set<std::string>& files) {
    if (contains(generated, header)) { return ""; }
    if (files.count(header) == 0) {
        return "\"" + header + "\" is not a file of the project (paths start at the root)";
    }
    const Room* room = room_of(source.path);
    if (room == nullptr || room_of(header) == room) { return ""; }
    if (std::any_of(room->reach.begin(), room->reach.end(), [&](const auto& p) { return lies_in(header, p); })) {
        return "";
    }
    return "\"" + header + "\": beside its own, " + room->name + " may include only from " + join(room->reach);
}

bool includes_gsl(const Source& source) { return source.code.find("#include <gsl/") != std::string::npos; }

bool needs_licence(const Source& source) {
    if (source.is_cpp() || source.extension() == ".gp") { return true; }
    if (source.extension() == ".py") { return !source.text.empty(); }  // an empty one marks a package
    return source.text.starts_with("#!");
}

/// The licence on the first or (after #!) second line; empty if there is none.
std::string spdx(const Source& source) {
    static const std::regex line("^(#!.*\n)?(//|#|/\\*) SPDX-License-Identifier: ([A-Za-z0-9.-]+)");
    std::smatch match;
    const bool found = std::regex_search(source.text, match, line, std::regex_constants::match_continuous);
    return found ? match[3].str() : "";
}

void check_key(const Source& source, std::size_t at, const std::string& key, const std::set<std::string>& known,
               std::vector<Finding>& findings) {
    if (known.count(key) != 0) { return; }
    findings.push_back({source.path, source.line_of(at), "cite", key + " is not in the bibliography"});
}

}  // namespace

std::string to_string(const Finding& finding) {
    return finding.path + ":" + std::to_string(finding.line) + ": " + finding.rule + ": " + finding.explanation;
}

std::vector<Finding> check_includes(const std::vector<Source>& tree) {
    static const std::regex include(R"re((^|\n)[ \t]*#[ \t]*include[ \t]*([<"])([^>"\n]+)[>"])re");
    std::set<std::string> files;
    for (const auto& source : tree) { files.insert(source.path); }
    std::vector<Finding> findings;
    for (const auto& source : tree) {
        if (!source.is_cpp()) { continue; }
        each_match(source.text, include, [&](const std::smatch& m) {
            const auto breach = m[2] == "<" ? library_breach(source, m[3]) : own_breach(source, m[3], files);
            const auto line = source.line_of(offset(m, 3));
            if (!breach.empty()) { findings.push_back({source.path, line, "arrow", breach}); }
        });
    }
    return findings;
}

std::vector<Finding> check_rooms(const std::vector<Source>& tree) {
    std::vector<Finding> findings;
    for (const auto& source : tree) {
        if (!source.is_cpp() || room_of(source.path) != nullptr || contains(outbuildings(), source.folder())) {
            continue;
        }
        findings.push_back({source.path, 1, "room", "a source in no room of tests/architecture/rooms.cpp"});
    }
    return findings;
}

std::vector<Finding> check_capacities(const std::vector<Source>& tree) {
    std::map<std::string, std::size_t> counts;
    for (const auto& source : tree) {
        if (source.is_cpp()) { ++counts[source.path.substr(0, source.path.rfind('/'))]; }
    }
    std::vector<Finding> findings;
    for (const auto& [folder, count] : counts) {
        if (count <= capacity_of(folder)) { continue; }
        findings.push_back({folder, 1, "full",
                            std::to_string(count) + " sources in one folder; at most " +
                                std::to_string(capacity_of(folder)) + " are found again"});
    }
    return findings;
}

std::vector<Finding> check_licences(const std::vector<Source>& tree) {
    std::vector<Finding> findings;
    for (const auto& source : tree) {
        if (!needs_licence(source)) { continue; }
        const auto licence = spdx(source);
        if (licence != "BSD-3-Clause" && licence != "GPL-3.0-or-later") {
            findings.push_back({source.path, 1, "licence", "no SPDX line with BSD-3-Clause or GPL-3.0-or-later"});
        } else if (includes_gsl(source) && licence != "GPL-3.0-or-later") {
            findings.push_back({source.path, 1, "licence", "includes GSL, so it is GPL-3.0-or-later"});
        }
    }
    return findings;
}

std::vector<Finding> check_citations(const std::vector<Source>& tree, const std::set<std::string>& bibliography) {
    static const std::regex list(R"re(\.cites\s*=\s*\{([^}]*)\})re");
    static const std::regex quoted(R"re("([^"]*)")re");
    static const std::regex bracketed(R"re(\[([a-z]{3,}[0-9]{4}[a-z0-9]*|terzezlatarmueller)[\],])re");
    std::vector<Finding> findings;
    for (const auto& source : tree) {
        if (!source.is_cpp()) { continue; }
        const auto& text = source.text;
        each_match(text, list, [&](const std::smatch& cites) {
            const auto start = offset(cites, 1);
            each_match(cites[1].str(), quoted, [&](const std::smatch& key) {
                check_key(source, start + offset(key, 1), key[1], bibliography, findings);
            });
        });
        each_match(text, bracketed,
                   [&](const std::smatch& key) { check_key(source, offset(key, 1), key[1], bibliography, findings); });
    }
    return findings;
}

std::set<std::string> bibliography_keys(const std::string& bibtex) {
    static const std::regex entry(R"re((^|\n)[ \t]*@[A-Za-z]+[ \t]*\{[ \t]*([^,\s]+))re");
    std::set<std::string> keys;
    each_match(bibtex, entry, [&](const std::smatch& m) {
        if (!keys.insert(m[2]).second) { throw std::runtime_error("bibliography key stands twice: " + m[2].str()); }
    });
    return keys;
}

std::vector<Finding> check_all(const std::vector<Source>& tree, const std::set<std::string>& bibliography) {
    std::vector<Finding> all = check_citations(tree, bibliography);
    for (auto* rule :
         {&check_includes, &check_rooms, &check_capacities, &check_headers, &check_licences, &check_literals,
          &check_math_calls, &check_precision_namespace, &check_class_names, &check_kinds}) {
        const auto found = (*rule)(tree);
        all.insert(all.end(), found.begin(), found.end());
    }
    return all;
}

}  // namespace architecture
