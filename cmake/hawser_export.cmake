# The CMake package: installed, and usable from the build folder too (-DHawser_DIR=build).
include(CMakePackageConfigHelpers)

set(destination ${CMAKE_INSTALL_LIBDIR}/cmake/Hawser)
configure_package_config_file(cmake/HawserConfig.cmake.in HawserConfig.cmake
  INSTALL_DESTINATION ${destination})
write_basic_package_version_file(HawserConfigVersion.cmake COMPATIBILITY SameMinorVersion)
foreach(file dependencies hawser_plugin)
  configure_file(cmake/${file}.cmake ${file}.cmake COPYONLY)
endforeach()
export(EXPORT HawserTargets NAMESPACE hawser:: FILE HawserTargets.cmake)

install(EXPORT HawserTargets NAMESPACE hawser:: DESTINATION ${destination})
install(FILES ${PROJECT_BINARY_DIR}/HawserConfig.cmake ${PROJECT_BINARY_DIR}/HawserConfigVersion.cmake
  cmake/dependencies.cmake cmake/hawser_plugin.cmake DESTINATION ${destination})

# What a person looks for beside the program.
install(FILES README.md CHANGELOG.md LICENSE DESTINATION ${CMAKE_INSTALL_DOCDIR})
install(DIRECTORY doc/ DESTINATION ${CMAKE_INSTALL_DOCDIR}/doc)
install(DIRECTORY inputs DESTINATION ${CMAKE_INSTALL_DATADIR}/hawser)
