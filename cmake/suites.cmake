# One Catch2 program per folder of tests and precision. A new test file is found by the glob.
include(CTest)
set(KREISEL_TEST_TIMEOUT 1500 CACHE STRING "seconds that one suite may take; counting branches makes them slower")
find_package(Catch2 2.13 REQUIRED)
add_library(kreisel_test_main OBJECT ${CMAKE_SOURCE_DIR}/tests/support/main.cpp)
target_link_libraries(kreisel_test_main PUBLIC Catch2::Catch2)
kreisel_compile_hastily(kreisel_test_main)

# rapidcheck's headers are heavy: one translation unit includes them, and no suite does.
find_package(rapidcheck REQUIRED)
add_library(kreisel_rapid OBJECT ${CMAKE_SOURCE_DIR}/tests/support/rapid.cpp)
target_include_directories(kreisel_rapid PRIVATE ${CMAKE_SOURCE_DIR})
target_link_libraries(kreisel_rapid PUBLIC rapidcheck)

# Folders of a suite below tests/, where they are not the one of its name.
set(KREISEL_FOLDERS_campaign campaign campaign/mechanisms)
set(KREISEL_FOLDERS_driver driver driver/cli driver/config driver/diff driver/harm driver/plan driver/workers fuzz)
set(KREISEL_FOLDERS_methods methods methods/control methods/families methods/implicit methods/steps)
set(KREISEL_FOLDERS_metamorphic metamorphic metamorphic/descriptions metamorphic/models)
set(KREISEL_FOLDERS_orders orders judges/families judges/steps judges/steps/multistep judges/steps/splitting)
set(KREISEL_FOLDERS_outside peers/simbody)
set(KREISEL_FOLDERS_peers peers/methods)
set(KREISEL_FOLDERS_problems problems judges/problems)
set(KREISEL_FOLDERS_reference engine engine/joints engine/stability peers)
set(KREISEL_FOLDERS_tables plots plots/figures records)

# kreisel_suite(name variant LIBRARIES ... SOURCES ...): the *.cpp of its folders, and further sources or objects.
function(kreisel_suite suite variant)
  cmake_parse_arguments(PARSE_ARGV 2 arg "" "" "LIBRARIES;SOURCES")
  set(folders ${suite})
  if(KREISEL_FOLDERS_${suite})
    set(folders ${KREISEL_FOLDERS_${suite}})
  endif()
  list(TRANSFORM folders REPLACE "(.+)" "${CMAKE_SOURCE_DIR}/tests/\\1/*.cpp")
  file(GLOB sources CONFIGURE_DEPENDS ${folders})
  if(NOT sources)
    return()
  endif()
  set(target test_${suite}_${variant})
  add_executable(${target} ${sources} ${arg_SOURCES})
  kreisel_unite(${target})
  if(variant STREQUAL "plain")
    kreisel_compile_hastily(${target})
    kreisel_precompile(${target} plain)
  else()
    kreisel_compile_quickly(${target})
    kreisel_precompile(${target} tests_${variant})
  endif()
  target_include_directories(${target} PRIVATE ${CMAKE_SOURCE_DIR} ${CMAKE_BINARY_DIR}/generated)
  # fmt for all: what shares a precompiled header shares its definitions.
  target_link_libraries(${target} PRIVATE kreisel_test_main Catch2::Catch2 fmt::fmt ${arg_LIBRARIES})
  add_test(NAME ${suite}.${variant} COMMAND ${target})
  set_tests_properties(${suite}.${variant} PROPERTIES LABELS ${suite} TIMEOUT ${KREISEL_TEST_TIMEOUT})
endfunction()

