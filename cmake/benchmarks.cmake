find_package(benchmark REQUIRED)
add_executable(bench_steps ${CMAKE_SOURCE_DIR}/benchmarks/steps.cpp)
target_link_libraries(bench_steps PRIVATE kreisel_binary64 benchmark::benchmark)
