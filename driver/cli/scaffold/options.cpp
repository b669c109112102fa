// SPDX-License-Identifier: BSD-3-Clause
//
// Commands for those who begin: is everything there, and a file to start from.
#include <fmt/format.h>

#include "driver/cli/command_line.hpp"
#include "driver/cli/doctor/doctor.hpp"
#include "driver/cli/scaffold/new.hpp"
#include "driver/cli/scaffold/scaffold.hpp"

namespace kreisel {

void CommandLine::add_beginnings() {
    CLI::App* begin = command("new", "Writes a method, a problem or an experiment to start from", [this] {
        return new_command(arguments_.kind, arguments_.name, arguments_.output, engines_, terminal_);
    });
    begin->add_option("kind", arguments_.kind, "One of method, problem, experiment")
        ->required()
        ->check(CLI::IsMember(scaffold_kinds()));
    begin
        ->add_option("name", arguments_.name,
                     fmt::format("What it is called; of a method FAMILY/SCHEME, where FAMILY is one of\n{}",
                                 fmt::join(scaffold_families(), ", ")))
        ->required();
    begin->add_option("-o,--output", arguments_.output,
                      "Folder for the file (default: of a method or problem its place in the sources that kreisel\n"
                      "was built from, of an experiment the current folder)");
    begin->footer("The file compiles, or runs, as it is. Nothing is overwritten.");
    CLI::App* doctor = command("doctor", "What is installed and what this machine allows, and a self-test", [this] {
        return doctor_command(arguments_.output, arguments_.json, engines_, terminal_);
    });
    doctor->add_option("-o,--output", arguments_.output, "Folder that results are to go to (default: results)");
    doctor->add_flag("--json", arguments_.json, "Print JSON instead of a table");
    doctor->footer(
        "Exit codes: 0 well, or only missing what some commands need; 1 what is there does not work, results cannot\n"
        "be written, or the self-test failed.");
}

}  // namespace kreisel