# The rules of observed orders and of energy over long times, without the rest of the driver.
file(GLOB fits CONFIGURE_DEPENDS ${CMAKE_SOURCE_DIR}/records/fits/*.cpp)
add_library(kreisel_order OBJECT ${fits})
target_include_directories(kreisel_order PRIVATE ${CMAKE_SOURCE_DIR})
target_link_libraries(kreisel_order PUBLIC fmt::fmt GSL::gsl)

# The methods broken on purpose and the checks, which two suites share.
function(kreisel_controls precision)
  file(GLOB sources CONFIGURE_DEPENDS ${CMAKE_SOURCE_DIR}/tests/controls/*.cpp
       ${CMAKE_SOURCE_DIR}/tests/judges/methods/*.cpp)
  add_library(kreisel_controls_${precision} OBJECT ${sources})
  kreisel_unite(kreisel_controls_${precision})
  kreisel_compile_quickly(kreisel_controls_${precision})
  kreisel_precompile(kreisel_controls_${precision} tests_${precision})
  target_link_libraries(kreisel_controls_${precision} PRIVATE kreisel_flags_${precision} Catch2::Catch2 fmt::fmt GSL::gsl)
endfunction()

# Order conditions in exact arithmetic and 100 digits: neither precision is theirs, so they are compiled once, and their
# tests are part of the suite in double.
file(GLOB conditions CONFIGURE_DEPENDS ${CMAKE_SOURCE_DIR}/tests/judges/conditions/*.cpp
     ${CMAKE_SOURCE_DIR}/tests/judges/conditions/solved/*.cpp)
file(GLOB exact_tests CONFIGURE_DEPENDS ${CMAKE_SOURCE_DIR}/tests/orders/exact/*.cpp)
function(kreisel_conditions)
  add_library(kreisel_conditions OBJECT ${conditions})
  kreisel_unite(kreisel_conditions)
  kreisel_compile_quickly(kreisel_conditions)
  kreisel_precompile(kreisel_conditions tests_binary64)
  target_link_libraries(kreisel_conditions PRIVATE kreisel_flags_binary64 Catch2::Catch2 fmt::fmt GSL::gsl)
  set_target_properties(kreisel_conditions PROPERTIES UNITY_BUILD_CODE_BEFORE_INCLUDE
                                                      "#include <boost/multiprecision/eigen.hpp>")
endfunction()

kreisel_controls(binary64)
kreisel_suite(series binary64 LIBRARIES kreisel_lie_binary64)
kreisel_suite(lie binary64 LIBRARIES kreisel_lie_binary64 kreisel_rapid)
kreisel_suite(mechanics binary64 LIBRARIES kreisel_lie_binary64 kreisel_mechanics_binary64 kreisel_problems_binary64)
kreisel_suite(problems binary64 LIBRARIES kreisel_binary64)
kreisel_suite(methods binary64 LIBRARIES kreisel_binary64 kreisel_controls_binary64 kreisel_order)
kreisel_suite(peers binary64 LIBRARIES kreisel_binary64 kreisel_peers_binary64)
kreisel_suite(architecture plain)
target_link_libraries(test_architecture_plain PRIVATE fmt::fmt)
if(NOT KREISEL_SANITIZE)  # exact rationals compile slowly there
  kreisel_conditions()
  kreisel_suite(orders binary64 LIBRARIES kreisel_binary64 kreisel_controls_binary64 kreisel_order kreisel_conditions
                SOURCES ${exact_tests})
  include(cmake/simbody.cmake)
  kreisel_suite(outside binary64 LIBRARIES kreisel_binary64 kreisel_simbody
                SOURCES ${CMAKE_SOURCE_DIR}/tests/problems/states.cpp)
endif()
if(NOT KREISEL_SANITIZE)  # whose shadow memory is beyond the limits that workers are given
  # These two run nothing, but look up the metrics of the engine.
  kreisel_suite(tables plain LIBRARIES kreisel_driver SOURCES ${KREISEL_OBJECTS_binary64})
  kreisel_suite(driver plain LIBRARIES kreisel_driver SOURCES ${KREISEL_OBJECTS_binary64})
endif()
# How perturbations grow is measured in quad if there is quad, whatever the precision of the suite.
function(kreisel_growth precision)
  add_library(kreisel_growth_${precision} OBJECT ${CMAKE_SOURCE_DIR}/tests/metamorphic/growth/growth.cpp)
  kreisel_compile_quickly(kreisel_growth_${precision})
  target_link_libraries(kreisel_growth_${precision} PRIVATE kreisel_flags_${precision} Catch2::Catch2)
endfunction()
if(NOT KREISEL_BINARY128)
  kreisel_growth(binary64)
  kreisel_suite(metamorphic binary64 LIBRARIES kreisel_binary64 kreisel_growth_binary64)
endif()
if(KREISEL_BINARY128)
  kreisel_growth(binary128)
  kreisel_suite(metamorphic binary128 LIBRARIES kreisel_binary128 kreisel_growth_binary128)
  add_library(kreisel_growth_runs OBJECT ${CMAKE_SOURCE_DIR}/tests/metamorphic/models/motion.cpp
                                         ${CMAKE_SOURCE_DIR}/tests/metamorphic/models/named_models.cpp)
  kreisel_unite(kreisel_growth_runs)
  kreisel_compile_quickly(kreisel_growth_runs)
  kreisel_precompile(kreisel_growth_runs tests_binary128)
  target_link_libraries(kreisel_growth_runs PRIVATE kreisel_flags_binary128 Catch2::Catch2 fmt::fmt)
  kreisel_suite(metamorphic binary64 LIBRARIES kreisel_binary64 kreisel_growth_binary128 kreisel_growth_runs quadmath
                SOURCES ${KREISEL_OBJECTS_binary128})
  kreisel_suite(series binary128 LIBRARIES kreisel_lie_binary128)
  kreisel_suite(lie binary128 LIBRARIES kreisel_lie_binary128 kreisel_rapid)
  kreisel_suite(mechanics binary128 LIBRARIES kreisel_lie_binary128 kreisel_mechanics_binary128 kreisel_problems_binary128)
  kreisel_suite(problems binary128 LIBRARIES kreisel_binary128)
  kreisel_controls(binary128)
  kreisel_suite(methods binary128 LIBRARIES kreisel_binary128 kreisel_controls_binary128 kreisel_order)
  kreisel_suite(orders binary128 LIBRARIES kreisel_binary128 kreisel_controls_binary128 kreisel_order
                SOURCES $<TARGET_OBJECTS:kreisel_conditions>)
  find_package(SUNDIALS 6 REQUIRED)  # an independent reference, for tests only
  kreisel_suite(reference binary128 LIBRARIES kreisel_binary128 GSL::gsl SUNDIALS::ida_shared SUNDIALS::nvecserial_shared
                SUNDIALS::sunmatrixdense_shared SUNDIALS::sunlinsoldense_shared)
  kreisel_suite(campaign plain LIBRARIES kreisel_driver quadmath
                SOURCES ${KREISEL_OBJECTS_binary64} ${KREISEL_OBJECTS_binary128})
  foreach(precision binary64 binary128)
    add_library(kreisel_values_${precision} OBJECT ${CMAKE_SOURCE_DIR}/tests/precisions/values/values.cpp)
    target_link_libraries(kreisel_values_${precision} PRIVATE kreisel_lie_${precision})
  endforeach()
  kreisel_suite(precisions plain LIBRARIES quadmath
                SOURCES $<TARGET_OBJECTS:kreisel_values_binary64> $<TARGET_OBJECTS:kreisel_values_binary128>
                        $<TARGET_OBJECTS:kreisel_lie_binary64> $<TARGET_OBJECTS:kreisel_lie_binary128>)
  add_test(NAME architecture.symbols
           COMMAND ${CMAKE_SOURCE_DIR}/tests/architecture/symbols.sh ${KREISEL_OBJECTS_binary64}
                   ${KREISEL_PEER_OBJECTS_binary64} -- ${KREISEL_OBJECTS_binary128} ${KREISEL_PEER_OBJECTS_binary128}
           COMMAND_EXPAND_LISTS)
  set_tests_properties(architecture.symbols PROPERTIES LABELS architecture ENVIRONMENT "CXX=${CMAKE_CXX_COMPILER}")
endif()

# Every combination takes about twenty minutes, so it runs only on request: ctest --preset ci -C full -L full
foreach(precision binary64 binary128)
  if(TARGET test_metamorphic_${precision})
    add_test(NAME metamorphic.full.${precision} CONFIGURATIONS full COMMAND test_metamorphic_${precision} "[full]")
    set_tests_properties(metamorphic.full.${precision} PROPERTIES LABELS full TIMEOUT 28800)
  endif()
endforeach()

# The other precision, in a suite of this one.
set_source_files_properties(${CMAKE_SOURCE_DIR}/tests/engine/closed_form_double.cpp PROPERTIES
                            SKIP_UNITY_BUILD_INCLUSION ON SKIP_PRECOMPILE_HEADERS ON)

# Boost's support of Eigen must come before the first use of a matrix of its numbers.
foreach(target test_orders_binary64 test_orders_binary128)
  if(TARGET ${target})
    set_target_properties(${target} PROPERTIES UNITY_BUILD_CODE_BEFORE_INCLUDE "#include <boost/multiprecision/eigen.hpp>")
  endif()
endforeach()

# One layout of all sources. Where clang-format is missing the other tests still run.
find_program(KREISEL_CLANG_FORMAT clang-format-14)
if(KREISEL_CLANG_FORMAT)
  add_test(NAME architecture.format COMMAND ${CMAKE_SOURCE_DIR}/tools/format -c)
  set_tests_properties(architecture.format PROPERTIES LABELS architecture)
endif()

# Report pages in a browser. Where there is none the test says so and is skipped, unless KREISEL_REQUIRE has `browser`.
if(KREISEL_BINARY128)
  add_test(NAME browser.report COMMAND /usr/bin/python3 ${CMAKE_SOURCE_DIR}/tests/browser/report.py $<TARGET_FILE:kreisel>)
  set_tests_properties(browser.report PROPERTIES LABELS browser SKIP_RETURN_CODE 77 TIMEOUT 600)
endif()

# The Python package, and its notebook. Skipped by name where a library is missing, unless KREISEL_REQUIRE has `python`.
if(KREISEL_BINARY128)
  foreach(part "package:[!n]*" "notebook:notebook")
    string(REPLACE ":" ";" part ${part})
    list(GET part 0 name)
    list(GET part 1 files)
    add_test(NAME python.${name}
             COMMAND /usr/bin/python3 ${CMAKE_SOURCE_DIR}/tests/python/run.py $<TARGET_FILE:kreisel> ${files})
    set_tests_properties(python.${name} PROPERTIES LABELS python SKIP_RETURN_CODE 77 TIMEOUT 600)
  endforeach()
endif()

# `kreisel slurm` on a real Slurm, which the test starts and stops. Skipped by name where there is none, unless
# KREISEL_REQUIRE has `cluster`.
if(KREISEL_BINARY128)
  add_test(NAME cluster.slurm COMMAND /usr/bin/python3 ${CMAKE_SOURCE_DIR}/tests/cluster/run.py $<TARGET_FILE:kreisel>)
  set_tests_properties(cluster.slurm PROPERTIES LABELS cluster SKIP_RETURN_CODE 77 TIMEOUT 600)
endif()

# What `kreisel new` writes compiles as the objects beside it do, and runs.
if(KREISEL_BINARY128)
  add_test(NAME scaffolds.new COMMAND /usr/bin/python3 ${CMAKE_SOURCE_DIR}/tests/scaffolds/run.py $<TARGET_FILE:kreisel>
                                      ${CMAKE_BINARY_DIR})
  set_tests_properties(scaffolds.new PROPERTIES LABELS scaffolds TIMEOUT 600)
endif()

# Labels come out of every sink as they went in.
if(KREISEL_BINARY128)
  add_test(NAME labels.sinks COMMAND /usr/bin/python3 ${CMAKE_SOURCE_DIR}/tests/labels/run.py $<TARGET_FILE:kreisel>)
  set_tests_properties(labels.sinks PROPERTIES LABELS labels TIMEOUT 600)
endif()

# What is promised (tests/reliability/README.md): a share of the attacks on the program, some of them on one that breaks
# its promises, and the table itself.
if(TARGET kreisel)
  add_test(NAME reliability.attacks
           COMMAND ${CMAKE_SOURCE_DIR}/tools/reliability --share -j 1 -k $<TARGET_FILE:kreisel>)
  add_test(NAME reliability.table
           COMMAND /usr/bin/python3 ${CMAKE_SOURCE_DIR}/tests/reliability/test_table.py ${CMAKE_BINARY_DIR})
  add_test(NAME reliability.controls
           COMMAND /usr/bin/python3 ${CMAKE_SOURCE_DIR}/tests/reliability/test_attacks.py $<TARGET_FILE:kreisel>
                   R1 R4 R6 R26)
  set_tests_properties(reliability.attacks reliability.controls reliability.table
                       PROPERTIES LABELS reliability TIMEOUT 600)
endif()

include(cmake/docs.cmake)

# The table of controls that ./check writes at its end, which runs every check on every control.
if(TARGET test_orders_binary64)
  add_test(NAME orders.controls COMMAND test_orders_binary64 "[list]")
  set_tests_properties(orders.controls PROPERTIES LABELS orders)
endif()

# Instructions per step of the literature's top: explicit steps of 1/20,000 s, implicit ones of 1/1000 s down to
# round-off. The last one is a control: no step takes a single instruction. Counts are of this instruction set.
find_program(KREISEL_VALGRIND valgrind)
if(KREISEL_VALGRIND AND KREISEL_HAS_X86_64_V3 AND KREISEL_BINARY128 AND CMAKE_BUILD_TYPE STREQUAL "Release")
  foreach(gate "rkmk/rk4:20000:2200" "rkmk/implicit_midpoint:1000:6500" "generalized_alpha/index2:1000:15000"
               "multistep/bliedf2:1000:18000" "rkmk/rk4:1000:1")
    string(REPLACE ":" ";" gate ${gate})
    list(GET gate 0 method)
    list(GET gate 1 rate)
    list(GET gate 2 most)
    string(REPLACE "/" "." name "instructions.${method}.${most}")
    add_test(NAME ${name} COMMAND ${CMAKE_SOURCE_DIR}/tools/count-instructions -k $<TARGET_FILE:kreisel> -r ${rate} -n 200
                                  -m ${most} heavy_top SO3xR3 ${method})
    set_tests_properties(${name} PROPERTIES LABELS instructions TIMEOUT 600)
  endforeach()
  set_tests_properties(instructions.rkmk.rk4.1 PROPERTIES WILL_FAIL ON)
endif()

# Mutants of each kind, so that the tools that make them stay alive. They reuse the objects of this build.
if(CMAKE_BUILD_TYPE STREQUAL "Release" AND CMAKE_GENERATOR STREQUAL "Ninja")
  foreach(sample "series:lie/small_angle.hpp:40" "tableaus:methods/:1")
    string(REPLACE ":" ";" sample ${sample})
    list(GET sample 0 name)
    list(GET sample 1 files)
    list(GET sample 2 count)
    add_test(NAME mutation.${name} COMMAND ${CMAKE_SOURCE_DIR}/tools/mutate-coefficients --again --jobs 1 --sample ${count}
                                           --only ${files} --build ${CMAKE_BINARY_DIR})
    set_tests_properties(mutation.${name} PROPERTIES LABELS mutation RESOURCE_LOCK mutation TIMEOUT 900)
  endforeach()
endif()

# The longest first, so that none is left alone at the end: seconds, as ctest remembers them of earlier runs.
foreach(long methods.binary128:380 campaign.plain:200 metamorphic.binary128:130 reference.binary128:100
        mutation.tableaus:35 reliability.attacks:60 metamorphic.binary64:60 cluster.slurm:90)
  string(REPLACE ":" ";" long ${long})
  list(GET long 0 name)
  list(GET long 1 cost)
  if(TEST ${name})
    set_tests_properties(${name} PROPERTIES COST ${cost})
  endif()
endforeach()
