# The compiler's own garbage collection costs a tenth of a build; without it a job takes 2.5 GB at most.
set(KREISEL_WITHOUT_COLLECTION "")
cmake_host_system_information(RESULT memory QUERY TOTAL_PHYSICAL_MEMORY)  # MB
cmake_host_system_information(RESULT processors QUERY NUMBER_OF_LOGICAL_CORES)
math(EXPR memory "${memory} / ${processors}")
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU" AND memory GREATER 3000)
  set(KREISEL_WITHOUT_COLLECTION "SHELL:--param ggc-min-heapsize=4000000")  # kB
endif()

# Many files in one translation unit: what most of the time goes into is headers and the templates that all files of a
# folder use. Files compiled together share their unnamed namespaces; a missing #include shows only in a build with
# KREISEL_UNITY=OFF. A step's instructions differ by less than 1 % from those of files compiled alone.
function(kreisel_unite target)
  set_target_properties(${target} PROPERTIES UNITY_BUILD ${KREISEL_UNITY} UNITY_BUILD_MODE BATCH
                                             UNITY_BUILD_BATCH_SIZE 32)
  target_compile_options(${target} PRIVATE ${KREISEL_WITHOUT_COLLECTION})
  if(KREISEL_UNITY AND CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
    # A local name may be a global one of a neighbour.
    target_compile_options(${target} PRIVATE -Wno-shadow -Wshadow=local)
  elseif(KREISEL_UNITY)
    target_compile_options(${target} PRIVATE -Wno-shadow)
  endif()
endfunction()

# For what takes longer to compile than it could gain: the driver, tests, and numerical code in quad, whose time goes into
# the library's arithmetic. In double, numerical code keeps its flags. Small in a program that is to be copied.
function(kreisel_compile_quickly target)
  target_compile_options(${target} PRIVATE $<$<CONFIG:Release>:$<IF:$<BOOL:${KREISEL_STATIC}>,-Os,-O1>>)
endfunction()

# For what loses nothing by it: small in a program that is to be copied.
function(kreisel_compile_small target)
  if(KREISEL_STATIC)
    target_compile_options(${target} PRIVATE $<$<CONFIG:Release>:-Os>)
  endif()
endfunction()

# For what runs briefly: unit tests of the driver, of plots and of records.
function(kreisel_compile_hastily target)
  target_compile_options(${target} PRIVATE $<$<CONFIG:Release>:-Og>)
endfunction()
