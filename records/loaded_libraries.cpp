// SPDX-License-Identifier: BSD-3-Clause
#include "records/loaded_libraries.hpp"

#include <elf.h>
#include <fmt/format.h>
#include <link.h>
#include <sys/utsname.h>
#ifdef __x86_64__
#include <sys/platform/x86.h>
#endif

#include <algorithm>
#include <array>
#include <cstring>
#include <filesystem>

namespace kreisel {

namespace {

using Libraries = std::vector<std::pair<std::string, std::string>>;

// libc converts decimals. The others are of the numerical code and of the baselines in peers/.
constexpr std::array numerical_stems = {"libc.so",     "libm.so",      "libmvec.so",  "libquadmath.so",
                                        "libgcc_s.so", "libstdc++.so", "libgsl.so",   "libgslcblas.so",
                                        "libsundials", "libblas",      "libopenblas", "liblapack"};

bool is_numerical(const std::string& name) {
    return std::any_of(numerical_stems.begin(), numerical_stems.end(),
                       [&](const char* stem) { return name.starts_with(stem); });
}

constexpr std::size_t aligned(std::size_t size) { return (size + 3) / 4 * 4; }

// The build id among the notes of a segment.
std::string build_id_in(const char* note, std::size_t size) {
    while (size >= sizeof(ElfW(Nhdr))) {
        ElfW(Nhdr) head;
        std::memcpy(&head, note, sizeof head);
        const std::size_t name_at = sizeof head, value_at = name_at + aligned(head.n_namesz);
        const std::size_t length = value_at + aligned(head.n_descsz);
        if (length > size) { return ""; }
        if (head.n_type == NT_GNU_BUILD_ID && head.n_namesz == 4 && std::memcmp(note + name_at, "GNU", 4) == 0) {
            std::string text;
            for (std::size_t i = 0; i < head.n_descsz; ++i) {
                text += fmt::format("{:02x}", static_cast<unsigned char>(note[value_at + i]));
            }
            return text;
        }
        note += length;
        size -= length;
    }
    return "";
}

std::string build_id_of(const dl_phdr_info& object) {
    for (std::size_t i = 0; i < object.dlpi_phnum; ++i) {
        const auto& segment = object.dlpi_phdr[i];
        if (segment.p_type != PT_NOTE) { continue; }
        const void* start = reinterpret_cast<const void*>(object.dlpi_addr + segment.p_vaddr);  // NOLINT: as loaded
        const std::string id = build_id_in(static_cast<const char*>(start), segment.p_memsz);
        if (!id.empty()) { return id; }
    }
    return "";
}

int add_library(dl_phdr_info* object, std::size_t /*size*/, void* libraries) {
    const std::string name = std::filesystem::path(object->dlpi_name).filename().string();
    if (is_numerical(name)) { static_cast<Libraries*>(libraries)->emplace_back(name, build_id_of(*object)); }
    return 0;
}

}  // namespace

Libraries numerical_libraries() {
    Libraries libraries;
    dl_iterate_phdr(add_library, &libraries);
    std::sort(libraries.begin(), libraries.end());
    return libraries;
}

#ifdef __x86_64__
std::string instruction_level() {
    const bool second = CPU_FEATURE_ACTIVE(SSE3) && CPU_FEATURE_ACTIVE(SSSE3) && CPU_FEATURE_ACTIVE(SSE4_1) &&
                        CPU_FEATURE_ACTIVE(SSE4_2) && CPU_FEATURE_ACTIVE(POPCNT);
    const bool third = second && CPU_FEATURE_ACTIVE(AVX) && CPU_FEATURE_ACTIVE(AVX2) && CPU_FEATURE_ACTIVE(FMA) &&
                       CPU_FEATURE_ACTIVE(BMI1) && CPU_FEATURE_ACTIVE(BMI2);
    const bool fourth = third && CPU_FEATURE_ACTIVE(AVX512F) && CPU_FEATURE_ACTIVE(AVX512BW) &&
                        CPU_FEATURE_ACTIVE(AVX512CD) && CPU_FEATURE_ACTIVE(AVX512DQ) && CPU_FEATURE_ACTIVE(AVX512VL);
    // libm does not choose by the level only.
    std::string level = fourth ? "x86-64-v4" : third ? "x86-64-v3" : second ? "x86-64-v2" : "x86-64";
    if (!third && CPU_FEATURE_ACTIVE(AVX)) { level += "+avx"; }
    if (!third && CPU_FEATURE_ACTIVE(AVX2)) { level += "+avx2"; }
    if (!third && CPU_FEATURE_ACTIVE(FMA)) { level += "+fma"; }
    if (CPU_FEATURE_ACTIVE(FMA4)) { level += "+fma4"; }
    return level;
}
#else
std::string instruction_level() {
    utsname machine{};
    return uname(&machine) == 0 ? machine.machine : "";
}
#endif

}  // namespace kreisel
