#include "validator/views/written_unit.hpp"

#include "diagnostics/ascii.hpp"
#include "diagnostics/format_number.hpp"
#include "schema/value.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

namespace axisc::validator {
namespace {

enum class Quantity : std::uint8_t {
  time,
  frequency,
  length,
  angle,
  velocity,
  angular_velocity,
  acceleration,
  angular_acceleration,
  jerk,
  angular_jerk,
  force,
  torque,
  ratio,
};

struct WrittenUnit {
  std::string_view text;
  Quantity quantity{};
  double factor = 1;  ///< to s, Hz, m, ° and units composed of them
  /// Nobody means siemens, megaseconds or megametres. `S` and `Min` are other words.
  bool any_case = true;
};

constexpr double minute = 60;
constexpr double revolution = 360;

constexpr WrittenUnit written_units[] = {
    {.text = "s", .quantity = Quantity::time, .factor = 1, .any_case = false},
    {.text = "ms", .quantity = Quantity::time, .factor = 1e-3},
    {.text = "us", .quantity = Quantity::time, .factor = 1e-6},
    {.text = "min", .quantity = Quantity::time, .factor = minute, .any_case = false},
    {.text = "Hz", .quantity = Quantity::frequency, .factor = 1},
    {.text = "mHz", .quantity = Quantity::frequency, .factor = 1e-3},
    {.text = "kHz", .quantity = Quantity::frequency, .factor = 1e3},
    {.text = "MHz", .quantity = Quantity::frequency, .factor = 1e6},
    {.text = "m", .quantity = Quantity::length, .factor = 1, .any_case = false},
    {.text = "mm", .quantity = Quantity::length, .factor = 1e-3},
    {.text = "um", .quantity = Quantity::length, .factor = 1e-6},
    {.text = "nm", .quantity = Quantity::length, .factor = 1e-9},
    {.text = "deg", .quantity = Quantity::angle, .factor = 1},
    {.text = "mdeg", .quantity = Quantity::angle, .factor = 1e-3},
    {.text = "rad", .quantity = Quantity::angle, .factor = revolution / (2 * std::numbers::pi)},
    {.text = "m/s", .quantity = Quantity::velocity, .factor = 1},
    {.text = "mm/s", .quantity = Quantity::velocity, .factor = 1e-3},
    {.text = "um/s", .quantity = Quantity::velocity, .factor = 1e-6},
    {.text = "m/min", .quantity = Quantity::velocity, .factor = 1 / minute},
    {.text = "mm/min", .quantity = Quantity::velocity, .factor = 1e-3 / minute},
    {.text = "deg/s", .quantity = Quantity::angular_velocity, .factor = 1},
    {.text = "mdeg/s", .quantity = Quantity::angular_velocity, .factor = 1e-3},
    {.text = "deg/min", .quantity = Quantity::angular_velocity, .factor = 1 / minute},
    {.text = "rpm", .quantity = Quantity::angular_velocity, .factor = revolution / minute},
    {.text = "U/min", .quantity = Quantity::angular_velocity, .factor = revolution / minute},
    {.text = "1/min", .quantity = Quantity::angular_velocity, .factor = revolution / minute},
    {.text = "m/s^2", .quantity = Quantity::acceleration, .factor = 1},
    {.text = "mm/s^2", .quantity = Quantity::acceleration, .factor = 1e-3},
    {.text = "deg/s^2", .quantity = Quantity::angular_acceleration, .factor = 1},
    {.text = "m/s^3", .quantity = Quantity::jerk, .factor = 1},
    {.text = "mm/s^3", .quantity = Quantity::jerk, .factor = 1e-3},
    {.text = "deg/s^3", .quantity = Quantity::angular_jerk, .factor = 1},
    {.text = "N", .quantity = Quantity::force, .factor = 1, .any_case = false},
    {.text = "Nm", .quantity = Quantity::torque, .factor = 1},
    {.text = "N m", .quantity = Quantity::torque, .factor = 1},
    {.text = "%", .quantity = Quantity::ratio, .factor = 1e-2},
    {.text = "percent", .quantity = Quantity::ratio, .factor = 1e-2},
    {.text = "Prozent", .quantity = Quantity::ratio, .factor = 1e-2},
};

bool means_the_same(WrittenUnit const& a, WrittenUnit const& b) {
  return a.quantity == b.quantity && a.factor == b.factor;
}

/// The rows of a text: the one that is spelled so, otherwise all that are in any letter case. `MHZ` may be
/// either of two.
std::vector<WrittenUnit const*> find_units(std::string_view text) {
  std::vector<WrittenUnit const*> found;
  for (WrittenUnit const& row : written_units) {
    if (row.text == text) return {&row};
    if (row.any_case && ascii::equal_ignoring_case(row.text, text)) found.push_back(&row);
  }
  return found;
}

/// Null for a text that is none, or may be several.
WrittenUnit const* find_unit(std::string_view text) {
  auto const found = find_units(text);
  bool const is_clear =
      !found.empty() && std::all_of(found.begin(), found.end(), [&found](WrittenUnit const* row) {
        return means_the_same(*row, *found.front());
      });
  return is_clear ? found.front() : nullptr;
}

/// Replaces `written`, in any letter case.
void respell(std::string& text, std::string_view written, std::string_view usual) {
  auto const at = std::search(text.begin(), text.end(), written.begin(), written.end(),
                              [](char a, char b) { return ascii::lower_case(a) == ascii::lower_case(b); });
  if (at == text.end()) return;
  text.replace(at, at + static_cast<std::ptrdiff_t>(written.size()), usual);
}

/// "[mm/s²]" as "mm/s^2".
std::string plain(std::string_view word) {
  constexpr std::array<std::pair<std::string_view, std::string_view>, 9> spellings = {{
      {"µ", "u"},
      {"μ", "u"},
      {"°", "deg"},
      {"²", "^2"},
      {"³", "^3"},
      {"min-1", "1/min"},
      {"sec", "s"},
      {"sek", "s"},
      {"Grad", "deg"},
  }};
  if (word.starts_with('[') && word.ends_with(']')) word = word.substr(1, word.size() - 2);
  std::string text(word);
  for (auto const& [written, usual] : spellings) respell(text, written, usual);
  if (text.size() > 1 && ascii::is_digit(text.back()) && ascii::lower_case(text[text.size() - 2]) == 's') {
    text.insert(text.size() - 1, "^");
  }
  return text;
}

}  // namespace

std::string_view unit_word(std::string_view text) {
  std::string_view const word = text.substr(0, text.find_first_of(" \t(;,:#)"));
  return word.ends_with('.') && word != "min." ? word.substr(0, word.size() - 1) : word;
}

bool is_unit(std::string_view word) {
  return !find_units(plain(word)).empty();
}

std::optional<double> unit_ratio(std::string_view word, std::string_view unit) {
  double factor = 1;
  if (std::size_t const blank = unit.find(' ');
      blank != std::string_view::npos && ascii::is_digit(unit.front())) {
    factor = schema::read_real(unit.substr(0, blank)).number;
    unit.remove_prefix(blank + 1);
  }
  WrittenUnit const* const written = find_unit(plain(word));
  WrittenUnit const* const wanted = find_unit(unit);
  if (written == nullptr || wanted == nullptr || written->quantity != wanted->quantity) return std::nullopt;
  return written->factor / (wanted->factor * factor);
}

std::string converted_number(double number, double ratio, bool is_integer) {
  double value = number * ratio;
  double const whole = std::round(value);
  constexpr double rounding = 1e-12;
  constexpr int digits = 15;
  bool const is_whole = std::abs(value - whole) <= rounding * std::abs(whole);
  if (is_whole) value = whole;
  return is_whole || !is_integer ? format_rounded(value, digits).written() : std::string();
}

}  // namespace axisc::validator
