#include "diagnostics/wording.hpp"

#include "diagnostics/ascii.hpp"

namespace axisc {

Wording::Wording(std::string english, std::string german)
    : text_(std::move(english)), german_(std::move(german)), differs_(text_ != german_) {}

Wording Wording::number(std::string text) {
  std::string german = text;
  for (std::size_t i = 1; i + 1 < german.size(); ++i) {
    bool const is_decimal_point =
        german[i] == '.' && ascii::is_digit(german[i - 1]) && ascii::is_digit(german[i + 1]);
    if (is_decimal_point) german[i] = ',';
  }
  return {std::move(text), std::move(german)};
}

Wording& Wording::operator+=(Wording const& more) {
  if (!differs_ && more.differs_) german_ = text_;
  differs_ = differs_ || more.differs_;
  if (differs_) german_ += more.in(Language::german);
  text_ += more.text_;
  return *this;
}

}  // namespace axisc
