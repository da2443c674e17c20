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

struct Word {
  explicit Word(std::string_view word) : text(word), letters(letters_of(word)) {}

  std::string text;
  Letters letters;
};

struct KnownName {
  Word bare;
  std::size_t last_part = 0;       ///< index into Vocabulary::parts
  std::vector<std::size_t> parts;  ///< the same for all parts
};

struct Vocabulary {
  std::span<Parameter const> rows;
  std::vector<Word> parts;       ///< each different one
  std::vector<KnownName> names;  ///< in the order of `rows`
};

[[nodiscard]] Vocabulary take_apart(std::span<Parameter const> rows);

/// Names of `vocabulary` that a mistyped one may have meant, see Catalogue::suggest_names.
[[nodiscard]] std::vector<std::string> suggest_names(Vocabulary const& vocabulary, std::string_view name);

}  // namespace axisc::schema
