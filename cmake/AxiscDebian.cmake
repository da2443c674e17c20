# The Debian packages, one for each component, and what only Debian asks for.
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_DEBIAN_PACKAGE_RELEASE 1)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_CONTROL_STRICT_PERMISSION ON)
set(of_this_version "(= ${PROJECT_VERSION}-${CPACK_DEBIAN_PACKAGE_RELEASE})")

# axisc_debian_package(COMPONENT NAME SECTION DESCRIPTION [DEPENDS OTHERS] [CONTROL FILE...]): the first line of the
# description is its summary.
set(AXISC_DEBIAN_PACKAGES "")
macro(axisc_debian_package component name section description)
  cmake_parse_arguments(ARG "" "DEPENDS" "CONTROL" ${ARGN})
  string(TOUPPER "${component}" of)
  set(CPACK_DEBIAN_${of}_PACKAGE_NAME ${name})
  set(CPACK_DEBIAN_${of}_PACKAGE_SECTION ${section})
  set(CPACK_DEBIAN_${of}_PACKAGE_DEPENDS "${ARG_DEPENDS}")
  set(CPACK_DEBIAN_${of}_PACKAGE_CONTROL_EXTRA "${ARG_CONTROL}")
  set(CPACK_COMPONENT_${of}_DESCRIPTION "${description}")
  list(APPEND AXISC_DEBIAN_PACKAGES ${component}=${name})
endmacro()

# axisc_debian_library(COMPONENT NAME LIBRARY ABI NEXT DESCRIPTION): the package of libLIBRARY.so.ABI. cmake/debian has the
# names that it shows and the version of axisc that began to show each; NEXT, if not empty, is the first version that
# programs of this one cannot do with.
macro(axisc_debian_library component name library abi next description)
  set(control "${CMAKE_BINARY_DIR}/debian/${name}")
  configure_file("${PROJECT_SOURCE_DIR}/cmake/debian/${name}.symbols.in" "${control}/symbols" @ONLY)
  set(bounds "${name} (>= ${PROJECT_VERSION})")
  if(NOT "${next}" STREQUAL "")
    string(APPEND bounds ", ${name} (<< ${next})")
  endif()
  file(CONFIGURE OUTPUT "${control}/shlibs" CONTENT "lib${library} ${abi} ${bounds}\n" @ONLY)
  file(CONFIGURE OUTPUT "${control}/triggers" CONTENT "activate-noawait ldconfig\n" @ONLY)
  axisc_debian_package(${component} ${name} libs "${description}"
    CONTROL "${control}/symbols" "${control}/shlibs" "${control}/triggers")
  set(CPACK_DEBIAN_${of}_PACKAGE_SHLIBDEPS ON)
  if(CMAKE_VERSION VERSION_LESS 3.31)
    # cpack has no word for the field yet: it follows the section.
    set(CPACK_DEBIAN_${of}_PACKAGE_SECTION "libs\nMulti-Arch: same")
  else()
    set(CPACK_DEBIAN_${of}_PACKAGE_MULTIARCH same)
  endif()
endmacro()

axisc_debian_package(axisc axisc devel "checks and compiles axis parameter lists
axisc checks axis parameter lists of CNC controls, compiles the filters that
they configure into a coefficient image, and executes such images. It also
predicts contour deviations and draws what filters do.")
set(CPACK_DEBIAN_AXISC_PACKAGE_SHLIBDEPS ON)

set(runtime_description "real-time runtime for images of axisc (development files)
axisrt executes the filters of coefficient images that axisc compiles, in the
real-time task of a controller: no allocation, no system calls, a C interface.
This package contains the static library, the header, and what CMake and
pkg-config need to find them.")
if(NOT AXISC_SHARED)
  axisc_debian_package(axisrt libaxisrt-dev libdevel "${runtime_description}")
else()
  # What links the shared runtime belongs to the package of the static one.
  set(CPACK_COMPONENT_AXISRT_GROUP axisrt)
  set(CPACK_COMPONENT_AXISRT_SHARED_DEV_GROUP axisrt)
  axisc_debian_package(axisrt libaxisrt-dev libdevel "${runtime_description}" DEPENDS "libaxisrt5 ${of_this_version}")
  set(CPACK_COMPONENT_GROUP_AXISRT_DESCRIPTION "${runtime_description}")
  axisc_debian_library(axisrt_shared libaxisrt5 axisrt 5 "" "real-time runtime for images of axisc
axisrt executes the filters of coefficient images that axisc compiles, in the
real-time task of a controller: no allocation, no system calls, a C interface.
This package contains the shared library.")
  # While the number of the interface is 0, every version may have another.
  axisc_debian_library(libaxisc libaxisc0 axisc 0 "${PROJECT_VERSION}.0~" "checks and compiles axis parameter lists (library)
libaxisc checks axis parameter lists of CNC controls, compiles the filters that
they configure into a coefficient image, and answers questions about a machine,
for programs in C and every language that loads libraries.")
  axisc_debian_package(libaxisc_dev libaxisc-dev libdevel "checks and compiles axis parameter lists (development files)
libaxisc checks axis parameter lists of CNC controls, compiles the filters that
they configure into a coefficient image, and answers questions about a machine.
This package contains the header, the static library, and what CMake and
pkg-config need to find both libraries."
    DEPENDS "libaxisc0 ${of_this_version}, libpugixml-dev, libsodium-dev, zlib1g-dev")
  axisc_debian_package(python3_axisc python3-axisc python "checks and compiles axis parameter lists (Python)
The module axisc checks axis parameter lists of CNC controls, repairs and
compiles them, answers questions about a machine, and executes the filters of
coefficient images."
    DEPENDS "python3 (>= 3.9), libaxisc0 ${of_this_version}, libaxisrt5 ${of_this_version}"
    CONTROL "${PROJECT_SOURCE_DIR}/cmake/debian/python3-axisc/postinst" "${PROJECT_SOURCE_DIR}/cmake/debian/python3-axisc/prerm")
  set(CPACK_DEBIAN_PYTHON3_AXISC_PACKAGE_ARCHITECTURE all)
  set(CPACK_DEBIAN_PYTHON3_AXISC_PACKAGE_SUGGESTS python3-numpy)
  list(APPEND CPACK_COMPONENTS_ALL axisrt_shared axisrt_shared_dev libaxisc libaxisc_dev python3_axisc)
endif()
list(JOIN AXISC_DEBIAN_PACKAGES " " packages)
# Compressed pages, changelog and copyright.
set(CPACK_PRE_BUILD_SCRIPTS "${CMAKE_BINARY_DIR}/AxiscDebianFiles.cmake")
configure_file("${PROJECT_SOURCE_DIR}/cmake/AxiscDebianFiles.cmake.in" "${CPACK_PRE_BUILD_SCRIPTS}" @ONLY)
