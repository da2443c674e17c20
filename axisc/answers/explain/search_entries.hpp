// Everything that can be looked up, with the words by which it is found.
#pragma once

#include "axisc/answers/explain/search.hpp"

#include <span>
#include <string>
#include <vector>

namespace axisc {

struct Phrase {
  std::string folded;
  std::string written;
  bool is_common = false;  ///< see `common_phrase`
};

struct SearchEntry {
  Subject subject;
  std::string name;                        ///< in lower case
  std::vector<Phrase> phrases;             ///< its name, its title, and words that people use for it
  std::vector<Phrase> name_parts;          ///< between the points of a parameter's name
  std::vector<std::string> name_words;     ///< of all these
  std::vector<std::string> meaning_words;  ///< of its description in both languages
};

/// In the order in which equally good hits are shown.
[[nodiscard]] std::vector<SearchEntry> search_entries(std::span<schema::Catalogue const> catalogues);

}  // namespace axisc
