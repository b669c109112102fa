find_package(benchmark REQUIRED)
add_executable(bench_steps ${CMAKE_SOURCE_DIR}/benchmarks/steps.cpp)
target_link_libraries(bench_steps PRIVATE kreisel_binary64 benchmark::benchmark)

include(cmake/simbody.cmake)  # a peer
add_executable(bench_chain ${CMAKE_SOURCE_DIR}/benchmarks/chain.cpp)
target_link_libraries(bench_chain PRIVATE kreisel_binary64 kreisel_simbody benchmark::benchmark)

# Accuracy per cost beside other libraries; it links GSL, so the program is GPL-3.0-or-later. Of kreisel's flags only
# its own file needs any: the others contain nothing of it.
find_package(SUNDIALS 6 REQUIRED)
find_path(KREISEL_MUJOCO_INCLUDE mujoco/mujoco.h)
find_library(KREISEL_MUJOCO_LIBRARY mujoco)
file(GLOB accuracy_sources CONFIGURE_DEPENDS ${CMAKE_SOURCE_DIR}/benchmarks/accuracy/*.cpp)
list(FILTER accuracy_sources EXCLUDE REGEX "/(kreisel|simbody|mujoco)\\.cpp$")
add_library(accuracy_kreisel OBJECT ${CMAKE_SOURCE_DIR}/benchmarks/accuracy/kreisel.cpp)
target_link_libraries(accuracy_kreisel PRIVATE kreisel_flags_binary64)
add_library(accuracy_engines OBJECT ${CMAKE_SOURCE_DIR}/benchmarks/accuracy/simbody.cpp
                                    ${CMAKE_SOURCE_DIR}/benchmarks/accuracy/mujoco.cpp)
set_target_properties(accuracy_engines PROPERTIES CXX_STANDARD 17)  # Simbody's headers, cmake/simbody.cmake
target_include_directories(accuracy_engines PRIVATE ${CMAKE_SOURCE_DIR})
target_include_directories(accuracy_engines SYSTEM PRIVATE ${Simbody_INCLUDE_DIR})
add_executable(bench_accuracy ${accuracy_sources} ${KREISEL_OBJECTS_binary64} $<TARGET_OBJECTS:kreisel_parts>)
set_source_files_properties(${CMAKE_SOURCE_DIR}/benchmarks/accuracy/odeint.cpp PROPERTIES
                            COMPILE_OPTIONS -Wno-uninitialized)
target_include_directories(bench_accuracy PRIVATE ${CMAKE_SOURCE_DIR})
target_link_libraries(bench_accuracy PRIVATE accuracy_kreisel accuracy_engines Eigen3::Eigen Boost::headers GSL::gsl
                      SUNDIALS::ida_shared SUNDIALS::nvecserial_shared SUNDIALS::sunmatrixdense_shared
                      SUNDIALS::sunlinsoldense_shared SimTKsimbody SimTKmath SimTKcommon)
if(KREISEL_MUJOCO_INCLUDE AND KREISEL_MUJOCO_LIBRARY)
  target_compile_definitions(accuracy_engines PRIVATE KREISEL_MUJOCO=1)
  target_include_directories(accuracy_engines SYSTEM PRIVATE ${KREISEL_MUJOCO_INCLUDE})
  target_link_libraries(bench_accuracy PRIVATE ${KREISEL_MUJOCO_LIBRARY})
else()
  message(STATUS "bench_accuracy: without MuJoCo (libmujoco-dev)")
endif()
