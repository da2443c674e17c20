// What words mean to the search, whatever their language and their form: schema/lookup/lookup.json.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <unordered_map>
#include <unordered_set>
#include <utility>
#include <vector>

namespace axisc {

/// Equal for "velocity", "speeds" and "Geschwindigkeit"; a word that no group has has one of its own. A hash
/// of 64 bits on every system, so that all find the same.
using Sense = std::uint64_t;

/// Of the very word alone, whatever it means.
[[nodiscard]] Sense sense_as_spelled(std::string_view folded_word);

/// A word that says something, or one of the parts of a composed word.
struct TellingWord {
  std::string folded;  ///< as it is written, several as one: "positionlag"
  Sense sense = 0;
  bool is_beside = false;  ///< behind a preposition: "beim Bremsen", "in a corner"
};

struct TellingWords {
  std::vector<TellingWord> words;
  bool ask_for_message = false;  ///< "alarm" is among the fillers
};

void add_once(std::vector<Sense>& senses, Sense sense);

class Vocabulary {
 public:
  Vocabulary();

  /// One sense, or those of the parts of a composed word: "Ruckbegrenzung" is "Ruck" and "Begrenzung".
  [[nodiscard]] std::vector<Sense> senses_of(std::string_view folded_word) const;
  [[nodiscard]] Sense sense_of(std::string_view folded_word) const;
  /// Of words one after the other that are known together, "position lag"; of others each its own. Without
  /// fillers and figures where anything else is left.
  [[nodiscard]] TellingWords telling_words(std::string_view text) const;

  [[nodiscard]] bool is_known(std::string_view folded_word) const { return group_of(folded_word) != nullptr; }
  /// A word of a group with a typing error or two; empty for none.
  [[nodiscard]] std::string nearest(std::string_view folded_word) const;

  [[nodiscard]] bool is_filler(std::string_view folded_word) const;
  [[nodiscard]] bool tells_fault(Sense sense) const { return faults_.contains(sense); }
  /// "reduce" says less than what is to be reduced.
  [[nodiscard]] bool is_action(Sense sense) const { return actions_.contains(sense); }
  /// "high" in "high cut" tells no fault: such words mean themselves alone but in rules and messages.
  [[nodiscard]] bool is_of_faults(Sense sense) const {
    return faults_.contains(sense) || degrees_.contains(sense);
  }

 private:
  /// Null for a word of none.
  [[nodiscard]] Sense const* group_of(std::string_view folded_word) const;
  [[nodiscard]] bool add_parts(std::vector<Sense>& senses, std::string_view composed) const;

  std::unordered_map<Sense, Sense> groups_;  ///< by their words as spelled, and by the stems of these
  std::unordered_set<Sense> beginnings_;     ///< of those that have several words
  std::vector<std::string> words_;           ///< of groups, folded
  std::unordered_set<Sense> faults_;
  std::unordered_set<Sense> degrees_;
  std::unordered_set<Sense> actions_;
  std::unordered_set<Sense> fillers_;  ///< as spelled, like the units and the words for messages
  std::unordered_set<Sense> filling_stems_;
  std::unordered_set<Sense> units_;
  std::unordered_set<Sense> prepositions_;
  std::unordered_set<Sense> for_messages_;
};

[[nodiscard]] Vocabulary const& vocabulary();

}  // namespace axisc
