# Packages: cpack --config build/packages/CPackConfig.cmake -G DEB; with the presets static and windows, -G
# TXZ and ZIP (.ci/packages and .ci/windows do that).
include(AxiscParts)
set(documents "${CMAKE_INSTALL_DATADIR}/doc/axisc")
# Files that the program itself writes are missing in cross builds, and where only the program was built.
install(DIRECTORY "${AXISC_SHARE}/" DESTINATION ${CMAKE_INSTALL_DATADIR} COMPONENT axisc OPTIONAL)
install(DIRECTORY "${PROJECT_SOURCE_DIR}/docs/schemas/" DESTINATION ${CMAKE_INSTALL_DATADIR}/axisc COMPONENT axisc
  FILES_MATCHING PATTERN "*.json")
install(FILES "${AXISC_NOTICES}/axisc.spdx.json" "${AXISC_NOTICES}/third-party-licences.txt" DESTINATION ${documents} COMPONENT axisc)
if(TARGET libaxisc)
  install(FILES "${AXISC_NOTICES}/libaxisc/axisc.spdx.json" "${AXISC_NOTICES}/libaxisc/third-party-licences.txt"
    DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/libaxisc0 COMPONENT libaxisc)
endif()
if(NOT PROJECT_IS_TOP_LEVEL)
  return()
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
set(CPACK_PACKAGE_HOMEPAGE_URL "${AXISC_HOMEPAGE}")
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

include(AxiscDebian)
include(CPack)
