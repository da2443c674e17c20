#include "configuration/channel_dynamics.hpp"

#include "diagnostics/ascii.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <string_view>
#include <system_error>

namespace axisc::configuration {
namespace {

using machine::ChannelDynamics;

std::optional<double> real(LocatedText const& value) {
  double number = 0;
  char const* const end = value.text.data() + value.text.size();
  auto const [stop, error] = std::from_chars(value.text.data(), end, number);
  return error == std::errc{} && stop == end ? std::optional(number) : std::nullopt;
}

std::optional<bool> flag(LocatedText const& value) {
  if (value.text == "1" || ascii::equal_ignoring_case(value.text, "TRUE")) return true;
  if (value.text == "0" || ascii::equal_ignoring_case(value.text, "FALSE")) return false;
  return std::nullopt;
}

template <bool ChannelDynamics::*member>
void read_flag(LocatedText const& value, ChannelDynamics& dynamics) {
  dynamics.*member = flag(value).value_or(dynamics.*member);
}

template <std::uint8_t ChannelDynamics::*member, std::uint32_t last>
void read_mode(LocatedText const& value, ChannelDynamics& dynamics) {
  auto const number = as_number(value);
  if (number && *number <= last) dynamics.*member = static_cast<std::uint8_t>(*number);
}

void read_slope(LocatedText const& value, ChannelDynamics& dynamics) {
  auto const number = as_number(value);
  if (number && *number <= static_cast<std::uint32_t>(machine::Slope::hsc)) {
    dynamics.slope = static_cast<machine::Slope>(*number);
  }
}

template <double machine::VectorLimits::*member>
void read_limit(LocatedText const& value, ChannelDynamics& dynamics) {
  dynamics.vector.*member = real(value).value_or(dynamics.vector.*member);
}

void read_limited_circles(LocatedText const& value, ChannelDynamics& dynamics) {
  dynamics.vector.limits_circles = flag(value).value_or(dynamics.vector.limits_circles);
}

void read_unit(LocatedText const& value, ChannelDynamics& dynamics) {
  if (ascii::equal_ignoring_case(value.text, "MM_M2")) dynamics.vector.per_minute = true;
  if (ascii::equal_ignoring_case(value.text, "MM_S2")) dynamics.vector.per_minute = false;
}

struct Parameter {
  std::string_view name;
  void (*read)(LocatedText const& value, ChannelDynamics& dynamics);
};

constexpr std::array parameters = {
    Parameter{"prog_start.slope.profile", read_slope},  // P-CHAN-00071
    Parameter{"prog_start.slope.mode_ramp_time", read_flag<&ChannelDynamics::constant_ramp_times>},  // 00349
    Parameter{"prog_start.slope.acceleration",
              read_mode<&ChannelDynamics::weighted_acceleration, 2>},                        // 00001
    Parameter{"prog_start.slope.ramp_time", read_mode<&ChannelDynamics::weighted_ramp, 4>},  // 00073
    Parameter{"corr_v_trans_jerk", read_flag<&ChannelDynamics::limits_curvature_steps>},     // 00009
    Parameter{"mode_trans_jerk", read_mode<&ChannelDynamics::transition_mode, 2>},           // 00117
    Parameter{"exact_stop_after_g00", read_flag<&ChannelDynamics::stops_after_rapid>},       // 00235
    Parameter{"vector.velocity", read_limit<&machine::VectorLimits::velocity>},              // 00090
    Parameter{"vector.acceleration", read_limit<&machine::VectorLimits::acceleration>},      // 00002
    Parameter{"vector.deceleration", read_limit<&machine::VectorLimits::deceleration>},      // 00208
    Parameter{"vector.radial_acceleration",
              read_limit<&machine::VectorLimits::radial_acceleration>},  // 00361
    Parameter{"vector.cir_radial_acc_limit", read_limited_circles},      // 00350
    Parameter{"vector.acc_dec_unit", read_unit}};                        // 00351

struct UncomputedRow {
  std::string_view name, number;
};

constexpr std::array uncomputed_rows = {UncomputedRow{"dynamic_weighting_active", "P-CHAN-00190"},
                                        UncomputedRow{"curve_dynamic_weighting_active", "P-CHAN-00230"},
                                        UncomputedRow{"trans_limit_with_curvature", "P-CHAN-00245"}};

void read_uncomputed(ListedValue const& value, std::vector<UncomputedValue>& uncomputed) {
  auto const* const row = std::find_if(
      uncomputed_rows.begin(), uncomputed_rows.end(),
      [&](UncomputedRow const& each) { return ascii::equal_ignoring_case(value.name, each.name); });
  if (row == uncomputed_rows.end()) return;
  std::erase_if(uncomputed, [row](UncomputedValue const& each) { return each.number == row->number; });
  if (as_number(value.value) == 0U || flag(value.value) == false) return;
  uncomputed.push_back({.number = row->number, .name_place = value.name_place});
}

bool names_function(LocatedText const& functions, std::string_view wanted) {
  std::string_view rest = functions.text;
  while (!rest.empty()) {
    std::size_t const bar = std::min(rest.find('|'), rest.size());
    std::string_view word = rest.substr(0, bar);
    rest.remove_prefix(std::min(bar + 1, rest.size()));
    while (!word.empty() && word.front() == ' ') word.remove_prefix(1);
    while (!word.empty() && word.back() == ' ') word.remove_suffix(1);
    if (ascii::equal_ignoring_case(word, wanted)) return true;
  }
  return false;
}

}  // namespace

void read_channel_dynamics(std::vector<ListedValue> const& values, ListedDynamics& listed) {
  listed.dynamics.is_from_list = true;
  for (ListedValue const& value : values) {
    auto const* const known = std::find_if(
        parameters.begin(), parameters.end(),
        [&](Parameter const& parameter) { return ascii::equal_ignoring_case(value.name, parameter.name); });
    if (known != parameters.end()) known->read(value.value, listed.dynamics);
    read_uncomputed(value, listed.uncomputed);
    if (match_name(value.name, "prog_start.slope.profile")) listed.slope_place = value.value.place;
    if (match_name(value.name, "configuration.interpolator.function")) {
      listed.look_ahead.function = value.value;
    } else if (match_name(value.name, "configuration.interpolator.number_blocks_lah") ||
               match_name(value.name, "configuration.interpolator.parameter")) {
      listed.look_ahead.blocks = as_number(value.value);
    }
  }
}

void read_look_ahead(std::vector<ListedValue> const& values, std::uint32_t channel, ListedLookAhead& listed) {
  for (ListedValue const& value : values) {
    auto const function = match_name(value.name, "configuration.channel[].interpolator.function");
    if (function && (*function)[0] == channel) listed.function = value.value;
    auto blocks = match_name(value.name, "configuration.channel[].interpolator.number_blocks_lah");
    if (!blocks) blocks = match_name(value.name, "configuration.channel[].interpolator.parameter");
    if (blocks && (*blocks)[0] == channel) listed.blocks = as_number(value.value);
  }
}

std::uint32_t look_ahead_blocks(ListedLookAhead const& listed, machine::Slope slope, std::uint32_t standard) {
  constexpr std::uint32_t low = 30;
  constexpr std::uint32_t high = 190;
  constexpr std::uint32_t fewest = 10;
  constexpr std::uint32_t most = 500;
  constexpr std::uint32_t most_of_step = 10000;
  if (!listed.function) return standard;
  if (names_function(*listed.function, "FCT_LOOK_AHEAD_LOW")) return low;
  if (names_function(*listed.function, "FCT_LOOK_AHEAD_HIGH")) return high;
  if (names_function(*listed.function, "FCT_LOOK_AHEAD_CUSTOM")) {
    return std::clamp(listed.blocks.value_or(standard), fewest,
                      slope == machine::Slope::step ? most_of_step : most);
  }
  return standard;
}

}  // namespace axisc::configuration
