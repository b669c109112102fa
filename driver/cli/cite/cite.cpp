// SPDX-License-Identifier: BSD-3-Clause
#include "driver/cli/cite/cite.hpp"

#include <fmt/format.h>
#include <fmt/ostream.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <map>
#include <set>
#include <stdexcept>

#include "driver/cli/cite/bibliography.hpp"
#include "driver/config/composition/composed.hpp"
#include "driver/config/config.hpp"
#include "driver/config/shipped.hpp"

namespace kreisel {

namespace {

// What is used, and what states no source.
class CitedSources {
  public:
    // `named`: of a config, names or what has one; `all`: their descriptions.
    template <class Entry, class Description>
    void add(const std::vector<Entry>& named, const std::vector<Description>& all) {
        for (const Entry& entry : named) {
            const std::string& name = name_of(entry);
            const Description& description = *find_named(all, name);
            if (!seen_.insert(name).second) { continue; }
            if (description.cites.empty()) { without_.push_back(name); }
            for (const std::string& key : description.cites) { add_user(key, name); }
        }
    }

    void print(std::ostream& out) {
        add_those_cited_in_entries();
        for (const BibliographyEntry& entry : bibliography()) {
            const auto used = users_.find(entry.key);
            if (used == users_.end()) { continue; }
            fmt::print(out, "% {}\n{}\n\n", fmt::join(used->second, ", "), entry.text);
        }
    }

    const std::vector<std::string>& without() const { return without_; }

  private:
    static const std::string& name_of(const std::string& name) { return name; }
    static const std::string& name_of(const ProblemPoint& problem) { return problem.name(); }
    template <class Entry>
    static const std::string& name_of(const Entry& entry) {
        return entry.name;
    }
    void add_user(const std::string& key, const std::string& name) {
        const auto has_key = [&](const BibliographyEntry& entry) { return entry.key == key; };
        if (std::none_of(bibliography().begin(), bibliography().end(), has_key)) {
            throw std::logic_error(fmt::format("{} cites \"{}\", which is not in the bibliography", name, key));
        }
        std::vector<std::string>& names = users_[key];
        if (std::find(names.begin(), names.end(), name) == names.end()) { names.push_back(name); }
    }

    void add_those_cited_in_entries() {
        for (bool more = true; more;) {
            const auto before = users_.size();
            for (const BibliographyEntry& entry : bibliography()) {
                if (users_.count(entry.key) == 0) { continue; }
                for (const std::string& key : keys_cited_in(entry)) { add_user(key, entry.key); }
            }
            more = users_.size() > before;
        }
    }

    std::map<std::string, std::vector<std::string>> users_;  // by key
    std::set<std::string> seen_;
    std::vector<std::string> without_;
};

}  // namespace

Exit cite_command(const std::filesystem::path& config, const Engines& engines, const Terminal& terminal) {
    const Catalogue catalogue(engines.binary64);
    const Config read = read_config(composed_config(config_file(config)), catalogue);
    CitedSources sources;
    sources.add(read.problems, catalogue.problems);
    sources.add(read.methods, catalogue.methods);
    sources.add(read.projections, catalogue.projections);
    sources.add(read.formulations, catalogue.formulations);
    sources.print(terminal.out);
    if (!sources.without().empty()) {
        fmt::print(terminal.messages, "without a source: {}\n", fmt::join(sources.without(), ", "));
    }
    return Exit::ok;
}

}  // namespace kreisel
