# A gtest program, run under mpirun once per number of ranks.
#
#   hawser_test(NAME mesh_partition SOURCES partition_test.cpp
#     RANKS 1 2 3                     # default 1; the tests are called mesh_partition.np1, .np2, .np3
#     LIBRARIES hawser::mesh          # hawser:: packages and anything else
#     LABELS slow                     # `slow` keeps it out of `quickstart test`; the tests in
#                                     # packages/*/tests are labelled `unit` unless they say otherwise
#     TPETRA                          # start and stop Kokkos too; needed by whoever uses Tpetra
#     TIMEOUT 300)                    # s
#
# There is no main() to write: tests/support has it. It silences ranks other than 0 unless they fail,
# and a failure on any rank fails the test. A source that needs the repository's root is compiled with
# HAWSER_SOURCE_DIR (hawser_knows_source_dir(file)); the others stay the same to ccache in every checkout.
#
#   hawser_mpi_test(NAME x RANKS 2 COMMAND program arguments...)   # any program, run likewise
# A literal @RANKS@ in the arguments becomes the number of ranks.

# Ranks outnumber cores on small machines, and the tests run as root in CI.
set(HAWSER_TEST_ENVIRONMENT OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1
  OMPI_MCA_mpi_yield_when_idle=1 OMP_NUM_THREADS=1 OPENBLAS_NUM_THREADS=1
  ASAN_OPTIONS=detect_leaks=0)  # Open MPI leaks on purpose

# Figures for doc/verification.md (tests/support/figure.hpp) come from the first number of ranks.
function(hawser_mpi_test)
  cmake_parse_arguments(PARSE_ARGV 0 arg "" "NAME;TIMEOUT" "COMMAND;RANKS;LABELS")
  if(NOT arg_RANKS)
    set(arg_RANKS 1)
  endif()
  if(NOT arg_TIMEOUT)
    set(arg_TIMEOUT 300)
  endif()
  set(environment ${HAWSER_TEST_ENVIRONMENT} HAWSER_FIGURES=${PROJECT_BINARY_DIR}/tests/figures)
  foreach(ranks IN LISTS arg_RANKS)
    string(REPLACE "@RANKS@" ${ranks} command "${arg_COMMAND}")
    add_test(NAME ${arg_NAME}.np${ranks} COMMAND ${MPIEXEC_EXECUTABLE} -np ${ranks} --oversubscribe
      --bind-to none ${command})
    set_tests_properties(${arg_NAME}.np${ranks} PROPERTIES PROCESSORS ${ranks}
      TIMEOUT ${arg_TIMEOUT} LABELS "${arg_LABELS}" ENVIRONMENT "${environment}")
    set(environment ${HAWSER_TEST_ENVIRONMENT})
  endforeach()
endfunction()

function(hawser_test)
  if(NOT HAWSER_TESTS)
    return()
  endif()
  cmake_parse_arguments(PARSE_ARGV 0 arg "TPETRA" "NAME;TIMEOUT" "SOURCES;RANKS;LIBRARIES;LABELS")
  if(NOT arg_LABELS AND CMAKE_CURRENT_SOURCE_DIR MATCHES "/packages/")
    set(arg_LABELS unit)
  endif()
  set(target ${arg_NAME}_test)
  add_executable(${target} ${arg_SOURCES})
  set_target_properties(${target} PROPERTIES
    RUNTIME_OUTPUT_DIRECTORY ${PROJECT_BINARY_DIR}/tests/bin)
  target_include_directories(${target} PRIVATE ${CMAKE_CURRENT_SOURCE_DIR})
  target_compile_definitions(${target} PRIVATE HAWSER_TEST_NAME="${arg_NAME}")
  set(main hawser_test_main)
  if(arg_TPETRA)
    set(main hawser_test_main_tpetra)
  endif()
  target_link_libraries(${target} PRIVATE hawser_warnings ${main} ${arg_LIBRARIES})
  hawser_mpi_test(NAME ${arg_NAME} RANKS ${arg_RANKS} LABELS ${arg_LABELS} TIMEOUT ${arg_TIMEOUT}
    COMMAND $<TARGET_FILE:${target}>)
endfunction()

function(hawser_knows_source_dir)
  set_source_files_properties(${ARGN} PROPERTIES
    COMPILE_DEFINITIONS HAWSER_SOURCE_DIR="${PROJECT_SOURCE_DIR}")
endfunction()
