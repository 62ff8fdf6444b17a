# Includes point downward only. Every declaration is noted; hawser_check_layers(), called once all
# folders are read, stops configuration and lists every breach. Tests may look wherever they need to.
#
# The check is of the text of the sources, so an #include edited later is seen at the next
# configuration; the test `layers` runs the same check at every ctest.

set(HAWSER_MODULE_SEES base deck element physics)

# Headers that stay where they are: "pattern of the include | folders, or files, that may have it".
set(HAWSER_CONFINED_HEADERS
  "(Tpetra|Teuchos)[_.]|packages/algebra packages/assembly/src packages/solve/src packages/time/src"
  "(NOX|Thyra|Belos|Ifpack2|MueLu|Stratimikos)[_.A-Z]|packages/solve/src"
  "Sacado|packages/physics packages/modules"
  "Intrepid2|packages/element/src"
  "[a-z]mumps|packages/solve/src"
  "metis|packages/mesh/src"
  "pugixml|packages/deck/src"
  "nlohmann/|packages/output/src packages/log/src packages/study/src apps/hawser"
  "gmsh|apps/mesher"
  "proj[.]h|packages/navigation/src"
  "(hdf5|H5[A-Z])[A-Za-z]*public|packages/output/src"
  "hdf5[.]h|packages/output/src")

function(hawser_declare_layer name layer depends)
  set_property(GLOBAL APPEND PROPERTY HAWSER_LAYERED ${name})
  set_property(GLOBAL PROPERTY HAWSER_LAYER_${name} ${layer})
  set_property(GLOBAL PROPERTY HAWSER_DEPENDS_${name} "${depends}")
  set_property(GLOBAL PROPERTY HAWSER_FOLDER_${name} ${CMAKE_CURRENT_SOURCE_DIR})
endfunction()

function(hawser_check_layers)
  set(faults "")
  get_property(names GLOBAL PROPERTY HAWSER_LAYERED)
  foreach(name IN LISTS names)
    get_property(layer GLOBAL PROPERTY HAWSER_LAYER_${name})
    get_property(depends GLOBAL PROPERTY HAWSER_DEPENDS_${name})
    get_property(folder GLOBAL PROPERTY HAWSER_FOLDER_${name})
    cmake_path(RELATIVE_PATH folder BASE_DIRECTORY ${PROJECT_SOURCE_DIR} OUTPUT_VARIABLE where)
    foreach(other IN LISTS depends)
      get_property(other_layer GLOBAL PROPERTY HAWSER_LAYER_${other})
      if(NOT other IN_LIST names)
        string(APPEND faults "  ${where} depends on '${other}', which is no package here\n")
      elseif(NOT other_layer LESS layer)
        string(APPEND faults "  ${where} (layer ${layer}) must not depend on ${other} "
          "(layer ${other_layer}): only lower layers\n")
      endif()
      if(where MATCHES "^packages/modules/" AND NOT other IN_LIST HAWSER_MODULE_SEES)
        string(APPEND faults "  ${where}: a module sees ${HAWSER_MODULE_SEES} only, not ${other}\n")
      endif()
    endforeach()
    hawser_check_includes(${name} ${folder} "${names}" "${depends}" found)
    string(APPEND faults "${found}")
  endforeach()
  if(faults)
    message(FATAL_ERROR "Includes must point downward (doc/architecture.md):\n${faults}")
  endif()
endfunction()

# Every #include of the package's sources and headers, its tests left out.
function(hawser_check_includes name folder names depends result)
  set(faults "")
  file(GLOB_RECURSE files ${folder}/*.hpp ${folder}/*.cpp ${folder}/*.h)
  foreach(file IN LISTS files)
    cmake_path(RELATIVE_PATH file BASE_DIRECTORY ${PROJECT_SOURCE_DIR} OUTPUT_VARIABLE where)
    if(where MATCHES "/tests/")
      continue()
    endif()
    file(STRINGS ${file} lines REGEX "^[ \t]*#[ \t]*include")
    foreach(line IN LISTS lines)
      string(REGEX REPLACE "^[^\"<]*[\"<]([^\">]*).*" "\\1" header "${line}")
      if(header MATCHES "^hawser/([^/]+)/" AND NOT CMAKE_MATCH_1 STREQUAL name)
        if(NOT CMAKE_MATCH_1 IN_LIST depends)
          string(APPEND faults "  ${where} includes ${header}, but '${name}' does not name "
            "'${CMAKE_MATCH_1}' in its DEPENDS\n")
        endif()
      endif()
      foreach(rule IN LISTS HAWSER_CONFINED_HEADERS)
        string(REGEX MATCH "^(.*)[|]([^|]*)$" rule "${rule}")
        set(pattern "${CMAKE_MATCH_1}")
        string(REPLACE " " ";" homes "${CMAKE_MATCH_2}")
        if(header MATCHES "^(${pattern})")
          set(at_home FALSE)
          foreach(home IN LISTS homes)
            if(where MATCHES "^${home}(/|$)")
              set(at_home TRUE)
            endif()
          endforeach()
          if(NOT at_home)
            string(APPEND faults "  ${where} includes ${header}, which belongs in ${homes} only\n")
          endif()
        endif()
      endforeach()
    endforeach()
  endforeach()
  set(${result} "${faults}" PARENT_SCOPE)
endfunction()
