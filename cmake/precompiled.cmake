# Precompiled headers: most of the time of a cold build goes into reading the same few. One for each set of compile
# flags; the first target of a set makes it, the others take it.
set(KREISEL_HEADERS_numerics ${CMAKE_SOURCE_DIR}/lie/linear.hpp <Eigen/Cholesky> <Eigen/LU> <Eigen/QR> <functional>
    <map> <memory> <optional> <sstream> <variant> <vector>)
# Boost's support of Eigen must come before the first use of a matrix of its numbers.
set(KREISEL_HEADERS_tests <boost/multiprecision/eigen.hpp> ${KREISEL_HEADERS_numerics} <catch2/catch.hpp> <fmt/format.h>
    <random>)
set(KREISEL_HEADERS_driver <nlohmann/json.hpp> <fmt/format.h> <algorithm> <filesystem> <fstream> <functional> <map>
    <optional> <sstream> <string> <vector>)
set(KREISEL_HEADERS_plain ${KREISEL_HEADERS_driver} <catch2/catch.hpp> <regex>)

# kreisel_precompile(target set): set is KIND or KIND_PRECISION, KIND one of those above.
function(kreisel_precompile target set)
  if(NOT KREISEL_PCH)
    return()
  endif()
  get_property(first GLOBAL PROPERTY kreisel_precompiled_${set})
  if(first)
    target_precompile_headers(${target} REUSE_FROM ${first})
    return()
  endif()
  string(REGEX REPLACE "_.*" "" kind ${set})
  target_precompile_headers(${target} PRIVATE ${KREISEL_HEADERS_${kind}})
  set_property(GLOBAL PROPERTY kreisel_precompiled_${set} ${target})
endfunction()
