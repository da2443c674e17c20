# Pages in English and German as constants of the program.
#
#   axisc_embed_pages(target namespace header PAGE...)
#       defines `std::span<Page const> page_table()` of the namespace, which the header declares. The paths
#       alternate: en.md, then de.md of the same page. A heading in the first line is no part of the page; if
#       the first one has it, all must, and `page_title_table()` is defined as well.
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
  set(titles "")
  foreach(path IN LISTS pages)
    file(READ "${path}" text)
    set(title "")
    if(text MATCHES "^# ([^\n]*)\n")
      set(title "${CMAKE_MATCH_1}")
      string(REGEX REPLACE "^# [^\n]*\n+" "" text "${text}")
    endif()
    if(NOT rows STREQUAL "" AND ((title STREQUAL "" AND NOT titles STREQUAL "") OR (NOT title STREQUAL "" AND titles STREQUAL "")))
      message(FATAL_ERROR "${path}: its first line must be a heading like those of the other pages: # Title")
    endif()
    string(LENGTH "${text}" length)
    if(length GREATER AXISC_PAGE_LIMIT)
      message(FATAL_ERROR "${path} is longer than ${AXISC_PAGE_LIMIT} bytes")
    endif()
    set(literal "R\"axisc_page(${text})axisc_page\"")
    if(path MATCHES "/en\\.md$")
      string(APPEND rows "    {${literal}")
      set(begin "    {")
      set(end "")
    else()
      string(APPEND rows ",\n     ${literal}},\n")
      set(begin ", ")
      set(end "},\n")
    endif()
    if(NOT title STREQUAL "")
      string(APPEND titles "${begin}R\"axisc_page(${title})axisc_page\"${end}")
    endif()
  endforeach()
  set(title_array "")
  set(title_function "")
  if(NOT titles STREQUAL "")
    set(title_array "
constexpr auto titles = std::to_array<Page>({
${titles}});
")
    set(title_function "
std::span<Page const> page_title_table() { return titles; }
")
  endif()

  file(WRITE "${output}" "// Written by cmake/EmbedPages.cmake.
#include \"${header}\"

#include <array>

namespace ${space} {
namespace {

constexpr auto pages = std::to_array<Page>({
${rows}});
${title_array}
}  // namespace

std::span<Page const> page_table() { return pages; }
${title_function}
}  // namespace ${space}
")
endfunction()

if(CMAKE_SCRIPT_MODE_FILE STREQUAL CMAKE_CURRENT_LIST_FILE)
  cmake_policy(VERSION 3.25)
  file(READ "${LIST}" pages)
  axisc_write_pages("${pages}" "${SPACE}" "${HEADER}" "${OUTPUT}")
endif()
