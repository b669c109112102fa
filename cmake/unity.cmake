# Several files in one translation unit. Files compiled together share their unnamed namespaces; a missing #include
# shows only in a build with KREISEL_UNITY=OFF. Of the numerical code only what is data (kreisel_unite_data):
# measurements must not depend on a file's neighbours.
function(kreisel_unite target)
  set_target_properties(${target} PROPERTIES UNITY_BUILD ${KREISEL_UNITY} UNITY_BUILD_MODE BATCH
                                             UNITY_BUILD_BATCH_SIZE 8)
  if(KREISEL_UNITY AND CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
    # A local name may be a global one of a neighbour.
    target_compile_options(${target} PRIVATE -Wno-shadow -Wshadow=local)
  endif()
endfunction()

# Problems, and methods that are no more than a tableau: files without an unnamed namespace.
function(kreisel_unite_data target layer)
  if(NOT layer MATCHES "^(problems|methods)$")
    return()
  endif()
  kreisel_unite(${target})
  get_target_property(sources ${target} SOURCES)
  foreach(source IN LISTS sources)
    file(STRINGS ${source} local_names REGEX "^namespace {")
    if(source MATCHES "_closed_form.cpp$" OR (layer STREQUAL "methods" AND local_names))
      set_source_files_properties(${source} PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON)
    endif()
  endforeach()
endfunction()

# The driver and tests take much longer to compile than to run; the numerical code they run keeps its flags.
function(kreisel_compile_quickly target)
  target_compile_options(${target} PRIVATE $<$<CONFIG:Release>:-O1>)
endfunction()
