// A page in both languages: that of a code (its meaning and the remedy, for `axisc explain`, docs/rules.md
// and SARIF), or that of a command.
#pragma once

#include "diagnostics/message.hpp"

#include <string_view>

namespace axisc {

struct Page {
  std::string_view english;  ///< Markdown without a heading; empty where there is no page
  std::string_view german;

  [[nodiscard]] constexpr std::string_view in(Language language) const {
    return language == Language::german ? german : english;
  }
  explicit operator Wording() const { return {std::string(english), std::string(german)}; }
};

}  // namespace axisc
