# Several files in one translation unit. Files compiled together share their unnamed namespaces; a missing #include
# shows only in a build with KREISEL_UNITY=OFF. Of the numerical code in double only what is data: measurements must not
# depend on a file's neighbours. Quad is not measured, and its arithmetic, calls of functions, is the same however files
# are compiled.
function(kreisel_unite target)
  set_target_properties(${target} PROPERTIES UNITY_BUILD ${KREISEL_UNITY} UNITY_BUILD_MODE BATCH
                                             UNITY_BUILD_BATCH_SIZE 8)
  if(KREISEL_UNITY AND CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
    # A local name may be a global one of a neighbour.
    target_compile_options(${target} PRIVATE -Wno-shadow -Wshadow=local)
  endif()
endfunction()

# Those of `sources` that are data, in double: problems, and methods that are no more than a tableau, which are files
# without an unnamed namespace.
function(kreisel_data_sources result layer)
  set(data "")
  foreach(source IN LISTS ARGN)
    file(STRINGS ${source} local_names REGEX "^namespace {")
    if((layer STREQUAL "problems" AND NOT source MATCHES "_closed_form.cpp$") OR
       (layer STREQUAL "methods" AND NOT local_names))
      list(APPEND data ${source})
    endif()
  endforeach()
  set(${result} ${data} PARENT_SCOPE)
endfunction()

# The driver and tests take much longer to compile than to run; the numerical code they run keeps its flags.
function(kreisel_compile_quickly target)
  target_compile_options(${target} PRIVATE $<$<CONFIG:Release>:-O1>)
endfunction()
