#include "axisc/asked/quantities.hpp"

#include "axisc/environment/failure.hpp"
#include "axisc/environment/sentences.hpp"

#include <array>
#include <charconv>
#include <cmath>
#include <utility>

namespace axisc::says {

constexpr Sentence bad_positive{
    "{option} needs numbers above 0 in {unit}, without the unit, not \"{value}\"",
    "{option} braucht Zahlen über 0 in {unit}, ohne die Einheit, nicht \"{value}\""};

}  // namespace axisc::says

namespace axisc {

namespace {

constexpr double longest_cycle_ns = 1e9;
/// Rounding of the decimal fraction and of the product, relative.
constexpr double rounding = 1e-12;

/// Bare numbers are microseconds. A suffix comes before the shorter ones that it ends with.
constexpr std::array<std::pair<std::string_view, double>, 6> units = {
    {{"ns", 1}, {"us", 1e3}, {"\u00B5s", 1e3}, {"\u03BCs", 1e3}, {"ms", 1e6}, {"s", 1e9}}};

}  // namespace

std::optional<double> parse_number(std::string_view text) {
  if (!text.empty() && text.front() == '+') text.remove_prefix(1);
  if (!text.empty() && text.front() == '+') return std::nullopt;
  double value = 0;
  auto const* const end = text.data() + text.size();
  auto const [stop, error] = std::from_chars(text.data(), end, value);
  if (error != std::errc{} || stop != end) return std::nullopt;
  return value;
}

std::optional<double> parse_finite(std::string_view text) {
  auto const value = parse_number(text);
  return value && std::isfinite(*value) ? value : std::nullopt;
}

double positive_number(std::string const& option, std::string const& word, std::string const& unit) {
  auto const value = parse_finite(word);
  if (value && *value > 0) return *value;
  throw Failure({says::bad_positive, {{"option", option}, {"unit", unit}, {"value", word}}});
}

std::uint64_t positive_count(std::string const& option, std::string const& word, std::uint64_t most) {
  auto const value = parse_count(word);
  if (value && *value > 0 && *value <= most) return *value;
  throw Failure({says::bad_count, {{"option", option}, {"value", word}}});
}

std::optional<std::uint64_t> parse_count(std::string_view text) {
  std::uint64_t value = 0;
  auto const* const end = text.data() + text.size();
  auto const [stop, error] = std::from_chars(text.data(), end, value);
  if (error != std::errc{} || stop != end) return std::nullopt;
  return value;
}

std::optional<design::CycleTime> parse_cycle_time(std::string_view text) {
  double scale = 1e3;
  for (auto const& [unit, nanoseconds] : units) {
    if (text.size() > unit.size() && text.substr(text.size() - unit.size()) == unit) {
      scale = nanoseconds;
      text.remove_suffix(unit.size());
      break;
    }
  }
  while (!text.empty() && text.back() == ' ') text.remove_suffix(1);
  auto const number = parse_finite(text);
  if (!number) return std::nullopt;
  double const nanoseconds = *number * scale;
  double const whole = std::round(nanoseconds);
  if (!(whole >= 1) || whole > longest_cycle_ns) return std::nullopt;
  if (std::abs(nanoseconds - whole) > rounding * whole) return std::nullopt;
  return design::CycleTime{static_cast<std::uint32_t>(whole)};
}

std::optional<Assigned> parse_assigned(std::string const& text) {
  auto const sign = text.find('=');
  if (sign == std::string::npos || sign == 0 || sign + 1 == text.size()) return std::nullopt;
  return Assigned{.name = text.substr(0, sign), .value = text.substr(sign + 1)};
}

std::vector<std::string> split_list(std::string_view text, char separator) {
  std::vector<std::string> parts;
  while (!text.empty()) {
    auto const comma = std::min(text.find(separator), text.size());
    auto part = text.substr(0, comma);
    text.remove_prefix(std::min(comma + 1, text.size()));
    while (!part.empty() && part.front() == ' ') part.remove_prefix(1);
    while (!part.empty() && part.back() == ' ') part.remove_suffix(1);
    if (!part.empty()) parts.emplace_back(part);
  }
  return parts;
}

}  // namespace axisc
