// "Did you mean": the known word that a mistyped one comes closest to.
#pragma once

#include <span>
#include <string>
#include <string_view>

namespace axisc::cli {

/// Edits (insert, remove, replace, swap neighbours) that turn one word into the other, letter case aside.
[[nodiscard]] std::size_t edit_distance(std::string_view left, std::string_view right);

/// The closest of `known`; empty when none is close (more than a third of the word would change).
[[nodiscard]] std::string_view closest(std::string_view word, std::span<std::string_view const> known);

}  // namespace axisc::cli
