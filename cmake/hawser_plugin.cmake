# A plug-in: one shared library, loaded by name with <plugin name="my_heat"/>.
#
#   hawser_add_plugin(my_heat heat.cpp)
#   hawser_add_plugin(my_energy energy.cpp LIBRARIES hawser::report)   # it has reports
#
# makes my_heat.so, without prefix, in lib/hawser/plugins of the build folder, and installs it into
# lib/hawser/plugins of the prefix, where an installed hawser of the same prefix looks for it (NO_INSTALL
# leaves that out). Works in the tree and, after find_package(Hawser), out of it. It sees what a built-in
# module sees, and the libraries given.

function(hawser_add_plugin name)
  cmake_parse_arguments(PARSE_ARGV 1 arg "NO_INSTALL" "" "LIBRARIES")
  set(sources ${arg_UNPARSED_ARGUMENTS})
  add_library(${name} MODULE ${sources})
  target_link_libraries(${name} PRIVATE hawser::physics ${arg_LIBRARIES})
  set_target_properties(${name} PROPERTIES PREFIX ""
    CXX_STANDARD 17 CXX_STANDARD_REQUIRED ON CXX_EXTENSIONS OFF
    LIBRARY_OUTPUT_DIRECTORY ${PROJECT_BINARY_DIR}/lib/hawser/plugins)
  set_source_files_properties(${sources} PROPERTIES COMPILE_OPTIONS "${HAWSER_KERNEL_OPTIONS}")
  if(TARGET hawser_warnings)
    target_link_libraries(${name} PRIVATE hawser_warnings)
  endif()
  if(NOT arg_NO_INSTALL)
    install(TARGETS ${name} LIBRARY DESTINATION lib/hawser/plugins)
  endif()
endfunction()
