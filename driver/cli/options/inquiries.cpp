// SPDX-License-Identifier: BSD-3-Clause
#include "driver/cli/options/inquiries.hpp"

#include "driver/cli/certify/atlas.hpp"
#include "driver/cli/certify/certify.hpp"
#include "driver/cli/cite/cite.hpp"
#include "driver/cli/linearise/linearise.hpp"
#include "driver/cli/published/published.hpp"

namespace kreisel {

namespace {

constexpr const char* one_config = "A JSON file, or the name of a config that comes with kreisel";
constexpr const char* folder_for_table =
    "Folder for the table as Markdown, CSV and LaTeX; files there that are not of kreisel are refused";

}  // namespace

void add_filter(CommandLine& line, CLI::App& list) {
    list.add_option("--family", line.arguments().filter.family,
                    "Only the methods of this family, the name before the slash");
    for (const MethodTrait& trait : method_traits()) {
        list.add_flag_callback(
            "--" + trait.name, [&line, name = trait.name] { line.arguments().filter.traits.push_back(name); },
            trait.summary);
    }
}

void add_inquiries(CommandLine& line) {
    CLI::App* cite = line.command(
        "cite", "BibTeX of the sources of the methods, projections, problems and formulations of a config",
        [&line] { return cite_command(line.arguments().configs.front(), line.engines(), line.terminal()); });
    cite->add_option("config", line.arguments().configs, one_config)->required()->expected(1);
    CLI::App* linearise = line.command(
        "linearise", "Eigenvalues of the motion near the start of each problem, an equilibrium or a steady motion",
        [&line] {
            return linearise_command(line.arguments().configs.front(), line.arguments().output, line.engines(),
                                     line.terminal());
        });
    linearise->add_option("config", line.arguments().configs, one_config)->required()->expected(1);
    linearise->add_option("-o,--output", line.arguments().output, folder_for_table);
    CLI::App* certify =
        line.command("certify", "The data sheet of a method: what it declares, and what is observed", [&line] {
            return certify_command(line.arguments().name, line.arguments().is_long, line.arguments().output,
                                   line.engines(), line.terminal());
        });
    certify->add_option("method", line.arguments().name, "Its name, as kreisel list methods shows it")->required();
    certify->add_option(
        "-o,--output", line.arguments().output,
        "Folder for the sheet as text, Markdown and LaTeX; files there that are not of kreisel are refused");
    certify->add_flag("--long", line.arguments().is_long,
                      "Follow the energy over a million steps and more, not ten thousand");
    CLI::App* atlas = line.command(
        "atlas", "The data sheets of all methods in short, with the orders that convergence studies observed", [&line] {
            return atlas_command(line.arguments().folders, line.arguments().output, line.engines(), line.terminal());
        });
    atlas->add_option("folder", line.arguments().folders, "Results of convergence studies");
    atlas->add_option("-o,--output", line.arguments().output,
                      "Folder for atlas.tex; one there that is not of kreisel is refused");
    CLI::App* published =
        line.command("published", "Published numbers beside ours, and the digits that agree",
                     [&line] { return published_command(line.arguments().output, line.engines(), line.terminal()); });
    published->add_option("-o,--output", line.arguments().output, folder_for_table);
}

}  // namespace kreisel
