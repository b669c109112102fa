# The numerical code, compiled once per precision. OBJECT libraries: a static library would drop the objects that only
# register a method or a problem, and with them every method. The globs find a new file without any list.
#
# kreisel_flags_<precision>    the compile options of numerical code, its tests included
# kreisel_<layer>_<precision>  the objects of one folder
# kreisel_<precision>          all of them
# KREISEL_OBJECTS_<precision>  only the objects, for targets of neither precision
# kreisel_parts                those of neither precision, part of kreisel_<precision> and of kreisel_driver
#                              (mechanics/parts, methods/conditions)

# clang has no quadmath.h; that of gcc serves.
if(KREISEL_BINARY128 AND CMAKE_CXX_COMPILER_ID STREQUAL "Clang")
  file(GLOB quadmath_folders /usr/lib/gcc/${CMAKE_CXX_LIBRARY_ARCHITECTURE}/*/include)
  find_path(KREISEL_QUADMATH_INCLUDE quadmath.h PATHS ${quadmath_folders} NO_DEFAULT_PATH REQUIRED)
endif()

function(kreisel_flags precision)
  set(target kreisel_flags_${precision})
  add_library(${target} INTERFACE)
  target_include_directories(${target} INTERFACE ${CMAKE_SOURCE_DIR})
  target_link_libraries(${target} INTERFACE Eigen3::Eigen Boost::headers)
  # The vectors of this code have three entries: packets of two cost more in shuffles than they save (3 % of a step).
  # Long loops are still vectorised. Both settings reach the tests too: the first changes Eigen's alignment.
  target_compile_definitions(${target} INTERFACE KREISEL_PRECISION=${precision} EIGEN_DONT_VECTORIZE)
  target_compile_options(${target} INTERFACE -fno-tree-slp-vectorize)
  target_compile_options(${target} INTERFACE ${KREISEL_OPTIMISE})
  if(precision STREQUAL "binary128")
    target_compile_definitions(${target} INTERFACE KREISEL_QUAD=1)
    target_link_libraries(${target} INTERFACE quadmath)
    if(KREISEL_QUADMATH_INCLUDE)  # after clang's own headers, which stand there too
      target_compile_options(${target} INTERFACE SHELL:-idirafter\ ${KREISEL_QUADMATH_INCLUDE})
    endif()
  else()
    target_compile_definitions(${target} INTERFACE KREISEL_QUAD=0)
  endif()
endfunction()

# What joints are made of: plain data, the same in both precisions, which the driver reads too. Objects again, since its
# files only register. And the order conditions, in arithmetic of their own.
file(GLOB parts_sources CONFIGURE_DEPENDS ${CMAKE_SOURCE_DIR}/mechanics/parts/*.cpp
     ${CMAKE_SOURCE_DIR}/mechanics/parts/*/*.cpp ${CMAKE_SOURCE_DIR}/methods/conditions/*.cpp)
add_library(kreisel_parts OBJECT ${parts_sources})
kreisel_unite(kreisel_parts)
kreisel_compile_small(kreisel_parts)
target_include_directories(kreisel_parts PRIVATE ${CMAKE_SOURCE_DIR})

# The objects of some sources of a layer; the first argument after the precision names them.
macro(kreisel_objects precision name)
  add_library(kreisel_${name}_${precision} OBJECT ${ARGN})
  target_link_libraries(kreisel_${name}_${precision} PUBLIC kreisel_flags_${precision})
  # At -Os methods take a fifth more instructions in double, the rest none.
  if(KREISEL_STATIC AND "${precision}" STREQUAL "binary64" AND NOT "${name}" MATCHES "^(lie|methods)$")
    kreisel_compile_small(kreisel_${name}_${precision})
    kreisel_precompile(kreisel_${name}_${precision} numerics_${precision}_small)
  else()
    kreisel_precompile(kreisel_${name}_${precision} numerics_${precision})
  endif()
  target_sources(kreisel_${precision} INTERFACE $<TARGET_OBJECTS:kreisel_${name}_${precision}>)
  list(APPEND KREISEL_OBJECTS_${precision} $<TARGET_OBJECTS:kreisel_${name}_${precision}>)
endmacro()

function(kreisel_layer precision layer)
  file(GLOB sources CONFIGURE_DEPENDS ${ARGN})
  kreisel_objects(${precision} ${layer} ${sources})
  kreisel_unite(kreisel_${layer}_${precision})
  if(precision STREQUAL "binary128")
    kreisel_compile_quickly(kreisel_${layer}_${precision})
  endif()
  # Alone: closed forms, whose local names are those of the theory.
  list(FILTER sources INCLUDE REGEX "_closed_form.cpp$")
  set_source_files_properties(${sources} PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON)
  set(KREISEL_OBJECTS_${precision} ${KREISEL_OBJECTS_${precision}} PARENT_SCOPE)
endfunction()

macro(kreisel_numerics precision)
  kreisel_flags(${precision})
  add_library(kreisel_${precision} INTERFACE)
  target_link_libraries(kreisel_${precision} INTERFACE kreisel_flags_${precision})
  set(KREISEL_OBJECTS_${precision} "")
  kreisel_layer(${precision} lie ${CMAKE_SOURCE_DIR}/lie/*.cpp)
  file(GLOB mechanics_sources CONFIGURE_DEPENDS ${CMAKE_SOURCE_DIR}/mechanics/*.cpp
       ${CMAKE_SOURCE_DIR}/mechanics/*/*.cpp)
  list(FILTER mechanics_sources EXCLUDE REGEX "/mechanics/(parts|formulations)/")
  kreisel_layer(${precision} mechanics ${mechanics_sources})
  # Together: they instantiate the same templates.
  kreisel_layer(${precision} formulations ${CMAKE_SOURCE_DIR}/mechanics/formulations/*.cpp)
  target_sources(kreisel_mechanics_${precision} INTERFACE $<TARGET_OBJECTS:kreisel_formulations_${precision}>
                                                          $<TARGET_OBJECTS:kreisel_parts>)
  target_sources(kreisel_${precision} INTERFACE $<TARGET_OBJECTS:kreisel_parts>)
  kreisel_layer(${precision} problems ${CMAKE_SOURCE_DIR}/problems/*.cpp ${CMAKE_SOURCE_DIR}/problems/*/*.cpp)
  file(GLOB_RECURSE methods_sources CONFIGURE_DEPENDS ${CMAKE_SOURCE_DIR}/methods/*.cpp)
  list(FILTER methods_sources EXCLUDE REGEX "/methods/conditions/")
  kreisel_layer(${precision} methods ${methods_sources})
  kreisel_layer(${precision} engine ${CMAKE_SOURCE_DIR}/engine/*.cpp ${CMAKE_SOURCE_DIR}/engine/*/*.cpp
                ${CMAKE_SOURCE_DIR}/engine/*/*/*.cpp ${CMAKE_SOURCE_DIR}/engine/*/*/*/*.cpp)
endmacro()
