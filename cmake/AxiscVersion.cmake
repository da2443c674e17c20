# AXISC_DATE, AXISC_COMMIT, AXISC_COMPILER and AXISC_HOMEPAGE: the origin of the program and its packages, as they report it.
# No clock is read.
set(changelog "${PROJECT_SOURCE_DIR}/CHANGELOG.md")
file(STRINGS "${changelog}" heading REGEX "^## ${PROJECT_VERSION} ")
string(REGEX MATCH "[0-9]+-[0-9]+-[0-9]+" AXISC_DATE "${heading}")
if(NOT AXISC_DATE)
  message(FATAL_ERROR "CHANGELOG.md names no day of version ${PROJECT_VERSION}")
endif()
set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS "${changelog}")
# Every file of a package is as old as its version: it is the same bytes whenever it is made.
if(DEFINED ENV{SOURCE_DATE_EPOCH})
  set(AXISC_EPOCH $ENV{SOURCE_DATE_EPOCH})
else()
  execute_process(COMMAND date --utc --date=${AXISC_DATE} +%s OUTPUT_VARIABLE AXISC_EPOCH OUTPUT_STRIP_TRAILING_WHITESPACE
    ERROR_QUIET)
endif()

set(AXISC_COMMIT "" CACHE STRING "The commit that --version names; empty: that of the checkout")
set(commit "${AXISC_COMMIT}")
if(NOT commit AND EXISTS "${PROJECT_SOURCE_DIR}/.git")
  execute_process(COMMAND git -C "${PROJECT_SOURCE_DIR}" rev-parse --short=12 HEAD
    OUTPUT_VARIABLE commit OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET)
  set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS "${PROJECT_SOURCE_DIR}/.git/logs/HEAD")
endif()
if(NOT commit)
  set(commit unknown)
endif()
string(REPLACE GNU GCC AXISC_COMPILER "${CMAKE_CXX_COMPILER_ID} ${CMAKE_CXX_COMPILER_VERSION}")
set(AXISC_ORIGIN "commit ${commit}, ${AXISC_COMPILER}")

# AXISC_HOMEPAGE: where this is published, for packages and bills of materials. The environment comes first, as it
# does for SOURCE_DATE_EPOCH; empty while project() in CMakeLists.txt names nobody.
set(AXISC_HOMEPAGE "${PROJECT_HOMEPAGE_URL}")
if(DEFINED ENV{AXISC_HOMEPAGE})
  set(AXISC_HOMEPAGE "$ENV{AXISC_HOMEPAGE}")
endif()
if(AXISC_HOMEPAGE MATCHES "/OWNER(/|$)")
  set(AXISC_HOMEPAGE "")
endif()
