// What somebody looks for, as the search compares it.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace axisc {

struct SearchQuery {
  std::string written;   ///< in lower case, without blanks around it
  std::string complete;  ///< folded
  std::string whole;     ///< folded, without fillers
  std::string common;    ///< see `common_phrase`; empty for one word, which may be a name
  std::vector<std::string> words;
  std::vector<std::string> common_words;  ///< of each of these
  std::vector<std::string> identifiers;   ///< words with `_` among others, folded
  bool tells_fault = false;
  bool asks_for_message = false;

  [[nodiscard]] bool is(std::string const& text) const { return text == whole || text == complete; }
};

[[nodiscard]] SearchQuery search_query(std::string_view text);

}  // namespace axisc
