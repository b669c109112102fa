# Many files in one translation unit: what most of the time goes into is headers and the templates that all files of a
# folder use. Files compiled together share their unnamed namespaces; a missing #include shows only in a build with
# KREISEL_UNITY=OFF. A step's instructions differ by less than 1 % from those of files compiled alone.
function(kreisel_unite target)
  set_target_properties(${target} PROPERTIES UNITY_BUILD ${KREISEL_UNITY} UNITY_BUILD_MODE BATCH
                                             UNITY_BUILD_BATCH_SIZE 32)
  if(KREISEL_UNITY AND CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
    # A local name may be a global one of a neighbour.
    target_compile_options(${target} PRIVATE -Wno-shadow -Wshadow=local)
  elseif(KREISEL_UNITY)
    target_compile_options(${target} PRIVATE -Wno-shadow)
  endif()
endfunction()

# For what takes longer to compile than it could gain: the driver, tests, and numerical code in quad, whose time goes into
# the library's arithmetic. In double, numerical code keeps its flags.
function(kreisel_compile_quickly target)
  target_compile_options(${target} PRIVATE $<$<CONFIG:Release>:-O1>)
endfunction()
