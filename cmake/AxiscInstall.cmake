# The runtime is what other projects link: find_package(axisrt) gives axisrt::axisrt and axisrt::axisrt_c, pkg-config
# knows axisrt.
# `cmake --install build/release --component axisrt` installs it alone.
include(CMakePackageConfigHelpers)
set(package "${CMAKE_INSTALL_LIBDIR}/cmake/axisrt")
install(TARGETS axisrt axisrt_c EXPORT axisrtTargets ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT axisrt)
install(FILES "${PROJECT_SOURCE_DIR}/runtime/include/axisrt.h" "${PROJECT_SOURCE_DIR}/runtime/c99/axisrt_c.h" DESTINATION ${CMAKE_INSTALL_INCLUDEDIR} COMPONENT axisrt)
install(EXPORT axisrtTargets NAMESPACE axisrt:: DESTINATION ${package} COMPONENT axisrt)
configure_package_config_file("${PROJECT_SOURCE_DIR}/cmake/axisrtConfig.cmake.in"
  "${CMAKE_CURRENT_BINARY_DIR}/axisrtConfig.cmake" INSTALL_DESTINATION ${package})
write_basic_package_version_file("${CMAKE_CURRENT_BINARY_DIR}/axisrtConfigVersion.cmake" COMPATIBILITY SameMajorVersion)
install(FILES "${CMAKE_CURRENT_BINARY_DIR}/axisrtConfig.cmake" "${CMAKE_CURRENT_BINARY_DIR}/axisrtConfigVersion.cmake"
  DESTINATION ${package} COMPONENT axisrt)
# The prefix is computed from where the file lies: an install tree may be chosen, or moved, after configuring.
file(RELATIVE_PATH prefix_from_pkgconfig "/${CMAKE_INSTALL_LIBDIR}/pkgconfig" "/")
configure_file("${PROJECT_SOURCE_DIR}/cmake/axisrt.pc.in" "${CMAKE_CURRENT_BINARY_DIR}/axisrt.pc" @ONLY)
install(FILES "${CMAKE_CURRENT_BINARY_DIR}/axisrt.pc" DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig COMPONENT axisrt)
# Shared: libaxisrt.so.N, `--component axisrt_shared`; what links it, axisrt::shared, is in axisrt_shared_dev.
if(AXISC_SHARED)
  install(TARGETS axisrt_shared EXPORT axisrtSharedTargets LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT axisrt_shared
    NAMELINK_COMPONENT axisrt_shared_dev)
  install(EXPORT axisrtSharedTargets NAMESPACE axisrt:: DESTINATION ${package} COMPONENT axisrt_shared_dev)
endif()
# libaxisc.so.N, `--component libaxisc`. What links it is in libaxisc_dev: find_package(libaxisc) gives axisc::libaxisc
# and axisc::libaxisc_static, pkg-config knows axisc.
if(TARGET libaxisc)
  set(library_package "${CMAKE_INSTALL_LIBDIR}/cmake/libaxisc")
  install(TARGETS libaxisc libaxisc_static EXPORT libaxiscTargets
    LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT libaxisc NAMELINK_COMPONENT libaxisc_dev
    ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT libaxisc_dev)
  install(FILES "${PROJECT_SOURCE_DIR}/axisc/axisc.h" DESTINATION ${CMAKE_INSTALL_INCLUDEDIR} COMPONENT libaxisc_dev)
  install(EXPORT libaxiscTargets NAMESPACE axisc:: DESTINATION ${library_package} COMPONENT libaxisc_dev)
  configure_package_config_file("${PROJECT_SOURCE_DIR}/cmake/libaxiscConfig.cmake.in"
    "${CMAKE_CURRENT_BINARY_DIR}/libaxiscConfig.cmake" INSTALL_DESTINATION ${library_package})
  write_basic_package_version_file("${CMAKE_CURRENT_BINARY_DIR}/libaxiscConfigVersion.cmake" COMPATIBILITY ExactVersion)
  install(FILES "${CMAKE_CURRENT_BINARY_DIR}/libaxiscConfig.cmake" "${CMAKE_CURRENT_BINARY_DIR}/libaxiscConfigVersion.cmake"
    DESTINATION ${library_package} COMPONENT libaxisc_dev)
  configure_file("${PROJECT_SOURCE_DIR}/cmake/axisc.pc.in" "${CMAKE_CURRENT_BINARY_DIR}/axisc.pc" @ONLY)
  install(FILES "${CMAKE_CURRENT_BINARY_DIR}/axisc.pc" DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig COMPONENT libaxisc_dev)
endif()
# find_package(axisc) gives the program and axisc_add_image(); `--component axisc` installs it alone.
if(AXISC_BUILD_TOOL)
  set(tool_package "${CMAKE_INSTALL_LIBDIR}/cmake/axisc")
  install(TARGETS axisc EXPORT axiscTargets RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR} COMPONENT axisc)
  install(EXPORT axiscTargets NAMESPACE axisc:: DESTINATION ${tool_package} COMPONENT axisc)
  configure_package_config_file("${PROJECT_SOURCE_DIR}/cmake/axiscConfig.cmake.in"
    "${CMAKE_CURRENT_BINARY_DIR}/axiscConfig.cmake" INSTALL_DESTINATION ${tool_package})
  write_basic_package_version_file("${CMAKE_CURRENT_BINARY_DIR}/axiscConfigVersion.cmake"
    COMPATIBILITY SameMajorVersion ARCH_INDEPENDENT)
  install(FILES "${CMAKE_CURRENT_BINARY_DIR}/axiscConfig.cmake" "${CMAKE_CURRENT_BINARY_DIR}/axiscConfigVersion.cmake"
    "${PROJECT_SOURCE_DIR}/cmake/AxiscAddImage.cmake" DESTINATION ${tool_package} COMPONENT axisc)
endif()
