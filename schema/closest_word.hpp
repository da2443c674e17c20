// "Did you mean" among a handful of words.
#pragma once

#include <span>
#include <string_view>

namespace axisc::schema {

/// The word that `written` most likely was meant to be: within tolerable_distance(), letter case aside, and
/// not changed in every letter. Empty where none is near. The first of equally near words wins.
[[nodiscard]] std::string_view closest_word(std::string_view written,
                                            std::span<std::string_view const> words);

}  // namespace axisc::schema
