# Integrators of other libraries behind the interface of methods, as baselines. The program and the suite `peers` link
# them, nothing else does: what links GSL may be passed on under GPL-3.0-or-later only. They register like methods, so
# objects again. They compute in double, and in quad only say so.
#
# kreisel_peers_<precision>         their objects and libraries
# KREISEL_PEER_OBJECTS_<precision>  only the objects
# KREISEL_PEER_LIBRARIES            the libraries of both
option(KREISEL_GSL_BASELINES "baselines of GSL, GPL-3.0-or-later" ON)
option(KREISEL_SUNDIALS "baselines of SUNDIALS, where it is found" ON)

set(KREISEL_PEERS odeint)
set(KREISEL_PEER_LIBRARIES "")
if(KREISEL_GSL_BASELINES)
  list(APPEND KREISEL_PEERS gsl)
  list(APPEND KREISEL_PEER_LIBRARIES GSL::gsl)
endif()
if(KREISEL_SUNDIALS)
  find_package(SUNDIALS 6 QUIET)
  if(SUNDIALS_FOUND)
    list(APPEND KREISEL_PEERS sundials)
    # Those that use others first.
    foreach(part cvode arkode ida sunnonlinsolfixedpoint sunlinsoldense sunmatrixdense nvecserial)
      if(KREISEL_STATIC)  # the package's static targets link a shared one
        find_library(KREISEL_SUNDIALS_${part} sundials_${part} REQUIRED)
        list(APPEND KREISEL_PEER_LIBRARIES ${KREISEL_SUNDIALS_${part}})
      else()
        list(APPEND KREISEL_PEER_LIBRARIES SUNDIALS::${part}_shared)
      endif()
    endforeach()
  else()
    message(STATUS "SUNDIALS 6 is not found: no baselines of it")
  endif()
endif()

function(kreisel_peers precision)
  add_library(kreisel_peers_${precision} INTERFACE)
  target_link_libraries(kreisel_peers_${precision} INTERFACE ${KREISEL_PEER_LIBRARIES})
  set(objects "")
  foreach(library shared ${KREISEL_PEERS})
    set(folder ${CMAKE_SOURCE_DIR}/peers/${library})
    if(library STREQUAL "shared")
      set(folder ${CMAKE_SOURCE_DIR}/peers)
    endif()
    file(GLOB sources CONFIGURE_DEPENDS ${folder}/*.cpp)
    set(target kreisel_peers_${library}_${precision})
    add_library(${target} OBJECT ${sources})
    target_link_libraries(${target} PRIVATE kreisel_flags_${precision} ${KREISEL_PEER_LIBRARIES})
    kreisel_precompile(${target} numerics_${precision})
    if(precision STREQUAL "binary128")
      kreisel_compile_quickly(${target})
    endif()
    list(APPEND objects $<TARGET_OBJECTS:${target}>)
  endforeach()
  target_sources(kreisel_peers_${precision} INTERFACE ${objects})
  set(KREISEL_PEER_OBJECTS_${precision} ${objects} PARENT_SCOPE)
endfunction()

kreisel_peers(binary64)
if(KREISEL_BINARY128)
  kreisel_peers(binary128)
endif()
