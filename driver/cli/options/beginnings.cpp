// SPDX-License-Identifier: BSD-3-Clause
#include "driver/cli/options/beginnings.hpp"

#include <fmt/format.h>

#include "driver/cli/doctor/doctor.hpp"
#include "driver/cli/scaffold/new.hpp"
#include "driver/cli/scaffold/scaffold.hpp"

namespace kreisel {

void add_beginnings(CommandLine& line) {
    CLI::App* begin = line.command("new", "Writes a method, a problem or an experiment to start from", [&line] {
        return new_command(line.arguments().kind, line.arguments().name, line.arguments().output, line.engines(),
                           line.terminal());
    });
    begin->add_option("kind", line.arguments().kind, "One of method, problem, experiment")
        ->required()
        ->check(CLI::IsMember(scaffold_kinds()));
    begin
        ->add_option("name", line.arguments().name,
                     fmt::format("What it is called; of a method FAMILY/SCHEME, where FAMILY is one of\n{}",
                                 fmt::join(scaffold_families(), ", ")))
        ->required();
    begin->add_option("-o,--output", line.arguments().output,
                      "Folder for the file (default: of a method or problem its place in the sources that kreisel\n"
                      "was built from, of an experiment the current folder)");
    begin->footer("The file compiles, or runs, as it is. Nothing is overwritten.");
    CLI::App* doctor =
        line.command("doctor", "What is installed and what this machine allows, and a self-test", [&line] {
            return doctor_command(line.arguments().output, line.arguments().json, line.engines(), line.terminal());
        });
    doctor->add_option("-o,--output", line.arguments().output, "Folder that results are to go to (default: results)");
    doctor->add_flag("--json", line.arguments().json, "Print JSON instead of a table");
    doctor->footer(
        "Exit codes: 0 well, or only missing what some commands need; 1 what is there does not work, results cannot\n"
        "be written, or the self-test failed.");
}

}  // namespace kreisel
