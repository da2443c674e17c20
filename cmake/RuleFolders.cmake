# Every folder validator/rules/AXNNNN-name is a rule: rule.cpp with its row and check, its pages en.md and
# de.md, its facts.json, and the samples that the tests run. Nothing else lists the rules.
#
#   axisc_add_rules(target)    adds the rules to the target, with the tables of their rows, pages and facts;
#                              all are written again when a folder changes, comes or goes

include(EmbedPages)
include(RuleFacts)

function(axisc_add_rules target)
  set(folder "${PROJECT_SOURCE_DIR}/validator/rules")
  # GLOB sorts, so that everything below is in the order of the codes.
  file(GLOB files CONFIGURE_DEPENDS RELATIVE "${folder}" "${folder}/AX*/rule.cpp" "${folder}/AX*/en.md" "${folder}/AX*/de.md" "${folder}/AX*/facts.json")
  set(rules ${files})
  list(TRANSFORM rules REPLACE "/[^/]*$" "")
  list(REMOVE_DUPLICATES rules)

  set(subjects "")
  set(declarations "")
  set(rows "")
  set(pages "")
  set(facts "")
  set(codes "")
  foreach(rule IN LISTS rules)
    if(NOT rule MATCHES "^AX([1-9][0-9][0-9][0-9])-([a-z0-9-]+)$")
      message(FATAL_ERROR "validator/rules/${rule}: a rule's folder is called AXNNNN-name")
    endif()
    set(code ${CMAKE_MATCH_1})
    set(name ${CMAKE_MATCH_2})
    if(code IN_LIST codes)
      message(FATAL_ERROR "validator/rules/${rule}: another folder has this code")
    endif()
    list(APPEND codes ${code})
    foreach(file rule.cpp en.md de.md facts.json)
      if(NOT EXISTS "${folder}/${rule}/${file}")
        message(FATAL_ERROR "validator/rules/${rule}: ${file} is missing")
      endif()
    endforeach()
    string(SUBSTRING ${code} 0 1 subject)
    list(APPEND subjects ${subject})
    list(APPEND sources_${subject} "rules/${rule}/rule.cpp")
    list(APPEND pages "${folder}/${rule}/en.md" "${folder}/${rule}/de.md")
    list(APPEND facts "${folder}/${rule}/facts.json")
    string(APPEND declarations "namespace ax${code} { extern Rule const rule; }\n")
    string(APPEND rows "    {Code{${code}}, \"${name}\", &checks::ax${code}::rule},\n")
  endforeach()
  # The rules of one subject come together, so that a new rule moves few others.
  list(REMOVE_DUPLICATES subjects)
  foreach(subject IN LISTS subjects)
    if(AXISC_BATCHES)
      axisc_batches(sources_${subject} validator_rules_AX${subject})
    endif()
    target_sources(${target} PRIVATE ${sources_${subject}})
  endforeach()

  file(CONFIGURE OUTPUT "${CMAKE_CURRENT_BINARY_DIR}/generated/rule_folders.hpp" CONTENT "\
// Written by cmake/RuleFolders.cmake from the folders of validator/rules.
#pragma once

#include \"validator/engine/rule.hpp\"

#include <array>

namespace axisc::validator::checks {

${declarations}
}  // namespace axisc::validator::checks

namespace axisc::validator {

struct RuleFolder {
  Code code{};
  std::string_view name;
  Rule const* row;
};

inline constexpr auto rule_folders = std::to_array<RuleFolder>({
${rows}});

}  // namespace axisc::validator
" @ONLY)
  target_include_directories(${target} PRIVATE "${CMAKE_CURRENT_BINARY_DIR}/generated")

  axisc_embed_pages(${target} axisc::validator "validator/rules/page_table.hpp" ${pages})
  axisc_embed_rule_facts(${target} ${facts})
endfunction()
