// What somebody looks for, as the search compares it.
#pragma once

#include "axisc/answers/explain/search_entries.hpp"

#include <string>
#include <string_view>
#include <vector>

namespace axisc {

struct SearchQuery {
  std::string written;                   ///< in lower case, without blanks around it
  std::string complete;                  ///< folded
  std::string whole;                     ///< folded, without fillers
  std::vector<TellingWord> words;        ///< each sense once
  std::vector<Sense> senses;             ///< of these
  std::vector<std::string> identifiers;  ///< words with `_` among others, folded
  bool is_path = false;                  ///< a name with its parts, as lists write it
  bool is_mended = false;                ///< a word was mistyped, and another taken for it
  bool tells_fault = false;
  bool asks_for_message = false;

  [[nodiscard]] bool is(std::string const& text) const { return text == whole || text == complete; }
};

/// A word that neither a group nor an entry has is taken for the one that it is mistyped from.
[[nodiscard]] SearchQuery search_query(std::string_view text, std::vector<EntryWord> const& known);

}  // namespace axisc
