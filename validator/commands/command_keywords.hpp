// The keywords of #FILTER and #VIB GUARD with the ranges of their values.
#pragma once

#include "diagnostics/wording.hpp"
#include "grammar/nc_command.hpp"
#include "validator/commands/command_check.hpp"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace axisc::validator {

// Message numbers of the control about keywords: repeated keywords, and values out of range.
inline constexpr std::string_view keyword_repeated = "21411";
inline constexpr std::string_view mode_refused = "22062";
inline constexpr std::string_view damping_refused = "22066";
inline constexpr std::string_view no_guard = "50820";  // for the frequency and the damping
inline constexpr std::string_view share_refused = "22067";
inline constexpr std::string_view quality_refused = "22077";

struct KeywordRange {
  double minimum = 0;
  bool above_minimum = false;     ///< the minimum itself is not allowed
  std::optional<double> maximum;  ///< none: no limit
  bool below_maximum = false;     ///< the maximum itself is not allowed
  bool whole = false;             ///< whole numbers only
  Wording text;                   ///< "0 ≤ ORDER ≤ 200", with the formula where there is one
  bool depends_on_cycle_time = false;
  std::string_view
      control;  ///< the control's message that aborts the program for another value; empty: none known

  [[nodiscard]] bool contains(double value) const;
};

/// Keywords of #FILTER or #VIB GUARD, in the order of the manuals; HSC, which has no value, is not among
/// them.
[[nodiscard]] std::vector<std::string_view> const& keywords_of(grammar::CommandKind kind);

/// The range of one of keywords_of().
[[nodiscard]] KeywordRange range_of(std::string_view keyword, CommandLimits const& limits);

}  // namespace axisc::validator
