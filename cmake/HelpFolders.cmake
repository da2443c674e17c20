# Every folder cli/help/COMMAND is the help of a command, in en.md and de.md; cli/help/axisc is that of the
# program. Nothing else lists them.
#
#   axisc_add_help(target)    adds the pages to the target, with the list of their folders; both are written
#                             again when a page changes, comes or goes

include(EmbedPages)

function(axisc_add_help target)
  set(folder "${PROJECT_SOURCE_DIR}/cli/help")
  file(GLOB names CONFIGURE_DEPENDS RELATIVE "${folder}" "${folder}/*/en.md" "${folder}/*/de.md")
  list(TRANSFORM names REPLACE "/[^/]*$" "")
  list(REMOVE_DUPLICATES names)

  set(pages "")
  set(rows "")
  foreach(name IN LISTS names)
    foreach(file en.md de.md)
      if(NOT EXISTS "${folder}/${name}/${file}")
        message(FATAL_ERROR "cli/help/${name}: ${file} is missing")
      endif()
      list(APPEND pages "${folder}/${name}/${file}")
    endforeach()
    string(APPEND rows "    \"${name}\",\n")
  endforeach()

  file(CONFIGURE OUTPUT "${CMAKE_CURRENT_BINARY_DIR}/generated/help_folders.hpp" CONTENT "\
// Written by cmake/HelpFolders.cmake from the folders of cli/help.
#pragma once

#include <array>
#include <string_view>

namespace axisc::cli {

inline constexpr auto help_folders = std::to_array<std::string_view>({
${rows}});

}  // namespace axisc::cli
" @ONLY)
  target_include_directories(${target} PRIVATE "${CMAKE_CURRENT_BINARY_DIR}/generated")
  axisc_embed_pages(${target} axisc::cli "cli/help/help_page.hpp" ${pages})
endfunction()
