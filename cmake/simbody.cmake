# Simbody, which tests and benchmarks compare with. Its headers are C++17 (ambiguous in C++20) and warn: one file sees them,
# as system headers.
include_guard(GLOBAL)
find_package(Simbody 3.7 REQUIRED)
add_library(kreisel_simbody OBJECT ${CMAKE_SOURCE_DIR}/tests/peers/simbody/wrapper/simbody.cpp)
set_target_properties(kreisel_simbody PROPERTIES CXX_STANDARD 17)
target_include_directories(kreisel_simbody SYSTEM PRIVATE ${Simbody_INCLUDE_DIR})
target_link_libraries(kreisel_simbody PRIVATE kreisel_flags_binary64)
target_link_libraries(kreisel_simbody INTERFACE SimTKsimbody SimTKmath SimTKcommon)
