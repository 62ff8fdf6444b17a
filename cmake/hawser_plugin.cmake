# A plug-in: one shared library, loaded by name with <plugin name="my_heat"/>.
#
#   hawser_add_plugin(my_heat heat.cpp)
#
# makes my_heat.so, without prefix, in lib/hawser/plugins of the build folder. Works in the tree and,
# after find_package(Hawser), out of it. It sees what a built-in module sees.

function(hawser_add_plugin name)
  add_library(${name} MODULE ${ARGN})
  target_link_libraries(${name} PRIVATE hawser::physics)
  set_target_properties(${name} PROPERTIES PREFIX ""
    CXX_STANDARD 17 CXX_STANDARD_REQUIRED ON CXX_EXTENSIONS OFF
    LIBRARY_OUTPUT_DIRECTORY ${PROJECT_BINARY_DIR}/lib/hawser/plugins)
  set_source_files_properties(${ARGN} PROPERTIES COMPILE_OPTIONS "${HAWSER_KERNEL_OPTIONS}")
  if(TARGET hawser_warnings)
    target_link_libraries(${name} PRIVATE hawser_warnings)
  endif()
endfunction()
