# Instruction set and warnings, for every target: -march and NDEBUG change Eigen's alignment, so they must not differ
# between translation units.
include(CheckCXXSourceRuns)

if(KREISEL_ARCH STREQUAL "auto")
  set(CMAKE_REQUIRED_FLAGS "-march=x86-64-v3")
  check_cxx_source_runs("
    int main() {
      __builtin_cpu_init();
      return __builtin_cpu_supports(\"avx2\") && __builtin_cpu_supports(\"fma\") && __builtin_cpu_supports(\"bmi2\") ? 0 : 1;
    }" KREISEL_HAS_X86_64_V3)
  unset(CMAKE_REQUIRED_FLAGS)
  if(KREISEL_HAS_X86_64_V3)
    add_compile_options(-march=x86-64-v3)
  endif()
elseif(KREISEL_ARCH STREQUAL "native")
  add_compile_options(-march=native)
elseif(NOT KREISEL_ARCH STREQUAL "generic")
  message(FATAL_ERROR "KREISEL_ARCH is auto, generic or native, not ${KREISEL_ARCH}")
endif()

add_compile_options(-Wall -Wextra -Wpedantic -Wshadow -Wconversion -Wsign-conversion -Wold-style-cast -Wnon-virtual-dtor
                    -Woverloaded-virtual -Wcast-align -Wnull-dereference $<$<BOOL:${KREISEL_WERROR}>:-Werror>)
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
  # False alarms of GCC 12 inside inlined standard and Eigen templates; designated initialisers leave defaults on purpose.
  add_compile_options(-Wno-null-dereference -Wno-maybe-uninitialized -Wno-missing-field-initializers -Wno-array-bounds
                      -Wno-stringop-overflow -Wno-stringop-overread -Wno-restrict)
elseif(CMAKE_CXX_COMPILER_ID STREQUAL "Clang")
  # `GCC ivdep`; designated initialisers leave defaults on purpose.
  add_compile_options(-Wno-unknown-pragmas -Wno-missing-field-initializers)
endif()

if(KREISEL_SANITIZE)
  add_compile_options(-fsanitize=address,undefined -fno-sanitize-recover=all -fno-omit-frame-pointer)
  add_link_options(-fsanitize=address,undefined)
endif()

if(KREISEL_FUZZ)
  add_compile_options(-fsanitize=fuzzer-no-link,address,undefined -fno-sanitize-recover=all)
  add_link_options(-fsanitize=address,undefined)
endif()
