# How a package, a module and a program are declared.
#
#   hawser_package(NAME mesh LAYER 2
#     SOURCES src/read_mesh.cpp src/partition.cpp
#     DEPENDS base                    # packages of lower layers; every one that is included, by name
#     LIBRARIES METIS::METIS          # seen by who links the package; see dependencies.cmake
#     PRIVATE_LIBRARIES fmt::fmt      # needed in src/ only
#     KERNELS src/hot.cpp)            # further sources, compiled -O3 -march=native
#
# makes the shared library hawser_mesh, alias hawser::mesh, with include/ as its public include folder
# and the package's folder (for "src/x.hpp") as a private one.
#
#   hawser_module(NAME ale_fluid SOURCES ale_fluid.cpp KERNELS kernel.cpp)
#
# the same for packages/modules/*: layer 5, sees base, deck, element and physics. All its sources count as kernels.
# Its include folder is include/ where there is one, else the module's own folder.
#
#   hawser_program(NAME hawser SOURCES main.cpp DEPENDS simulation ale_fluid LIBRARIES CLI11::CLI11)
#
# an executable in build/bin (layer 10).
#
#   hawser_embed_files(templates STEM templates/*.xml)
#
# sets a variable to the initializers {"name", R"(text)"} of those files, named by their STEM or FILENAME, for
# configure_file; the configuration is made anew when they change.

include(check_layers)

# Warnings as errors for our own code only. g++ 12 sees uninitialized strings in structs that are moved
# (a false alarm, and more so at -O3), hence the last one.
add_library(hawser_warnings INTERFACE)
target_compile_options(hawser_warnings INTERFACE -Wall -Wextra -Wpedantic -Wshadow -Werror
  -Wno-maybe-uninitialized)

set(HAWSER_KERNEL_OPTIONS "")
if(HAWSER_NATIVE)
  set(HAWSER_KERNEL_OPTIONS -O3 -march=native)
endif()

function(hawser_package)
  cmake_parse_arguments(PARSE_ARGV 0 arg "" "NAME;LAYER"
    "SOURCES;KERNELS;DEPENDS;LIBRARIES;PRIVATE_LIBRARIES")
  if(arg_UNPARSED_ARGUMENTS OR NOT arg_NAME OR NOT DEFINED arg_LAYER)
    message(FATAL_ERROR "hawser_package: wrong arguments: ${arg_UNPARSED_ARGUMENTS}")
  endif()
  set(target hawser_${arg_NAME})
  if(arg_SOURCES OR arg_KERNELS)
    add_library(${target} SHARED ${arg_SOURCES} ${arg_KERNELS})
    set(scope PUBLIC)
    target_include_directories(${target} PRIVATE ${CMAKE_CURRENT_SOURCE_DIR})
    target_link_libraries(${target} PRIVATE $<BUILD_INTERFACE:hawser_warnings> ${arg_PRIVATE_LIBRARIES})
    target_compile_definitions(${target} PRIVATE HAWSER_VERSION="${PROJECT_VERSION}")
    if(arg_KERNELS)
      set_source_files_properties(${arg_KERNELS} PROPERTIES COMPILE_OPTIONS "${HAWSER_KERNEL_OPTIONS}")
    endif()
  else()
    add_library(${target} INTERFACE)
    set(scope INTERFACE)
  endif()
  add_library(hawser::${arg_NAME} ALIAS ${target})
  set_target_properties(${target} PROPERTIES EXPORT_NAME ${arg_NAME})

  set(include ${CMAKE_CURRENT_SOURCE_DIR})
  if(IS_DIRECTORY ${include}/include)
    set(include ${include}/include)
    install(DIRECTORY include/ DESTINATION ${CMAKE_INSTALL_INCLUDEDIR})
  endif()
  target_include_directories(${target} ${scope}
    $<BUILD_INTERFACE:${include}> $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}>)
  list(TRANSFORM arg_DEPENDS PREPEND hawser:: OUTPUT_VARIABLE packages)
  target_link_libraries(${target} ${scope} ${packages} ${arg_LIBRARIES})
  install(TARGETS ${target} EXPORT HawserTargets)

  hawser_declare_layer(${arg_NAME} ${arg_LAYER} "${arg_DEPENDS}")
endfunction()

function(hawser_module)
  cmake_parse_arguments(PARSE_ARGV 0 arg "" "NAME" "SOURCES;KERNELS;LIBRARIES;PRIVATE_LIBRARIES")
  hawser_package(NAME ${arg_NAME} LAYER 5 KERNELS ${arg_SOURCES} ${arg_KERNELS}
    DEPENDS base deck element physics LIBRARIES ${arg_LIBRARIES} PRIVATE_LIBRARIES ${arg_PRIVATE_LIBRARIES}
    ${arg_UNPARSED_ARGUMENTS})
endfunction()

function(hawser_program)
  cmake_parse_arguments(PARSE_ARGV 0 arg "" "NAME" "SOURCES;DEPENDS;LIBRARIES")
  # The target has its own name because a package may be called like a program.
  add_executable(hawser_${arg_NAME}_program ${arg_SOURCES})
  set_target_properties(hawser_${arg_NAME}_program PROPERTIES OUTPUT_NAME ${arg_NAME})
  list(TRANSFORM arg_DEPENDS PREPEND hawser:: OUTPUT_VARIABLE packages)
  target_link_libraries(hawser_${arg_NAME}_program PRIVATE hawser_warnings ${packages} ${arg_LIBRARIES})
  target_compile_definitions(hawser_${arg_NAME}_program PRIVATE HAWSER_VERSION="${PROJECT_VERSION}")
  target_include_directories(hawser_${arg_NAME}_program PRIVATE ${CMAKE_CURRENT_SOURCE_DIR})
  install(TARGETS hawser_${arg_NAME}_program)
  hawser_declare_layer(${arg_NAME} 10 "${arg_DEPENDS}")
endfunction()

function(hawser_embed_files variable called pattern)
  file(GLOB files CONFIGURE_DEPENDS ${pattern})
  set(result "")
  foreach(file IN LISTS files)
    file(READ ${file} text)
    cmake_path(GET file ${called} name)
    string(APPEND result "{\"${name}\", R\"embedded(${text})embedded\"}, ")
  endforeach()
  set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${files})
  set(${variable} "${result}" PARENT_SCOPE)
endfunction()
