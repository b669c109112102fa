// SPDX-License-Identifier: BSD-3-Clause
#include "driver/cli/cli.hpp"

#include <filesystem>
#include <iostream>

#include "driver/cli/command_line.hpp"
#include "support/errors.hpp"

namespace kreisel {

namespace {

Exit guarded(int argc, const char* const* argv, const Engines& engines, const Terminal& terminal) {
    try {
        CommandLine line(engines, terminal);
        const Exit code = line.run(argc, argv);
        if (!terminal.out.flush()) { throw FileError("standard output: cannot be written"); }
        return code;
    } catch (const UsageError& error) {
        terminal.messages << error.what() << "\n";
        return Exit::usage;
    } catch (const FileError& error) {
        terminal.messages << error.what() << "\n";
        return Exit::io;
    } catch (const std::filesystem::filesystem_error& error) {
        terminal.messages << error.what() << "\n";
        return Exit::io;
    } catch (const std::exception& error) {
        terminal.messages << "internal error: " << error.what() << "\n";
        return Exit::internal;
    }
}

}  // namespace

int kreisel_main(int argc, const char* const* argv, const Engine& binary64, const Engine& binary128) {
    const Engines engines{binary64, binary128};
    const Terminal terminal{std::cout, std::cerr};
    return static_cast<int>(guarded(argc, argv, engines, terminal));
}

}  // namespace kreisel
