# Turns diagnostics/text/pages/<language>/AXNNNN.md into one source file with a table of raw string literals.
#
#   axisc_embed_pages(target)    adds that source to the target; it is written again when a page changes, comes or goes
#
# The same file, run as a script, writes the source: cmake -DLIST=… -DOUTPUT=… -P EmbedPages.cmake

function(axisc_embed_pages target)
  set(folder "${PROJECT_SOURCE_DIR}/diagnostics/text/pages")
  file(GLOB pages CONFIGURE_DEPENDS "${folder}/en/AX[0-9][0-9][0-9][0-9].md" "${folder}/de/AX[0-9][0-9][0-9][0-9].md")
  # The list is a file of its own so that a page that is taken away is noticed like one that changes.
  set(list "${CMAKE_CURRENT_BINARY_DIR}/pages.list")
  file(CONFIGURE OUTPUT "${list}" CONTENT "${pages}")
  set(output "${CMAKE_CURRENT_BINARY_DIR}/pages.generated.cpp")
  set(script "${PROJECT_SOURCE_DIR}/cmake/EmbedPages.cmake")
  add_custom_command(OUTPUT "${output}"
    COMMAND "${CMAKE_COMMAND}" "-DLIST=${list}" "-DOUTPUT=${output}" -P "${script}"
    DEPENDS ${pages} "${list}" "${script}"
    COMMENT "Embedding the pages behind the codes" VERBATIM)
  target_sources(${target} PRIVATE "${output}")
endfunction()

# Bytes of one literal that every compiler takes (clang refuses more than 64 KiB under -Wpedantic).
set(AXISC_PAGE_LIMIT 60000)

function(axisc_write_pages pages output)
  set(names "")
  foreach(path IN LISTS pages)
    get_filename_component(code "${path}" NAME_WE)
    list(APPEND names "${code}")
  endforeach()
  list(REMOVE_DUPLICATES names)
  list(SORT names)

  set(rows "")
  set(count 0)
  foreach(code IN LISTS names)
    string(REGEX REPLACE "^AX0*" "" number "${code}")
    set(row "    {Code{${number}}")
    foreach(language en de)
      set(text "")
      foreach(path IN LISTS pages)
        if(path MATCHES "/${language}/${code}\\.md$")
          file(READ "${path}" text)
        endif()
      endforeach()
      # The heading is the code and its name, which the table of rules knows.
      string(REGEX REPLACE "^# [^\n]*\n+" "" text "${text}")
      string(LENGTH "${text}" length)
      if(length GREATER AXISC_PAGE_LIMIT)
        message(FATAL_ERROR "the page ${language}/${code}.md is longer than ${AXISC_PAGE_LIMIT} bytes")
      endif()
      string(APPEND row ",\n     R\"axisc_page(${text})axisc_page\"")
    endforeach()
    string(APPEND rows "${row}},\n")
    math(EXPR count "${count} + 1")
  endforeach()

  file(WRITE "${output}" "// Written by cmake/EmbedPages.cmake from diagnostics/text/pages.
#include \"diagnostics/page_table.hpp\"

#include <array>
#include <span>

namespace axisc {
namespace {

constexpr std::array<PageTexts, ${count}> pages{{
${rows}}};

}  // namespace

std::span<PageTexts const> page_table() { return pages; }

}  // namespace axisc
")
endfunction()

if(CMAKE_SCRIPT_MODE_FILE STREQUAL CMAKE_CURRENT_LIST_FILE)
  cmake_policy(VERSION 3.25)
  file(READ "${LIST}" pages)
  axisc_write_pages("${pages}" "${OUTPUT}")
endif()
