// SPDX-License-Identifier: BSD-3-Clause
#include "driver/campaign/workers/printed.hpp"

#include <fcntl.h>
#include <sys/mman.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <iostream>

namespace kreisel {

namespace {

constexpr std::size_t most_printed = 4096;  // bytes

}  // namespace

Printed Printed::make() {
    Descriptor file(::memfd_create("printed", MFD_CLOEXEC | MFD_ALLOW_SEALING));
    if (!file.valid()) { return Printed(Descriptor()); }
    const bool sealed = ::ftruncate(file.number(), most_printed) == 0 &&
                        ::fcntl(file.number(), F_ADD_SEALS, F_SEAL_GROW | F_SEAL_SHRINK) == 0;
    return Printed(sealed ? std::move(file) : Descriptor());
}

void Printed::divert() const {
    ::dup2(file_.number(), STDOUT_FILENO);
    ::dup2(file_.number(), STDERR_FILENO);
    std::setvbuf(stdout, nullptr, _IONBF, 0);
}

std::string Printed::take() const {
    const off_t end = ::lseek(file_.number(), 0, SEEK_CUR);
    if (end <= 0) { return ""; }
    std::string text(std::min(static_cast<std::size_t>(end), most_printed), '\0');
    const ssize_t read = ::pread(file_.number(), text.data(), text.size(), 0);
    text.resize(read < 0 ? 0 : static_cast<std::size_t>(read));
    ::lseek(file_.number(), 0, SEEK_SET);
    std::cout.clear();  // writing past the end was an error
    std::cerr.clear();
    std::clearerr(stdout);
    const auto is_control = [](char c) { return static_cast<unsigned char>(c) < ' '; };
    std::replace_if(text.begin(), text.end(), is_control, ' ');
    const auto last = text.find_last_not_of(' ');
    return text.substr(0, last == std::string::npos ? 0 : last + 1);
}

}  // namespace kreisel
