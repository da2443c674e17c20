# What the compiler must say of each sentence in sentence_mistakes.cpp.
function(axisc_sentence_mistake number expected)
  add_test(NAME sentence_mistake_${number}
    COMMAND ${CMAKE_CXX_COMPILER} -std=c++20 -fsyntax-only -I "${PROJECT_SOURCE_DIR}" -DAXISC_MISTAKE=${number}
      "${CMAKE_CURRENT_SOURCE_DIR}/sentence_mistakes.cpp")
  if(expected)
    set_tests_properties(sentence_mistake_${number} PROPERTIES PASS_REGULAR_EXPRESSION "error:.*${expected}")
  endif()
endfunction()

axisc_sentence_mistake(0 "")
axisc_sentence_mistake(1 a_language_is_missing)
axisc_sentence_mistake(2 a_blank_begins_or_ends_the_sentence)
axisc_sentence_mistake(3 the_languages_name_different_placeholders)
axisc_sentence_mistake(4 the_languages_name_different_placeholders)
axisc_sentence_mistake(5 a_brace_belongs_to_no_placeholder)
axisc_sentence_mistake(6 a_brace_belongs_to_no_placeholder)
axisc_sentence_mistake(7 deleted)
