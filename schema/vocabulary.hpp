// The known names taken apart, so that a mistyped one is compared with each of their words once.
#pragma once

#include "schema/catalogue.hpp"

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace axisc::schema {

/// Which letters a text has, and which at least twice: one bit each. Letters that share a bit make it less telling, not
/// wrong.
using Letters = std::uint64_t;
[[nodiscard]] Letters letters_of(std::string_view text);

/// What rules a word out before its letters are compared one by one.
struct Outline {
  explicit Outline(std::string_view word) : letters(letters_of(word)), size(word.size()) {}

  Letters letters;
  std::size_t size;
};

/// Words, and beside them their outlines in a row: of nearly all words nothing else is looked at.
struct Words {
  std::vector<std::string> texts;
  std::vector<Outline> outlines;

  void add(std::string_view word) {
    texts.emplace_back(word);
    outlines.emplace_back(word);
  }
  [[nodiscard]] std::size_t size() const { return texts.size(); }
};

struct Vocabulary {
  std::span<Parameter const> rows;
  Words parts;                                       ///< each different one
  Words names;                                       ///< without brackets, in the order of `rows`
  std::vector<std::vector<std::size_t>> parts_of;    ///< of each name: indices into `parts`
  std::vector<std::size_t> last_parts;               ///< each that is the last one of a name
  std::vector<std::vector<std::size_t>> names_with;  ///< of each part: the names that end with it
  std::vector<std::vector<std::size_t>> names_of_size;
};

[[nodiscard]] Vocabulary take_apart(std::span<Parameter const> rows);

/// Names of `vocabulary` that a mistyped one may have meant, see Catalogue::suggest_names.
[[nodiscard]] std::vector<std::string> suggest_names(Vocabulary const& vocabulary, std::string_view name);

}  // namespace axisc::schema
