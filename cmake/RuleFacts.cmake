# The facts.json of rules as constants of the program.
#
#   axisc_embed_rule_facts(target FACTS...)
#       defines `std::span<RuleFacts const> facts_table()` of the namespace axisc::validator, in the order of
#       the files. The build fails where one lacks its version, a source or a language.
#
# The same file, run as a script, writes the source:
#   cmake -DLIST=… -DOUTPUT=… -P RuleFacts.cmake

function(axisc_embed_rule_facts target)
  # The list is a file of its own so that a removed rule is noticed like a changed one.
  set(list "${CMAKE_CURRENT_BINARY_DIR}/facts.list")
  file(CONFIGURE OUTPUT "${list}" CONTENT "${ARGN}")
  set(output "${CMAKE_CURRENT_BINARY_DIR}/generated/rule_facts.cpp")
  set(script "${CMAKE_CURRENT_FUNCTION_LIST_FILE}")
  add_custom_command(OUTPUT "${output}"
    COMMAND "${CMAKE_COMMAND}" "-DLIST=${list}" "-DOUTPUT=${output}" -P "${script}"
    DEPENDS ${ARGN} "${list}" "${script}"
    COMMENT "Embedding the facts of ${target}" VERBATIM)
  target_sources(${target} PRIVATE "${output}")
endfunction()

# {"en": …, "de": …} as a Page; an empty one where the key is missing.
function(axisc_fact_in_both_languages path json key result)
  string(JSON type ERROR_VARIABLE missing TYPE "${json}" "${key}")
  set(page "")
  if(missing STREQUAL "NOTFOUND")
    foreach(language en de)
      string(JSON text ERROR_VARIABLE missing GET "${json}" "${key}" "${language}")
      if(NOT missing STREQUAL "NOTFOUND" OR text STREQUAL "")
        message(FATAL_ERROR "${path}: \"${key}\" has no text in the language ${language}")
      endif()
      string(APPEND page "R\"axisc_fact(${text})axisc_fact\", ")
    endforeach()
  endif()
  set(${result} "{${page}}" PARENT_SCOPE)
endfunction()

# An array of strings as a constant of this name, if it has any; the name, or {} for an empty one.
function(axisc_fact_names json key name declaration result)
  string(JSON count LENGTH "${json}" "${key}")
  set(names "")
  set(used "{}")
  set(text "")
  if(count GREATER 0)
    math(EXPR last "${count} - 1")
    foreach(i RANGE ${last})
      string(JSON one GET "${json}" "${key}" ${i})
      string(APPEND names "\"${one}\", ")
    endforeach()
    set(text "constexpr std::array<std::string_view, ${count}> ${name}{${names}};\n")
    set(used "${name}")
  endif()
  set(${declaration} "${text}" PARENT_SCOPE)
  set(${result} "${used}" PARENT_SCOPE)
endfunction()

function(axisc_write_rule_facts files output)
  set(arrays "")
  set(rows "")
  foreach(path IN LISTS files)
    file(READ "${path}" json)
    string(REGEX MATCH "AX[0-9]+" code "${path}")
    string(JSON since GET "${json}" since)
    axisc_fact_names("${json}" symptoms "symptoms_of_${code}" symptoms_array symptoms)
    axisc_fact_names("${json}" sources "sources_of_${code}" sources_array sources)
    foreach(key reading own exceptions)
      axisc_fact_in_both_languages("${path}" "${json}" ${key} ${key})
    endforeach()
    if(sources STREQUAL "{}" AND own STREQUAL "{}")
      message(FATAL_ERROR "${path}: it has neither \"sources\" nor \"own\", the reason for a rule without any")
    endif()
    string(APPEND arrays "${symptoms_array}${sources_array}")
    string(APPEND rows "    {\"${since}\", ${symptoms}, ${sources}, ${reading}, ${own}, ${exceptions}},\n")
  endforeach()

  file(WRITE "${output}" "// Written by cmake/RuleFacts.cmake.
#include \"validator/rules/page_table.hpp\"

#include <array>

namespace axisc::validator {
namespace {

${arrays}
constexpr auto facts_of_rules = std::to_array<RuleFacts>({
${rows}});

}  // namespace

std::span<RuleFacts const> facts_table() { return facts_of_rules; }

}  // namespace axisc::validator
")
endfunction()

if(CMAKE_SCRIPT_MODE_FILE STREQUAL CMAKE_CURRENT_LIST_FILE)
  cmake_policy(VERSION 3.25)
  file(READ "${LIST}" files)
  axisc_write_rule_facts("${files}" "${OUTPUT}")
endif()
