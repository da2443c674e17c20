// A text that may differ between the languages: a number with its decimal sign, a name that has a
// translation.
#pragma once

#include "diagnostics/sentence.hpp"

#include <string>
#include <string_view>
#include <utility>

namespace axisc {

class Wording {
 public:
  Wording() = default;
  // Not explicit: most texts are the same in both languages.
  Wording(std::string text) : text_(std::move(text)) {}
  Wording(std::string_view text) : text_(text) {}
  Wording(char const* text) : text_(text) {}
  Wording(std::string english, std::string german);

  /// A number with a decimal point, perhaps with its unit or in a range: "0.5 mm", "0 < f < 0.5/T". German
  /// readers see a decimal comma.
  [[nodiscard]] static Wording number(std::string text);

  [[nodiscard]] std::string const& in(Language language) const {
    return language == Language::german && differs_ ? german_ : text_;
  }
  /// As lists and other files have it: with a decimal point.
  [[nodiscard]] std::string const& written() const { return text_; }
  [[nodiscard]] bool empty() const { return text_.empty(); }

  Wording& operator+=(Wording const& more);
  friend Wording operator+(Wording one, Wording const& other) { return std::move(one += other); }
  /// Compares the written texts.
  friend bool operator==(Wording const& one, std::string_view written) { return one.text_ == written; }

 private:
  std::string text_;
  std::string german_;  ///< where it differs
  bool differs_ = false;
};

}  // namespace axisc
