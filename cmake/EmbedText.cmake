# Files as constants of the program.
#
#   axisc_embed_text(target namespace NAME=FILE...)    adds generated/embedded.hpp with `std::string_view NAME();`
#                                                      and all of them by name, `embedded_texts`
#
# The same file, run as a script, writes the sources:
#   cmake -DSPACE=… -DFOLDER=… -DENTRIES=… -P EmbedText.cmake

function(axisc_embed_text target space)
  set(entries ${ARGN})
  set(files "")
  foreach(entry IN LISTS entries)
    string(REGEX REPLACE "^[^=]*=" "" file "${entry}")
    list(APPEND files "${file}")
  endforeach()
  set(folder "${CMAKE_CURRENT_BINARY_DIR}/generated")
  add_custom_command(OUTPUT "${folder}/embedded.cpp" "${folder}/embedded.hpp"
    COMMAND "${CMAKE_COMMAND}" "-DSPACE=${space}" "-DFOLDER=${folder}" "-DENTRIES=${entries}" -P "${CMAKE_CURRENT_FUNCTION_LIST_FILE}"
    DEPENDS ${files} "${CMAKE_CURRENT_FUNCTION_LIST_FILE}"
    COMMENT "Embedding texts" VERBATIM)
  target_sources(${target} PRIVATE "${folder}/embedded.cpp" "${folder}/embedded.hpp")
  target_include_directories(${target} PRIVATE "${folder}")
endfunction()

if(CMAKE_SCRIPT_MODE_FILE)
  set(declarations "")
  set(definitions "")
  set(rows "")
  foreach(entry IN LISTS ENTRIES)
    string(REGEX REPLACE "=.*" "" name "${entry}")
    string(REGEX REPLACE "^[^=]*=" "" file "${entry}")
    file(READ "${file}" text)
    string(APPEND declarations "[[nodiscard]] std::string_view ${name}();\n")
    string(APPEND rows "    EmbeddedText{\"${name}\", ${name}},\n")
    string(APPEND definitions "std::string_view ${name}() {\n  return R\"axisc_text(${text})axisc_text\";\n}\n")
  endforeach()
  file(WRITE "${FOLDER}/embedded.hpp" "// Written by cmake/EmbedText.cmake.
#pragma once

#include <array>
#include <string_view>

namespace ${SPACE} {

${declarations}
struct EmbeddedText {
  std::string_view name;
  std::string_view (*text)();
};

inline constexpr auto embedded_texts = std::to_array<EmbeddedText>({
${rows}});

}  // namespace ${SPACE}
")
  file(WRITE "${FOLDER}/embedded.cpp" "// Written by cmake/EmbedText.cmake.
#include \"embedded.hpp\"

namespace ${SPACE} {

${definitions}
}  // namespace ${SPACE}
")
endif()
