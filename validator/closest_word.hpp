// "Did you mean" among a handful of words.
#pragma once

#include <string_view>
#include <vector>

namespace axisc::validator {

[[nodiscard]] bool equal_ignoring_case(std::string_view a, std::string_view b);

/// The word that `written` most likely was meant to be; empty where none is near: more than a third of its letters,
/// and more than one, would have to change. Letter case does not count. The first of equally near words wins.
[[nodiscard]] std::string_view closest_word(std::string_view written,
                                            std::vector<std::string_view> const& words);

}  // namespace axisc::validator
