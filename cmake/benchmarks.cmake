find_package(benchmark REQUIRED)
add_executable(bench_steps ${CMAKE_SOURCE_DIR}/benchmarks/steps.cpp)
target_link_libraries(bench_steps PRIVATE kreisel_binary64 benchmark::benchmark)

include(cmake/simbody.cmake)  # a peer
add_executable(bench_chain ${CMAKE_SOURCE_DIR}/benchmarks/chain.cpp)
target_link_libraries(bench_chain PRIVATE kreisel_binary64 kreisel_simbody benchmark::benchmark)
