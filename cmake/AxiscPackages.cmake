# Packages: cpack --config build/packages/CPackConfig.cmake -G DEB; with the presets static and windows, -G
# TXZ and ZIP (.ci/packages and .ci/windows do that).
include(AxiscParts)
set(documents "${CMAKE_INSTALL_DATADIR}/doc/axisc")
# Files that the program itself writes are missing in cross builds, and where only the program was built.
install(DIRECTORY "${AXISC_SHARE}/" DESTINATION ${CMAKE_INSTALL_DATADIR} COMPONENT axisc OPTIONAL)
install(DIRECTORY "${PROJECT_SOURCE_DIR}/docs/schemas/" DESTINATION ${CMAKE_INSTALL_DATADIR}/axisc COMPONENT axisc
  FILES_MATCHING PATTERN "*.json")
install(FILES "${AXISC_NOTICES}/axisc.spdx.json" "${AXISC_NOTICES}/third-party-licences.txt" DESTINATION ${documents} COMPONENT axisc)
if(NOT PROJECT_IS_TOP_LEVEL)
  return()
endif()

# Every file is as old as its version: packages are the same bytes whenever they are made.
if(DEFINED ENV{SOURCE_DATE_EPOCH})
  set(AXISC_EPOCH $ENV{SOURCE_DATE_EPOCH})
else()
  execute_process(COMMAND date --utc --date=${AXISC_DATE} +%s OUTPUT_VARIABLE AXISC_EPOCH OUTPUT_STRIP_TRAILING_WHITESPACE)
endif()
set(CPACK_PROJECT_CONFIG_FILE "${CMAKE_BINARY_DIR}/CPackEach.cmake")
file(CONFIGURE OUTPUT "${CPACK_PROJECT_CONFIG_FILE}" @ONLY CONTENT [[
set(ENV{SOURCE_DATE_EPOCH} @AXISC_EPOCH@)
if(CPACK_GENERATOR STREQUAL DEB)
  set(CPACK_COMPONENT_INCLUDE_TOPLEVEL_DIRECTORY OFF)
  set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "")  # each package has its own
endif()
]])

set(CPACK_PACKAGE_VENDOR "The axisc authors")
set(AXISC_CONTACT "The axisc authors <axisc@example.com>" CACHE STRING "Maintainer of the packages")
set(CPACK_PACKAGE_CONTACT "${AXISC_CONTACT}")
set(CPACK_RESOURCE_FILE_LICENSE "${PROJECT_SOURCE_DIR}/LICENSE")
set(CPACK_STRIP_FILES ON)
set(CPACK_VERBATIM_VARIABLES ON)
set(CPACK_COMPONENTS_ALL axisc axisrt)
set(CPACK_PACKAGE_CHECKSUM SHA256)

set(CPACK_ARCHIVE_COMPONENT_INSTALL ON)
set(CPACK_COMPONENT_INCLUDE_TOPLEVEL_DIRECTORY ON)
string(TOLOWER "${CMAKE_SYSTEM_NAME}-${CMAKE_SYSTEM_PROCESSOR}" system)
set(CPACK_PACKAGE_FILE_NAME "axisc-${PROJECT_VERSION}-${system}")
set(CPACK_ARCHIVE_AXISC_FILE_NAME "${CPACK_PACKAGE_FILE_NAME}")
if(AXISC_STATIC OR AXISC_COMPILE_LIBRARIES)
  set(CPACK_COMPONENTS_ALL axisc)
  install(FILES "${PROJECT_SOURCE_DIR}/LICENSE" "${PROJECT_SOURCE_DIR}/CHANGELOG.md" DESTINATION ${documents} COMPONENT axisc)
endif()

set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_DEBIAN_PACKAGE_RELEASE 1)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_CONTROL_STRICT_PERMISSION ON)
set(CPACK_DEBIAN_AXISC_PACKAGE_NAME axisc)
set(CPACK_DEBIAN_AXISC_PACKAGE_SECTION devel)
set(CPACK_DEBIAN_AXISC_PACKAGE_SHLIBDEPS ON)
set(CPACK_COMPONENT_AXISC_DESCRIPTION "checks and compiles axis parameter lists
axisc checks axis parameter lists of CNC controls, compiles the filters that
they configure into a coefficient image, and executes such images. It also
predicts contour deviations and draws what filters do.")
set(CPACK_DEBIAN_AXISRT_PACKAGE_NAME libaxisrt-dev)
set(CPACK_DEBIAN_AXISRT_PACKAGE_SECTION libdevel)
set(CPACK_COMPONENT_AXISRT_DESCRIPTION "real-time runtime for images of axisc (development files)
axisrt executes the filters of coefficient images that axisc compiles, in the
real-time task of a controller: no allocation, no system calls, a C interface.
This package contains the static library, the header, and what CMake and
pkg-config need to find them.")
# Including what only Debian asks for: compressed pages, changelog and copyright.
set(CPACK_PRE_BUILD_SCRIPTS "${CMAKE_BINARY_DIR}/AxiscDebian.cmake")
configure_file("${PROJECT_SOURCE_DIR}/cmake/AxiscDebian.cmake.in" "${CPACK_PRE_BUILD_SCRIPTS}" @ONLY)
include(CPack)
