// Finds what a person means by a few words: parameters, rules, messages of the control, words of NC programs
// and topics, by their names, by the words that people use for them (schema/lookup/lookup.json), and by their
// meanings in both languages.
#pragma once

#include "schema/catalogue.hpp"
#include "schema/lookup/lookup.hpp"
#include "schema/motion_words.hpp"
#include "validator/engine/rule.hpp"

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace axisc {

using Subject = std::variant<validator::Rule const*, schema::Parameter const*, schema::MotionWord const*,
                             schema::ControlMessage const*, schema::Topic const*>;

/// Why something was found, the best reason first.
enum class Likeness : std::uint8_t {
  exact,         ///< the query is its name, or words that people use for it
  part_of_name,  ///< its name contains the query
  slip,          ///< as exact, or a part of its name, with a typing error or two
  words,         ///< every word of the query is in its name, in people's words for it, or in its meaning; or
                 ///< the query contains its name or people's words for it
  some_words,    ///< at least half of the words are there, and nothing has more
};

struct SearchEntries;

struct Hit {
  Subject subject;
  Likeness likeness = Likeness::exact;
  std::size_t points = 0;  ///< among hits of one likeness
  std::string read_as;     ///< for a slip: what was meant
  bool is_named = true;    ///< not only its meaning has words of the query
};

/// Best first: by likeness, then points, then in the order of `Subject` with what lists set first; each
/// subject once. `some_words` appears alone. The first catalogue is that of axis lists. Cost: some ten
/// milliseconds.
[[nodiscard]] std::vector<Hit> search(std::span<schema::Catalogue const> catalogues, std::string_view text);
/// The same in entries that were made before: see search_entries.hpp.
[[nodiscard]] std::vector<Hit> search(SearchEntries const& all, std::string_view text);

/// True if the first hit is the only good one: the only exact one, or, without exact ones, the only one whose
/// name contains the query, or the only one that is nearest, or the only one at all if a word names it.
[[nodiscard]] bool is_answer(std::span<Hit const> hits);

}  // namespace axisc
