#include "validator/commands/command_keywords.hpp"

#include "diagnostics/format_number.hpp"

#include <cmath>

#include <fmt/format.h>

namespace axisc::validator {
namespace {

KeywordRange closed(std::string_view keyword, double minimum, double maximum) {
  KeywordRange range;
  range.minimum = minimum;
  range.maximum = maximum;
  range.text =
      Wording::number(fmt::format("{} ≤ {} ≤ {}", format_exact(minimum), keyword, format_exact(maximum)));
  return range;
}

KeywordRange at_least(std::string_view keyword, double minimum) {
  KeywordRange range;
  range.minimum = minimum;
  range.text = Wording::number(fmt::format("{} ≥ {}", keyword, format_exact(minimum)));
  return range;
}

KeywordRange order(CommandLimits const& limits) {
  KeywordRange range = closed("ORDER", 0, limits.longest_order());
  range.whole = true;
  return range;
}

KeywordRange order_time(CommandLimits const& limits) {
  double const cycle = limits.cycle_time.microseconds();
  double const longest = limits.longest_order();
  KeywordRange range = closed("ORDER_TIME", cycle, longest * cycle);
  range.text = Wording::number(fmt::format("T = {} µs ≤ ORDER_TIME ≤ {} T = {} µs", format_exact(cycle),
                                           format_exact(longest), format_exact(longest * cycle)));
  range.depends_on_cycle_time = true;
  return range;
}

KeywordRange below_nyquist(std::string_view keyword, CommandLimits const& limits) {
  KeywordRange range = closed(keyword, 1, limits.nyquist().value);
  range.below_maximum = true;
  range.text = Wording::number(
      fmt::format("1 Hz ≤ {} < 0.5/T = {} Hz", keyword, format_rounded(limits.nyquist().value, 6).written()));
  range.depends_on_cycle_time = true;
  return range;
}

KeywordRange quality() {
  KeywordRange range = closed("QUALITY", 0, 1);
  range.above_minimum = true;
  range.text = "0 < QUALITY ≤ 1";
  range.control = quality_refused;
  return range;
}

KeywordRange with_control(KeywordRange range, std::string_view control) {
  range.control = control;
  return range;
}

KeywordRange mode() {
  KeywordRange range = with_control(closed("MODE", 1, 4), mode_refused);
  range.whole = true;
  return range;
}

}  // namespace

bool KeywordRange::contains(double value) const {
  bool const above = above_minimum ? value > minimum : value >= minimum;
  bool const below = !maximum || (below_maximum ? value < *maximum : value <= *maximum);
  return above && below && (!whole || value == std::floor(value));
}

std::vector<std::string_view> const& keywords_of(grammar::CommandKind kind) {
  static std::vector<std::string_view> const filter = {"ORDER", "ORDER_TIME", "SHARE",  "AX_DEV",
                                                       "FCUT",  "ACC_FACT",   "QUALITY"};
  static std::vector<std::string_view> const guard = {"MODE", "FREQ", "DAMPING", "AX_DEV", "ACC_FACT"};
  return kind == grammar::CommandKind::vibration_guard ? guard : filter;
}

KeywordRange range_of(std::string_view keyword, CommandLimits const& limits) {
  if (keyword == "ORDER") return order(limits);
  if (keyword == "ORDER_TIME") return order_time(limits);
  if (keyword == "SHARE") return with_control(closed(keyword, 0, 100), share_refused);
  if (keyword == "FCUT") return below_nyquist(keyword, limits);
  if (keyword == "ACC_FACT") return closed(keyword, 1, 10);
  if (keyword == "QUALITY") return quality();
  if (keyword == "MODE") return mode();
  if (keyword == "FREQ") return below_nyquist(keyword, limits);
  if (keyword == "DAMPING") return with_control(closed(keyword, 0, 1), damping_refused);
  return at_least(keyword, 0);
}

}  // namespace axisc::validator
