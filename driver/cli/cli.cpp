// SPDX-License-Identifier: BSD-3-Clause
#include "driver/cli/cli.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <filesystem>
#include <iostream>
#include <new>

#include "driver/cli/command_line.hpp"
#include "support/errors.hpp"

namespace kreisel {

namespace {

// A file that is opened while one of these is closed gets its number, and what is printed goes into that file. Writing
// to what is opened here fails as before.
void occupy_closed_descriptors() {
    for (const int standard : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) {
        if (::fcntl(standard, F_GETFD) < 0) { ::open("/dev/null", O_RDONLY); }
    }
}

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
    } catch (const std::bad_alloc&) {
        terminal.messages << "out of memory\n";
        return Exit::io;
    } catch (const std::exception& error) {
        terminal.messages << "internal error: " << error.what() << "\n";
        return Exit::internal;
    }
}

int run_with(const Engines& engines, int argc, const char* const* argv) {
    occupy_closed_descriptors();
    const Terminal terminal{std::cout, std::cerr};
    return static_cast<int>(guarded(argc, argv, engines, terminal));
}

}  // namespace

int kreisel_main(int argc, const char* const* argv, const Engine& binary64, const Engine& binary128) {
    return run_with(Engines(binary64, binary128), argc, argv);
}

int kreisel_main(int argc, const char* const* argv, const Engine& binary64) {
    return run_with(Engines(binary64), argc, argv);
}

}  // namespace kreisel
