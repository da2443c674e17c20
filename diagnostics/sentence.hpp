// A sentence the program can print, in English and German: a constant next to the code that uses it.
//
//     namespace axisc::validator::says {
//     constexpr Sentence limit{"the delay must be shorter than {limit}",
//                              "die Verzögerung muss kürzer als {limit} sein"};
//     }
//     … finding.notes.push_back({says::limit, {{"limit", microseconds(limit)}}});
//
// `{limit}` is a placeholder that a Message (message.hpp) fills; braces mean nothing else. Sentences that
// several sources of a folder share are declared in the folder's sentences.hpp and defined in its
// sentences.cpp. A sentence that would be wrong in either language does not compile.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>

namespace axisc {

enum class Language : std::uint8_t { english, german };

namespace sentence_errors {

// Never called: their names appear in the compiler's message if a sentence is wrong.
void a_language_is_missing();
void a_blank_begins_or_ends_the_sentence();
void a_brace_belongs_to_no_placeholder();
void the_languages_name_different_placeholders();

}  // namespace sentence_errors

class Sentence {
 public:
  /// Two string literals. Refused by the compiler: an empty one, blanks around it, a brace that is not part
  /// of a placeholder ({lower_case_1}), and placeholders that only one language names.
  consteval Sentence(std::string_view english, std::string_view german) : english_(english), german_(german) {
    check(english, german);
    check(german, english);
  }
  // A sentence is known by its address.
  Sentence(Sentence const&) = delete;
  Sentence& operator=(Sentence const&) = delete;
  ~Sentence() = default;

  /// The text in a language, with its placeholders.
  [[nodiscard]] constexpr std::string_view in(Language language) const {
    return language == Language::german ? german_ : english_;
  }

 private:
  static consteval void check(std::string_view text, std::string_view other) {
    if (text.empty()) sentence_errors::a_language_is_missing();
    if (text.front() == ' ' || text.back() == ' ') sentence_errors::a_blank_begins_or_ends_the_sentence();
    for (std::size_t open = text.find_first_of("{}"); open != std::string_view::npos;
         open = text.find_first_of("{}", open)) {
      std::size_t const close = text.find_first_not_of("abcdefghijklmnopqrstuvwxyz0123456789_", open + 1);
      if (text[open] == '}' || close == std::string_view::npos || text[close] != '}' || close == open + 1) {
        sentence_errors::a_brace_belongs_to_no_placeholder();
      }
      std::string_view const placeholder = text.substr(open, close + 1 - open);
      if (other.find(placeholder) == std::string_view::npos) {
        sentence_errors::the_languages_name_different_placeholders();
      }
      open = close + 1;
    }
  }

  std::string_view english_;
  std::string_view german_;
};

/// A copyable reference to a sentence. Sentences are constants, so it is always valid.
class SentenceRef {
 public:
  // Not explicit: callers name the constant itself.
  constexpr SentenceRef(Sentence const& sentence) : sentence_(&sentence) {}
  SentenceRef(Sentence const&&) = delete;

  [[nodiscard]] constexpr std::string_view in(Language language) const { return sentence_->in(language); }
  /// True for the same constant, whatever its text.
  friend constexpr bool operator==(SentenceRef, SentenceRef) = default;

 private:
  Sentence const* sentence_;
};

}  // namespace axisc
