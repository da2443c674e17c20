// The kinds of lists that a controller reads, a row each. Each has a catalogue of its own.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>

namespace axisc::schema {

enum class ListKind : std::uint8_t {
  axis,
  startup,
  channel,
  real_time,
  manual,
  tool,
  zero_offset,
  clamp_offset,
  compensation,
  external_variables,
  hardware,
  setting_control,
  volumetric_compensation,
  cycle_module,
};

struct ListKindRow {
  ListKind kind{};
  std::string_view word;    ///< as the command line and settings name it
  std::string_view family;  ///< of its parameters' numbers: CHAN in P-CHAN-00035
};

inline constexpr std::array list_kind_rows{
    ListKindRow{.kind = ListKind::axis, .word = "axis", .family = "AXIS"},
    ListKindRow{.kind = ListKind::startup, .word = "startup", .family = "STUP"},
    ListKindRow{.kind = ListKind::channel, .word = "channel", .family = "CHAN"},
    ListKindRow{.kind = ListKind::real_time, .word = "real_time", .family = "RTCF"},
    ListKindRow{.kind = ListKind::manual, .word = "manual", .family = "MANU"},
    ListKindRow{.kind = ListKind::tool, .word = "tool", .family = "TOOL"},
    ListKindRow{.kind = ListKind::zero_offset, .word = "zero_offset", .family = "ZERO"},
    ListKindRow{.kind = ListKind::clamp_offset, .word = "clamp_offset", .family = "CLMP"},
    ListKindRow{.kind = ListKind::compensation, .word = "compensation", .family = "COMP"},
    ListKindRow{.kind = ListKind::external_variables, .word = "external_variables", .family = "EXTV"},
    ListKindRow{.kind = ListKind::hardware, .word = "hardware", .family = "HWCF"},
    ListKindRow{.kind = ListKind::setting_control, .word = "setting_control", .family = "SECO"},
    ListKindRow{
        .kind = ListKind::volumetric_compensation, .word = "volumetric_compensation", .family = "VOLC"},
    ListKindRow{.kind = ListKind::cycle_module, .word = "cycle_module", .family = "CMLD"},
};
inline constexpr std::size_t list_kinds = list_kind_rows.size();

[[nodiscard]] constexpr ListKindRow const& row_of(ListKind kind) {
  return list_kind_rows[static_cast<std::size_t>(kind)];
}

static_assert([] {
  for (std::size_t i = 0; i < list_kinds; ++i) {
    if (static_cast<std::size_t>(list_kind_rows[i].kind) != i) return false;
  }
  return list_kinds == static_cast<std::size_t>(ListKind::cycle_module) + 1;
}());

/// The kind of the row of which `field` is `text`.
[[nodiscard]] constexpr std::optional<ListKind> find_list_kind(std::string_view ListKindRow::*field,
                                                               std::string_view text) {
  for (ListKindRow const& row : list_kind_rows) {
    if (row.*field == text) return row.kind;
  }
  return std::nullopt;
}

}  // namespace axisc::schema
