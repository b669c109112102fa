# kreisel_build.hpp, kreisel_flags.cpp and kreisel_commit.cpp: what results record about the program that made them. The
# commit is looked up by every build, not when it is configured.
set(commit_script ${CMAKE_COMMAND} -D SOURCE=${CMAKE_SOURCE_DIR} -D TO=${CMAKE_BINARY_DIR}/generated/kreisel_commit.cpp
                  -P ${CMAKE_SOURCE_DIR}/cmake/commit.cmake)
execute_process(COMMAND ${commit_script} COMMAND_ERROR_IS_FATAL ANY)
add_custom_target(kreisel_commit COMMAND ${commit_script} BYPRODUCTS ${CMAKE_BINARY_DIR}/generated/kreisel_commit.cpp)

# The numerical sources.
file(GLOB_RECURSE KREISEL_NUMERICAL_SOURCES CONFIGURE_DEPENDS
     ${CMAKE_SOURCE_DIR}/lie/*.?pp ${CMAKE_SOURCE_DIR}/mechanics/*.?pp ${CMAKE_SOURCE_DIR}/problems/*.?pp
     ${CMAKE_SOURCE_DIR}/methods/*.?pp ${CMAKE_SOURCE_DIR}/engine/*.?pp)
list(SORT KREISEL_NUMERICAL_SOURCES)

# The sources that affect a reference solution: not the methods, nor the code that follows their runs. A reference stays
# valid when a method is added; a new metric makes it stale, since it holds the uncertainty of each. Left out
# with methods/: engine.hpp, which describes cells and results; run, pace, step_times, sampler, skip, structure and
# observers, which follow a method and take no part in a reference; scheme_rows, linearised, stability, geometry.
set(KREISEL_REFERENCE_SOURCES ${KREISEL_NUMERICAL_SOURCES})
set(followers "(engine|run|pace|step_times|sampler|skip|scheme_rows|geometry|report/geometry)[.]")
string(APPEND followers "|structure|observers/|linearised/|stability/")
list(FILTER KREISEL_REFERENCE_SOURCES EXCLUDE REGEX "^${CMAKE_SOURCE_DIR}/(methods/|engine/(${followers}))")
set(KREISEL_DIGESTS "")
foreach(source IN LISTS KREISEL_REFERENCE_SOURCES)
  file(SHA256 ${source} digest)
  string(APPEND KREISEL_DIGESTS ${digest})
endforeach()
set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${KREISEL_REFERENCE_SOURCES})
# SOURCES-BUILD: programs of the same sources may give each other references.
string(SHA256 sources "${KREISEL_DIGESTS}")
string(SHA256 build
       "${KREISEL_DIGESTS}${CMAKE_CXX_COMPILER_ID}${CMAKE_CXX_COMPILER_VERSION}${CMAKE_CXX_FLAGS}${KREISEL_OPTIMISE}${CMAKE_BUILD_TYPE}${KREISEL_ARCH}${KREISEL_HAS_X86_64_V3}${Boost_VERSION_STRING}${Eigen3_VERSION}")
string(SUBSTRING ${sources} 0 16 sources)
string(SUBSTRING ${build} 0 16 build)
set(KREISEL_REFERENCE_DIGEST ${sources}-${build})
set_property(SOURCE ${CMAKE_SOURCE_DIR}/engine/engine.cpp APPEND
             PROPERTY COMPILE_DEFINITIONS KREISEL_REFERENCE_DIGEST="${KREISEL_REFERENCE_DIGEST}")

get_directory_property(KREISEL_COMPILE_OPTIONS COMPILE_OPTIONS)
string(TOUPPER "${CMAKE_BUILD_TYPE}" build_type)
set(KREISEL_HAS_BINARY128 false)
if(KREISEL_BINARY128)
  set(KREISEL_HAS_BINARY128 true)
endif()
string(JOIN " " KREISEL_FLAGS ${CMAKE_CXX_FLAGS} ${CMAKE_CXX_FLAGS_${build_type}} ${KREISEL_COMPILE_OPTIONS}
       ${KREISEL_OPTIMISE})
configure_file(${CMAKE_SOURCE_DIR}/cmake/kreisel_build.hpp.in ${CMAKE_BINARY_DIR}/generated/kreisel_build.hpp @ONLY)
configure_file(${CMAKE_SOURCE_DIR}/cmake/kreisel_flags.cpp.in ${CMAKE_BINARY_DIR}/generated/kreisel_flags.cpp @ONLY)
