# The runtime is what other projects link: find_package(axisrt) gives axisrt::axisrt.
include(CMakePackageConfigHelpers)
install(TARGETS axisrt EXPORT axisrtTargets ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR})
install(FILES "${PROJECT_SOURCE_DIR}/runtime/include/axisrt.h" DESTINATION ${CMAKE_INSTALL_INCLUDEDIR})
install(EXPORT axisrtTargets NAMESPACE axisrt:: DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/axisrt)
configure_package_config_file("${PROJECT_SOURCE_DIR}/cmake/axisrtConfig.cmake.in"
  "${CMAKE_CURRENT_BINARY_DIR}/axisrtConfig.cmake" INSTALL_DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/axisrt)
write_basic_package_version_file("${CMAKE_CURRENT_BINARY_DIR}/axisrtConfigVersion.cmake" COMPATIBILITY SameMajorVersion)
install(FILES "${CMAKE_CURRENT_BINARY_DIR}/axisrtConfig.cmake" "${CMAKE_CURRENT_BINARY_DIR}/axisrtConfigVersion.cmake"
  DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/axisrt)
if(AXISC_BUILD_TOOL)
  install(TARGETS axisc RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR})
endif()
