// Everything that can be looked up, with the words by which it is found.
#pragma once

#include "axisc/answers/explain/search.hpp"
#include "axisc/answers/explain/search_vocabulary.hpp"

#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace axisc {

struct Phrase {
  std::string folded;
  std::string written;
  std::vector<Sense> senses;      ///< of its telling words, each once
  bool asks_for_message = false;  ///< "following error alarm": of a message alone
};

/// A word that entries have; they refer to it by its place, so that it is compared with a query once.
struct EntryWord {
  std::string folded;
  std::vector<Sense> senses = {};
  bool is_known = false;  ///< to the vocabulary
};
using WordPlaces = std::vector<std::uint32_t>;

struct SearchEntry {
  Subject subject;
  std::string name;                     ///< in lower case
  bool is_about_fault = false;          ///< a rule or a message
  std::vector<Phrase> phrases = {};     ///< its name, its title, and words that people use for it
  std::vector<Phrase> name_parts = {};  ///< between the points of a parameter's name
  WordPlaces name_words = {};           ///< of all these
  WordPlaces meaning_words = {};        ///< of its description in both languages
};

struct SearchEntries {
  std::vector<SearchEntry> entries;  ///< in the order in which equally good hits are shown
  std::vector<EntryWord> words;
};

[[nodiscard]] SearchEntries search_entries(std::span<schema::Catalogue const> catalogues);

}  // namespace axisc
