# Pages in English and German as constants of the program.
#
#   axisc_embed_pages(target namespace header PAGE...)
#       defines `std::span<Page const> page_table()` of the namespace, which the header declares. The paths
#       alternate: en.md, then de.md of the same page.
#
# The same file, run as a script, writes the source:
#   cmake -DLIST=… -DSPACE=… -DHEADER=… -DOUTPUT=… -P EmbedPages.cmake

function(axisc_embed_pages target space header)
  # The list is a file of its own so that a removed page is noticed like a changed one.
  set(list "${CMAKE_CURRENT_BINARY_DIR}/pages.list")
  file(CONFIGURE OUTPUT "${list}" CONTENT "${ARGN}")
  set(output "${CMAKE_CURRENT_BINARY_DIR}/generated/pages.cpp")
  set(script "${CMAKE_CURRENT_FUNCTION_LIST_FILE}")
  add_custom_command(OUTPUT "${output}"
    COMMAND "${CMAKE_COMMAND}" "-DLIST=${list}" "-DSPACE=${space}" "-DHEADER=${header}" "-DOUTPUT=${output}"
      -P "${script}"
    DEPENDS ${ARGN} "${list}" "${script}"
    COMMENT "Embedding the pages of ${target}" VERBATIM)
  target_sources(${target} PRIVATE "${output}")
endfunction()

# Bytes of one literal that every compiler takes (clang refuses more than 64 KiB under -Wpedantic).
set(AXISC_PAGE_LIMIT 60000)

function(axisc_write_pages pages space header output)
  set(rows "")
  foreach(path IN LISTS pages)
    file(READ "${path}" text)
    # The heading repeats what the program knows: a rule's code and name.
    string(REGEX REPLACE "^# [^\n]*\n+" "" text "${text}")
    string(LENGTH "${text}" length)
    if(length GREATER AXISC_PAGE_LIMIT)
      message(FATAL_ERROR "${path} is longer than ${AXISC_PAGE_LIMIT} bytes")
    endif()
    set(literal "R\"axisc_page(${text})axisc_page\"")
    if(path MATCHES "/en\\.md$")
      string(APPEND rows "    {${literal}")
    else()
      string(APPEND rows ",\n     ${literal}},\n")
    endif()
  endforeach()

  file(WRITE "${output}" "// Written by cmake/EmbedPages.cmake.
#include \"${header}\"

#include <array>

namespace ${space} {
namespace {

constexpr auto pages = std::to_array<Page>({
${rows}});

}  // namespace

std::span<Page const> page_table() { return pages; }

}  // namespace ${space}
")
endfunction()

if(CMAKE_SCRIPT_MODE_FILE STREQUAL CMAKE_CURRENT_LIST_FILE)
  cmake_policy(VERSION 3.25)
  file(READ "${LIST}" pages)
  axisc_write_pages("${pages}" "${SPACE}" "${HEADER}" "${OUTPUT}")
endif()
