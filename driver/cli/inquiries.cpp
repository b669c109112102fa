// SPDX-License-Identifier: BSD-3-Clause
//
// Commands that ask about methods and configs without running an experiment of the user.
#include "driver/cli/certify/atlas.hpp"
#include "driver/cli/certify/certify.hpp"
#include "driver/cli/cite/cite.hpp"
#include "driver/cli/command_line.hpp"
#include "driver/cli/linearise/linearise.hpp"
#include "driver/cli/published/published.hpp"

namespace kreisel {

namespace {

constexpr const char* one_config = "A JSON file, or the name of a config that comes with kreisel";

}  // namespace

void CommandLine::add_filter(CLI::App& list) {
    list.add_option("--family", arguments_.filter.family, "Only the methods of this family, the name before the slash");
    for (const MethodTrait& trait : method_traits()) {
        list.add_flag_callback(
            "--" + trait.name, [this, name = trait.name] { arguments_.filter.traits.push_back(name); }, trait.summary);
    }
}

void CommandLine::add_inquiries() {
    CLI::App* cite =
        command("cite", "BibTeX of the sources of the methods, projections, problems and formulations of a config",
                [this] { return cite_command(arguments_.configs.front(), engines_, terminal_); });
    cite->add_option("config", arguments_.configs, one_config)->required()->expected(1);
    CLI::App* linearise = command(
        "linearise", "Eigenvalues of the motion near the start of each problem, an equilibrium or a steady motion",
        [this] { return linearise_command(arguments_.configs.front(), arguments_.output, engines_, terminal_); });
    linearise->add_option("config", arguments_.configs, one_config)->required()->expected(1);
    linearise->add_option("-o,--output", arguments_.output, "Folder for the table as Markdown, CSV and LaTeX");
    CLI::App* certify =
        command("certify", "The data sheet of a method: what it declares, and what is observed", [this] {
            return certify_command(arguments_.name, arguments_.is_long, arguments_.output, engines_, terminal_);
        });
    certify->add_option("method", arguments_.name, "Its name, as kreisel list methods shows it")->required();
    certify->add_option("-o,--output", arguments_.output, "Folder for the sheet as text, Markdown and LaTeX");
    certify->add_flag("--long", arguments_.is_long,
                      "Follow the energy over a million steps and more, not ten thousand");
    CLI::App* atlas =
        command("atlas", "The data sheets of all methods in short, with the orders that convergence studies observed",
                [this] { return atlas_command(arguments_.folders, arguments_.output, engines_, terminal_); });
    atlas->add_option("folder", arguments_.folders, "Results of convergence studies");
    atlas->add_option("-o,--output", arguments_.output, "Folder for atlas.tex");
    CLI::App* published = command("published", "Published numbers beside ours, and the digits that agree",
                                  [this] { return published_command(arguments_.output, engines_, terminal_); });
    published->add_option("-o,--output", arguments_.output, "Folder for the table as Markdown, CSV and LaTeX");
}

}  // namespace kreisel
