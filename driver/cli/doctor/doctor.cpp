// SPDX-License-Identifier: BSD-3-Clause
#include "driver/cli/doctor/doctor.hpp"

#include <fmt/ostream.h>

#include <algorithm>

#include "driver/cli/doctor/machine.hpp"
#include "driver/cli/doctor/self_test.hpp"
#include "driver/cli/doctor/tools.hpp"
#include "records/json/writer.hpp"

namespace kreisel {

namespace {

const char* word_of(Health health) {
    switch (health) {
        case Health::well:
            return "ok";
        case Health::missing:
            return "missing";
        case Health::poor:
            return "poor";
        case Health::failed:
            return "failed";
    }
    return "";
}

void print_lines(const std::vector<Finding>& findings, std::ostream& out) {
    for (const Finding& finding : findings) {
        fmt::print(out, "{:<8} {:<20}  {}{}{}\n", word_of(finding.health), finding.topic, finding.found,
                   finding.advice.empty() ? "" : ": ", finding.advice);
    }
}

void print_json(const std::vector<Finding>& findings, std::ostream& out) {
    std::string list;
    for (const Finding& finding : findings) {
        list += (list.empty() ? "" : ",\n ") + ObjectWriter()
                                                   .member("topic", json_text(finding.topic))
                                                   .member("state", json_text(word_of(finding.health)))
                                                   .member("found", json_text(finding.found))
                                                   .member("advice", json_text(finding.advice))
                                                   .text();
    }
    fmt::print(out, "[{}]\n", list);
}

}  // namespace

Exit doctor_command(const std::filesystem::path& folder, bool json, const Engines& engines, const Terminal& terminal) {
    std::vector<Finding> findings = find_tools();
    for (const auto& more : {look_at_machine(folder.empty() ? "results" : folder), self_test(engines)}) {
        findings.insert(findings.end(), more.begin(), more.end());
    }
    json ? print_json(findings, terminal.out) : print_lines(findings, terminal.out);
    const bool failed = std::any_of(findings.begin(), findings.end(),
                                    [](const Finding& finding) { return finding.health == Health::failed; });
    return failed ? Exit::cells_failed : Exit::ok;
}

}  // namespace kreisel
