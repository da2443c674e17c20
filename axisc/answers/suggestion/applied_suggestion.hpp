// Writes a suggestion into the lists.
#pragma once

#include "axisc/answers/suggestion/suggested.hpp"
#include "presentation/document.hpp"

#include <cstddef>
#include <string>
#include <vector>

namespace axisc {

/// A suggestion by its number: 1, 2 and 3 are filters, 4 is Improved Position Control, 5 are ramp
/// times.
struct ChosenSuggestion {
  presentation::Document answer;  ///< which one it is, and its NC command
  ListEdits const& edits;
};

/// The number in `--apply N`; Failure for another word, and for 4 without a plant.
[[nodiscard]] std::size_t suggestion_number(std::string const& word, bool has_plant);

/// Refers to `suggested`. Failure where there is none, where the lists would have findings or cannot be
/// edited, or where one lies outside what the user named.
[[nodiscard]] ChosenSuggestion chosen_suggestion(Suggested const& suggested, std::size_t number,
                                                 std::string const& named);

/// Every list or none: what was written is taken back where a later one cannot be. What there is to say of
/// it.
[[nodiscard]] std::vector<Message> write_lists(ListEdits const& edits);
/// The same where nothing is written: that there is nothing to write.
[[nodiscard]] std::vector<Message> notes_of(ListEdits const& edits);
/// What write_lists() would change.
[[nodiscard]] std::string patch_of(ListEdits const& edits);

}  // namespace axisc
