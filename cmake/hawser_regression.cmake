# A deck whose results must stay what they are.
#
#   hawser_add_regression(deep_tow/case_02_quick RANKS 1 2 4 LABELS slow TIMEOUT 900)
#
# runs inputs/deep_tow/case_02_quick.xml on each number of ranks, as tests of their own
# (regression.deep_tow.case_02_quick.np2), and compares its summary.json with the one reference,
# tests/regression/references/deep_tow/case_02_quick.json:
#   {"quantities": {"end_error_m": {"value": 153.9, "absolute": 0.01},
#                   "timings.steps": {"value": 270, "relative": 0}}}
# Renewed by `python3 tests/regression/renew.py deep_tow/case_02_quick`.

function(hawser_add_regression deck)
  cmake_parse_arguments(PARSE_ARGV 1 arg "" "TIMEOUT" "RANKS;LABELS")
  if(NOT arg_RANKS)
    set(arg_RANKS 1)
  endif()
  if(NOT arg_TIMEOUT)
    set(arg_TIMEOUT 900)
  endif()
  string(REPLACE "/" "." name "regression/${deck}")
  foreach(ranks IN LISTS arg_RANKS)
    add_test(NAME ${name}.np${ranks} COMMAND /usr/bin/python3
      ${PROJECT_SOURCE_DIR}/tests/regression/regression.py ${deck} --ranks ${ranks}
      --build ${PROJECT_BINARY_DIR})
    set_tests_properties(${name}.np${ranks} PROPERTIES PROCESSORS ${ranks} TIMEOUT ${arg_TIMEOUT}
      LABELS "regression;${arg_LABELS}" ENVIRONMENT "${HAWSER_TEST_ENVIRONMENT}")
  endforeach()
endfunction()
