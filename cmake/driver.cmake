# The driver knows no `Real`: it is compiled once and sees the numerical code through engine/engine.hpp.
file(GLOB_RECURSE driver_sources CONFIGURE_DEPENDS ${CMAKE_SOURCE_DIR}/driver/*.cpp ${CMAKE_SOURCE_DIR}/plots/*.cpp
     ${CMAKE_SOURCE_DIR}/records/*.cpp ${CMAKE_SOURCE_DIR}/support/*.cpp)
list(REMOVE_ITEM driver_sources ${CMAKE_SOURCE_DIR}/driver/main.cpp)
add_library(kreisel_driver OBJECT ${driver_sources})
kreisel_unite(kreisel_driver)
kreisel_precompile(kreisel_driver driver)
kreisel_compile_quickly(kreisel_driver)
target_sources(kreisel_driver INTERFACE $<TARGET_OBJECTS:kreisel_parts>)
add_dependencies(kreisel_driver kreisel_commit)
set(build_sources ${CMAKE_BINARY_DIR}/generated/kreisel_commit.cpp ${CMAKE_BINARY_DIR}/generated/kreisel_flags.cpp)
target_sources(kreisel_driver PRIVATE ${build_sources})
set_source_files_properties(${build_sources} PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON SKIP_PRECOMPILE_HEADERS ON)
# The bibliography, which `kreisel cite` prints from.
set(bibliography ${CMAKE_SOURCE_DIR}/paper/references.bib)
set(bibliography_source ${CMAKE_BINARY_DIR}/generated/kreisel_bibliography.cpp)
add_custom_command(OUTPUT ${bibliography_source} DEPENDS ${bibliography} ${CMAKE_SOURCE_DIR}/cmake/bibliography.cmake
                   COMMAND ${CMAKE_COMMAND} -D FROM=${bibliography} -D TO=${bibliography_source}
                           -P ${CMAKE_SOURCE_DIR}/cmake/bibliography.cmake)
target_sources(kreisel_driver PRIVATE ${bibliography_source})
set_source_files_properties(${bibliography_source} PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON SKIP_PRECOMPILE_HEADERS ON)
# Style and script of the page that `kreisel report` writes.
set(page_parts page.css text.js table.js plot.js heat.js space.js figures.js matrix.js scene.js motion.js forces.js
               stage.js camera.js player.js page.js)
list(TRANSFORM page_parts PREPEND ${CMAKE_SOURCE_DIR}/plots/report/web/)
set(page_source ${CMAKE_BINARY_DIR}/generated/kreisel_page.cpp)
add_custom_command(OUTPUT ${page_source} DEPENDS ${page_parts} ${CMAKE_SOURCE_DIR}/cmake/page.cmake
                   COMMAND ${CMAKE_COMMAND} -D "PARTS=${page_parts}" -D TO=${page_source}
                           -P ${CMAKE_SOURCE_DIR}/cmake/page.cmake VERBATIM)
target_sources(kreisel_driver PRIVATE ${page_source})
set_source_files_properties(${page_source} PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON SKIP_PRECOMPILE_HEADERS ON
                                                     COMPILE_OPTIONS -Wno-overlength-strings)  # of a pedantic clang
# The jobs in the script that `kreisel slurm` writes.
set(jobs ${CMAKE_SOURCE_DIR}/driver/cli/slurm/jobs.sh)
set(jobs_source ${CMAKE_BINARY_DIR}/generated/kreisel_slurm_jobs.cpp)
add_custom_command(OUTPUT ${jobs_source} DEPENDS ${jobs} ${CMAKE_SOURCE_DIR}/cmake/embedded.cmake
                   COMMAND ${CMAKE_COMMAND} -D FROM=${jobs} -D TO=${jobs_source} -D NAME=slurm_jobs
                           -P ${CMAKE_SOURCE_DIR}/cmake/embedded.cmake)
target_sources(kreisel_driver PRIVATE ${jobs_source})
set_source_files_properties(${jobs_source} PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON SKIP_PRECOMPILE_HEADERS ON)
# What `kreisel new` starts from.
file(GLOB scaffolds CONFIGURE_DEPENDS ${CMAKE_SOURCE_DIR}/driver/scaffolds/*.in)
set(scaffold_source ${CMAKE_BINARY_DIR}/generated/kreisel_scaffolds.cpp)
add_custom_command(OUTPUT ${scaffold_source} DEPENDS ${scaffolds} ${CMAKE_SOURCE_DIR}/cmake/scaffolds.cmake
                   COMMAND ${CMAKE_COMMAND} -D "FROM=${scaffolds}" -D TO=${scaffold_source}
                           -P ${CMAKE_SOURCE_DIR}/cmake/scaffolds.cmake VERBATIM)
target_sources(kreisel_driver PRIVATE ${scaffold_source})
set_source_files_properties(${scaffold_source} PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON SKIP_PRECOMPILE_HEADERS ON)
target_include_directories(kreisel_driver PUBLIC ${CMAKE_SOURCE_DIR} ${CMAKE_BINARY_DIR}/generated)
target_link_libraries(kreisel_driver PUBLIC nlohmann_json::nlohmann_json ${KREISEL_FMT} CLI11::CLI11 GSL::gsl
                                            Threads::Threads Boost::headers ${KREISEL_NETTLE} ${KREISEL_PUGIXML})

# Objects only, no usage requirements: main.cpp belongs to neither precision.
add_executable(kreisel ${CMAKE_SOURCE_DIR}/driver/main.cpp ${KREISEL_OBJECTS_binary64} ${KREISEL_PEER_OBJECTS_binary64})
target_link_libraries(kreisel PRIVATE kreisel_driver ${KREISEL_PEER_LIBRARIES})
if(KREISEL_BINARY128)
  target_sources(kreisel PRIVATE ${KREISEL_OBJECTS_binary128} ${KREISEL_PEER_OBJECTS_binary128})
  target_link_libraries(kreisel PRIVATE quadmath)
endif()
