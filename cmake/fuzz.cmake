# libFuzzer on what reads files, a program for each reader of tests/fuzz: `tools/reliability R21` configures, builds and
# runs them. Nothing numerical is built for them.
if(NOT CMAKE_CXX_COMPILER_ID STREQUAL "Clang")
  message(FATAL_ERROR "KREISEL_FUZZ needs clang (-D CMAKE_CXX_COMPILER=clang++-14), not ${CMAKE_CXX_COMPILER_ID}")
endif()
add_library(kreisel_readers OBJECT ${CMAKE_SOURCE_DIR}/tests/fuzz/readers.cpp
                                   ${CMAKE_SOURCE_DIR}/tests/driver/fake_engine.cpp)
kreisel_compile_quickly(kreisel_readers)
target_link_libraries(kreisel_readers PUBLIC kreisel_driver)
foreach(reader config mechanism robot journal reference manifest table)
  add_executable(fuzz_${reader} ${CMAKE_SOURCE_DIR}/tests/fuzz/libfuzzer/fuzz.cpp)
  kreisel_compile_quickly(fuzz_${reader})
  target_compile_definitions(fuzz_${reader} PRIVATE KREISEL_FUZZED="${reader}")
  target_link_libraries(fuzz_${reader} PRIVATE kreisel_readers kreisel_driver)
  target_link_options(fuzz_${reader} PRIVATE -fsanitize=fuzzer)
  list(APPEND fuzzers fuzz_${reader})
endforeach()
add_custom_target(fuzzers DEPENDS ${fuzzers})
