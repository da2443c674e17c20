# Dependencies of builds for systems that Debian has no libraries for: those without code from this system's
# packages, the others compiled from Debian's sources. The targets are called as in AxiscDependencies.cmake.
set(AXISC_LIBRARY_SOURCES "$ENV{AXISC_LIBRARY_SOURCES}" CACHE PATH "Where cmake/fetch-sources put the sources of libraries")
if(NOT AXISC_LIBRARY_SOURCES)
  set(AXISC_LIBRARY_SOURCES "${CMAKE_BINARY_DIR}/sources" CACHE PATH "" FORCE)
endif()
execute_process(COMMAND "${PROJECT_SOURCE_DIR}/cmake/fetch-sources" "${AXISC_LIBRARY_SOURCES}" COMMAND_ERROR_IS_FATAL ANY)

# /usr/include itself would bring the headers of this system's C library.
set(headers "${CMAKE_BINARY_DIR}/headers")
file(MAKE_DIRECTORY "${headers}")
foreach(name boost fmt nlohmann CLI)
  file(CREATE_LINK "/usr/include/${name}" "${headers}/${name}" SYMBOLIC)
endforeach()
function(axisc_headers target)
  add_library(${target} INTERFACE IMPORTED GLOBAL)
  target_include_directories(${target} SYSTEM INTERFACE "${headers}")
  target_compile_definitions(${target} INTERFACE ${ARGN})
endfunction()
axisc_headers(Boost::headers)
axisc_headers(nlohmann_json::nlohmann_json)
axisc_headers(CLI11::CLI11)
axisc_headers(fmt::fmt-header-only FMT_HEADER_ONLY=1)
if(EMSCRIPTEN)
  # One thread; the functions of the others are there.
  add_library(Threads::Threads INTERFACE IMPORTED GLOBAL)
else()
  find_package(Threads REQUIRED)
endif()

# Versions of what the program contains, for its bill of materials. The sources are those of the packages of
# the same version.
function(axisc_debian_version variable package)
  execute_process(COMMAND dpkg-query --show "--showformat=\${source:Upstream-Version}" ${package} OUTPUT_VARIABLE version
    COMMAND_ERROR_IS_FATAL ANY)
  set(${variable} ${version} PARENT_SCOPE)
endfunction()
file(STRINGS "/usr/include/boost/version.hpp" Boost_VERSION_STRING REGEX "define BOOST_LIB_VERSION")
string(REGEX MATCH "[0-9]+_[0-9]+" Boost_VERSION_STRING "${Boost_VERSION_STRING}")
string(REPLACE "_" "." Boost_VERSION_STRING "${Boost_VERSION_STRING}")
axisc_debian_version(fmt_VERSION libfmt-dev)
axisc_debian_version(nlohmann_json_VERSION nlohmann-json3-dev)
axisc_debian_version(CLI11_VERSION libcli11-dev)
axisc_debian_version(sodium_VERSION libsodium-dev)
axisc_debian_version(pugixml_VERSION libpugixml-dev)
axisc_debian_version(ZLIB_VERSION_STRING zlib1g-dev)

# axisc_compiled_library(PkgConfig::sodium axisc_sodium FOLDER SOURCE...): the folder with its headers
function(axisc_compiled_library alias target folder)
  add_library(${target} STATIC ${ARGN})
  target_include_directories(${target} SYSTEM PUBLIC "${folder}")
  target_compile_options(${target} PRIVATE -w)
  add_library(${alias} ALIAS ${target})
endfunction()

axisc_compiled_library(PkgConfig::pugixml axisc_pugixml "${AXISC_LIBRARY_SOURCES}/pugixml/src"
  "${AXISC_LIBRARY_SOURCES}/pugixml/src/pugixml.cpp")

set(zlib_sources adler32 crc32 deflate trees zutil)
list(TRANSFORM zlib_sources REPLACE "^(.+)$" "${AXISC_LIBRARY_SOURCES}/zlib/\\1.c")
axisc_compiled_library(ZLIB::ZLIB axisc_zlib "${AXISC_LIBRARY_SOURCES}/zlib" ${zlib_sources})

set(sodium "${AXISC_LIBRARY_SOURCES}/libsodium/src/libsodium")
file(GLOB_RECURSE sodium_sources "${sodium}/*.c")
axisc_compiled_library(PkgConfig::sodium axisc_sodium "${sodium}/include" ${sodium_sources})
file(STRINGS "${AXISC_LIBRARY_SOURCES}/libsodium/configure.ac" version REGEX "^(AC_INIT|SODIUM_LIBRARY_VERSION_(MAJOR|MINOR)=)")
string(REGEX MATCH "AC_INIT\\(\\[libsodium\\],\\[([0-9.]+)\\]" ignored "${version}")
set(VERSION ${CMAKE_MATCH_1})
string(REGEX MATCH "MAJOR=([0-9]+)" ignored "${version}")
set(SODIUM_LIBRARY_VERSION_MAJOR ${CMAKE_MATCH_1})
string(REGEX MATCH "MINOR=([0-9]+)" ignored "${version}")
set(SODIUM_LIBRARY_VERSION_MINOR ${CMAKE_MATCH_1})
set(SODIUM_LIBRARY_MINIMAL_DEF "")
configure_file("${sodium}/include/sodium/version.h.in" "${CMAKE_BINARY_DIR}/sodium/sodium/version.h" @ONLY)
target_include_directories(axisc_sodium SYSTEM PUBLIC "${CMAKE_BINARY_DIR}/sodium")
target_include_directories(axisc_sodium PRIVATE "${sodium}/include/sodium" "${CMAKE_BINARY_DIR}/sodium/sodium")
target_compile_definitions(axisc_sodium PRIVATE CONFIGURED=1 NATIVE_LITTLE_ENDIAN=1 PUBLIC SODIUM_STATIC=1)
