// What the control says of a single parameter that is out of its range, where that is documented or known
// from the texts of its messages.
#pragma once

#include "validator/rules/control_numbers.hpp"
#include "validator/rules/helpers.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>

namespace axisc::validator::says {

inline constexpr Sentence range_reported{
    "it reports the value; what it continues with is not documented",
    "sie meldet den Wert; womit sie weiterarbeitet, ist nicht dokumentiert"};
inline constexpr Sentence range_corrected{"it corrects the value", "sie korrigiert den Wert"};
inline constexpr Sentence range_switches_off{"it switches Improved Position Control of the axis off",
                                             "sie schaltet die optimierte Lageregelung der Achse ab"};

}  // namespace axisc::validator::says

namespace axisc::validator {

/// The demand that a value violates; `even`: odd numbers are not allowed.
enum class Demand : std::uint8_t { minimum, maximum, range, even };

struct RangeReaction {
  schema::ListKind kind;
  std::uint16_t parameter;  ///< its number
  Demand demand;            ///< `range`: minimum and maximum
  std::string_view message;
  SentenceRef text;

  [[nodiscard]] constexpr bool is_about(schema::Parameter const& row) const {
    return kind == row.kind && parameter == row.p_axis;
  }
  [[nodiscard]] constexpr bool covers(Demand violated) const {
    bool const is_limit = violated == Demand::minimum || violated == Demand::maximum;
    return demand == violated || (demand == Demand::range && is_limit);
  }
};

inline constexpr auto in_axis_list = schema::ListKind::axis;
inline constexpr auto in_channel_list = schema::ListKind::channel;

/// Of ranges that are numbers: AX2005.
inline constexpr std::array range_reactions{
    // Filters, Vibration Guard.
    RangeReaction{in_axis_list, 80, Demand::minimum, "110490", says::range_reported},
    RangeReaction{in_axis_list, 164, Demand::range, "110240", says::range_reported},
    RangeReaction{in_axis_list, 351, Demand::minimum, "110496", says::range_reported},
    RangeReaction{in_axis_list, 585, Demand::range, "110633", says::range_reported},
    RangeReaction{in_axis_list, 590, Demand::range, "110632", says::range_reported},
    RangeReaction{in_axis_list, 593, Demand::range, "110637", says::range_reported},
    RangeReaction{in_axis_list, 568, Demand::range, "110627", says::range_corrected},
    RangeReaction{in_axis_list, 571, Demand::range, "110626", says::range_corrected},
    // Improved Position Control.
    RangeReaction{in_axis_list, 750, Demand::range, "70593", says::range_reported},
    RangeReaction{in_axis_list, 751, Demand::range, "70592", says::range_reported},
    RangeReaction{in_axis_list, 752, Demand::range, "70594", says::range_reported},
    RangeReaction{in_axis_list, 754, Demand::minimum, "70603", says::range_switches_off},
    RangeReaction{in_axis_list, 755, Demand::minimum, "70604", says::range_switches_off},
    RangeReaction{in_axis_list, 757, Demand::range, "70606", says::range_reported},
    // Accelerations, handwheel.
    RangeReaction{in_axis_list, 1, Demand::minimum, "110100", says::range_reported},
    RangeReaction{in_axis_list, 2, Demand::minimum, "110102", says::range_reported},
    RangeReaction{in_axis_list, 69, Demand::minimum, "110137", says::range_reported},
    // Conveyor tracking.
    RangeReaction{in_axis_list, 621, Demand::range, "50606", says::range_corrected},
    RangeReaction{in_axis_list, 622, Demand::maximum, "50604", says::range_corrected},
    RangeReaction{in_axis_list, 622, Demand::even, "50605", says::range_corrected},
    RangeReaction{in_axis_list, 623, Demand::maximum, "50607", says::range_corrected},
    RangeReaction{in_axis_list, 623, Demand::even, "50608", says::range_corrected},
    // Distance control.
    RangeReaction{in_axis_list, 413, Demand::range, "110572", says::range_reported},
    RangeReaction{in_axis_list, 507, Demand::range, "110664", says::range_reported},
    RangeReaction{in_axis_list, 508, Demand::range, "110665", says::range_reported},
    RangeReaction{in_axis_list, 783, Demand::range, "110661", says::range_reported},
    RangeReaction{in_axis_list, 784, Demand::range, "110660", says::range_reported},
    RangeReaction{in_channel_list, 800, Demand::range, "315002", says::range_reported},
    RangeReaction{in_channel_list, 816, Demand::range, "315004", says::range_reported},
    RangeReaction{in_channel_list, 817, Demand::range, "315003", says::range_reported},
    RangeReaction{in_channel_list, 821, Demand::range, "315010", says::range_reported},
    RangeReaction{in_channel_list, 822, Demand::range, "315011", says::range_reported},
    RangeReaction{in_channel_list, 823, Demand::range, "315012", says::range_reported},
    RangeReaction{in_channel_list, 826, Demand::range, "315009", says::range_reported},
    RangeReaction{in_channel_list, 827, Demand::range, "315008", says::range_reported},
    // Tapping and thread cutting.
    RangeReaction{in_channel_list, 762, Demand::range, "22200", says::range_reported},
    RangeReaction{in_channel_list, 835, Demand::range, "22245", says::range_reported},
};

/// Of limits that are other parameters: AX2015.
inline constexpr std::array limit_reactions{
    RangeReaction{in_axis_list, 199, Demand::minimum, "110276", says::range_reported},
    RangeReaction{in_axis_list, 292, Demand::maximum, "110405", says::range_reported},
    RangeReaction{in_axis_list, 293, Demand::minimum, "110406", says::range_reported},
};

/// Sets the message and the reaction of a finding about the parameter; none where none is known.
inline void say_range_reaction(Finding& finding, std::span<RangeReaction const> known,
                               schema::Parameter const& parameter, Demand violated) {
  finding.control.reset();
  auto const found = std::find_if(known.begin(), known.end(), [&](RangeReaction const& reaction) {
    return reaction.is_about(parameter) && reaction.covers(violated);
  });
  if (found == known.end()) return;
  set_reaction(finding, found->text);
  finding.control->message = found->message;
}

template <auto const& table>
inline constexpr auto message_list = [] {
  std::array<std::string_view, table.size()> messages;
  std::transform(table.begin(), table.end(), messages.begin(),
                 [](RangeReaction const& reaction) { return reaction.message; });
  return messages;
}();

/// The numbers of all messages of a table, "110276/110405", for a rule's column `control`.
template <auto const& table>
inline constexpr std::string_view messages_of = checks::control_text<message_list<table>>;

}  // namespace axisc::validator
