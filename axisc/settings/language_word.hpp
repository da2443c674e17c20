// Languages, as options and settings name them.
#pragma once

#include "diagnostics/message.hpp"

#include <optional>
#include <string_view>

namespace axisc {

/// "en" or "de"; none for another word.
[[nodiscard]] constexpr std::optional<Language> parse_language(std::string_view word) {
  if (word == "en") return Language::english;
  if (word == "de") return Language::german;
  return std::nullopt;
}

}  // namespace axisc
