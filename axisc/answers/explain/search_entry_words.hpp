// The words of all entries, each once.
#pragma once

#include "axisc/answers/explain/search_entries.hpp"

#include <functional>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

namespace axisc {

class EntryWords {
 public:
  EntryWords();

  void add_meaning(WordPlaces& places, std::string_view text);
  void add_name(WordPlaces& places, std::string_view text);
  void add_word_of_name(WordPlaces& places, std::string_view word);

  [[nodiscard]] std::vector<EntryWord> take() &&;

 private:
  struct Hash {
    using is_transparent = void;
    std::size_t operator()(std::string_view text) const { return std::hash<std::string_view>()(text); }
  };

  std::uint32_t place_of(std::string_view written);

  std::vector<EntryWord> words_;
  std::vector<bool> is_of_a_name_;
  /// As they are written and folded: most words are written in few ways, and folding each costs more.
  std::unordered_map<std::string, std::uint32_t, Hash, std::equal_to<>> places_;
};

}  // namespace axisc
