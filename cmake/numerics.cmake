# The numerical code, compiled once per precision. OBJECT libraries: a static library would drop the objects that only
# register a method or a problem, and with them every method. The globs make a new file known without any list.
function(kreisel_numerics precision)
  file(GLOB sources CONFIGURE_DEPENDS
       ${CMAKE_SOURCE_DIR}/lie/*.cpp ${CMAKE_SOURCE_DIR}/mechanics/*.cpp ${CMAKE_SOURCE_DIR}/problems/*.cpp
       ${CMAKE_SOURCE_DIR}/methods/*.cpp ${CMAKE_SOURCE_DIR}/methods/*/*.cpp
       ${CMAKE_SOURCE_DIR}/experiments/engine/*.cpp)
  set(target kreisel_${precision})
  add_library(${target} OBJECT ${sources})
  target_include_directories(${target} PUBLIC ${CMAKE_SOURCE_DIR})
  target_link_libraries(${target} PUBLIC Eigen3::Eigen Boost::headers)
  # The vectors of this code have three entries: packets of two cost more in shuffles than they save (3 % of a step).
  # Long loops are still vectorised. Both settings reach the tests too: the first changes Eigen's alignment.
  target_compile_definitions(${target} PUBLIC KREISEL_PRECISION=${precision} EIGEN_DONT_VECTORIZE)
  target_compile_options(${target} PUBLIC -fno-tree-slp-vectorize)
  if(precision STREQUAL "binary128")
    target_compile_definitions(${target} PUBLIC KREISEL_QUAD=1)
    target_link_libraries(${target} PUBLIC quadmath)
  else()
    target_compile_definitions(${target} PUBLIC KREISEL_QUAD=0)
  endif()
endfunction()
