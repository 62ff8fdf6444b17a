# Everything Hawser stands on. Targets for LIBRARIES in hawser_package and hawser_test:
#   hawser::trilinos (with MPI)   MPI::MPI_CXX        METIS::METIS      MUMPS::DMUMPS (C API)
#   hdf5::parallel (C API)        pugixml::pugixml    fmt::fmt          CLI11::CLI11
#   nlohmann_json::nlohmann_json   PROJ::proj (charts)
#   gmsh::gmsh (GPL: only the mesher, a separate program, may link it)
# Part of the CMake package too: who uses Hawser needs what its headers show, MPI and Trilinos.

find_package(MPI REQUIRED COMPONENTS CXX)
find_package(Trilinos REQUIRED)
if(HAWSER_IMPORTED)
  return()
endif()
find_package(MPI REQUIRED COMPONENTS C)
find_package(pugixml REQUIRED)
find_package(fmt REQUIRED)
find_package(CLI11 REQUIRED)
find_package(nlohmann_json REQUIRED)
find_package(PROJ REQUIRED)
if(HAWSER_TESTS)
  find_package(GTest REQUIRED)
endif()

# One target for all of Trilinos. SYSTEM keeps our warnings-as-errors off its headers, and
# OMPI_SKIP_MPICXX keeps the deprecated MPI C++ bindings (and their warnings) out.
add_library(hawser_trilinos INTERFACE)
add_library(hawser::trilinos ALIAS hawser_trilinos)
set_target_properties(hawser_trilinos PROPERTIES EXPORT_NAME trilinos)
target_include_directories(hawser_trilinos SYSTEM INTERFACE
  ${Trilinos_INCLUDE_DIRS} ${Trilinos_TPL_INCLUDE_DIRS})
target_link_libraries(hawser_trilinos INTERFACE ${Trilinos_LIBRARIES} MPI::MPI_CXX)
target_compile_definitions(hawser_trilinos INTERFACE OMPI_SKIP_MPICXX=1)
install(TARGETS hawser_trilinos EXPORT HawserTargets)

# Debian ships no CMake package for these.
function(hawser_find_library target header library)
  cmake_parse_arguments(PARSE_ARGV 3 arg "" "HINT" "")
  string(MAKE_C_IDENTIFIER "HAWSER_${library}" stem)
  find_path(${stem}_INCLUDE ${header} PATH_SUFFIXES ${arg_HINT} REQUIRED)
  find_library(${stem}_LIBRARY ${library} PATH_SUFFIXES ${arg_HINT} REQUIRED)
  mark_as_advanced(${stem}_INCLUDE ${stem}_LIBRARY)
  add_library(${target} UNKNOWN IMPORTED GLOBAL)
  set_target_properties(${target} PROPERTIES IMPORTED_LOCATION ${${stem}_LIBRARY}
    INTERFACE_INCLUDE_DIRECTORIES ${${stem}_INCLUDE})
endfunction()

hawser_find_library(METIS::METIS metis.h metis)
hawser_find_library(MUMPS::DMUMPS dmumps_c.h dmumps)
hawser_find_library(hdf5::parallel hdf5.h hdf5 HINT hdf5/openmpi)
hawser_find_library(gmsh::gmsh gmsh.h gmsh)
target_link_libraries(hdf5::parallel INTERFACE MPI::MPI_C)
