#include "analysis/recordings/objects.hpp"

#include "diagnostics/ascii.hpp"

#include <algorithm>
#include <array>

namespace axisc::recordings {

namespace {

constexpr std::uint32_t logical_addressing = 0x100000;
constexpr std::uint32_t per_axis = 0x10000;
constexpr std::uint32_t low_byte = 0xFF;
constexpr std::uint32_t channel_group = 0x121300;
constexpr std::uint32_t axis_group = 0x120300;
constexpr std::uint32_t position_group = 0x120200;
constexpr std::uint16_t geo_task = 551;
constexpr std::uint16_t position_port = 553;

/// By Object.
constexpr std::array<ObjectRow, 10> all_objects{{
    {"unfiltered", "Active position", channel_group, 0x61, geo_task, true, "INT32", ObjectUnit::position},
    {"filtered", "Ft_sollwert_gestern", channel_group, 0x1C, geo_task, true, "INT64", ObjectUnit::position},
    {"physical-axis", "", channel_group, 0x17, geo_task, true, "UINT16", ObjectUnit::none},
    {"velocity", "", axis_group, 0x0D, geo_task, false, "INT32", ObjectUnit::increments_per_cycle},
    {"additive-velocity", "", axis_group, 0x250, geo_task, false, "INT64", ObjectUnit::increments_per_cycle},
    {"backlash-acting", "", axis_group, 0x93, geo_task, false, "INT32", ObjectUnit::increments},
    {"backlash-configured", "", axis_group, 0xAF, geo_task, false, "INT32", ObjectUnit::increments},
    {"command", "", position_group, 0x02, position_port, false, "INT32", ObjectUnit::position},
    {"actual", "", position_group, 0x03, position_port, false, "INT32", ObjectUnit::position},
    {"torque", "dig_drv.act_torque", 0, 0, 0, false, "", ObjectUnit::of_the_drive},
}};

bool is_object(ObjectRow const& row, Channel const& channel) {
  if (row.group == 0 || !channel.index_group || !channel.index_offset) return false;
  if (channel.port && *channel.port != row.port) return false;
  auto const group = *channel.index_group & ~std::uint64_t{low_byte | logical_addressing};
  return group == (row.group & ~logical_addressing) && *channel.index_offset % per_axis == row.offset &&
         *channel.index_offset <= UINT32_MAX;
}

/// What stands between `begin` and the end of the name, which is `end`; empty where it ends otherwise.
std::string_view ending_in(std::string_view name, std::string_view begin, char end) {
  auto const at = name.rfind(begin);
  if (at == std::string_view::npos || at == 0 || !name.ends_with(end)) return {};
  auto const first = at + begin.size();
  return name.substr(first, name.size() - first - 1);
}

bool has_name(ObjectRow const& row, Channel const& channel) {
  return !row.symbol.empty() && (ascii::equal_ignoring_case(channel.symbol, row.symbol) ||
                                 ascii::equal_ignoring_case(plain_name(channel.name), row.symbol));
}

}  // namespace

std::span<ObjectRow const> object_rows() {
  return all_objects;
}

ObjectRow const& row_of(Object object) {
  return all_objects.at(static_cast<std::size_t>(object));
}

std::optional<RecognisedObject> object_of(Channel const& channel) {
  for (std::size_t i = 0; i < all_objects.size(); ++i) {
    if (!is_object(all_objects.at(i), channel)) continue;
    return RecognisedObject{.object = static_cast<Object>(i),
                            .is_by_index = true,
                            .channel = static_cast<std::uint32_t>(*channel.index_group & low_byte),
                            .axis = static_cast<std::uint32_t>(*channel.index_offset / per_axis)};
  }
  auto const* const named = std::find_if(all_objects.begin(), all_objects.end(),
                                         [&](ObjectRow const& row) { return has_name(row, channel); });
  if (named == all_objects.end()) return std::nullopt;
  return RecognisedObject{.object = static_cast<Object>(named - all_objects.begin())};
}

std::string template_name(std::string_view axis, Object object) {
  return std::string(axis).append(" ").append(row_of(object).word);
}

std::string_view plain_name(std::string_view name) {
  auto const number = ending_in(name, " (", ')');
  if (!number.empty() && std::all_of(number.begin(), number.end(), ascii::is_digit)) {
    name.remove_suffix(number.size() + 3);
  }
  auto const unit = unit_in_brackets(name);
  if (!unit.empty()) name.remove_suffix(unit.size() + 3);
  return name;
}

std::string_view unit_in_brackets(std::string_view name) {
  return ending_in(name, " [", ']');
}

}  // namespace axisc::recordings
