// What two axes mean by their parameters: effective values, compared as the control would read them.
#pragma once

#include "axisc/answers/difference/compared_machine.hpp"

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace axisc {

enum class ValueState : std::uint8_t {
  set,       ///< a list sets it
  standard,  ///< the documented default counts
  missing,   ///< no list sets it, and no default is documented
};

struct ComparedValue {
  ValueState state = ValueState::missing;
  std::string text;      ///< as written, or as the default is documented
  std::string resolved;  ///< of a reference (P-AXIS-00008): the number that it leads to; else empty
  std::string place;     ///< "listen/achsmds1.lis:12"; empty where no list sets it
  schema::Value value;
};

struct ParameterChange {
  std::string name;  ///< `filter[0].order`
  schema::Parameter const* row = nullptr;
  std::string_view unit;  ///< of the raw number; empty where it has none
  ComparedValue before, after;
  bool restart = false;  ///< the control reads it at start-up only
  bool equal = false;    ///< means the same: shown on request only
};

/// Parameters in which the axes of one machine must differ: number, name, and where the drive is connected.
inline constexpr std::string_view own_parameters[] = {
    "kopf.achs_nr",         "kopf.log_achs_name", "antr.sercos.antr_adr", "antr.canopen.address",
    "antr.generic.address", "antr.dse.antr_adr",  "antr.addroffs.input",  "antr.addroffs.output",
    "lr_hw[].cntr_channel", "lr_hw[].da_channel",
};
[[nodiscard]] bool is_own(schema::Parameter const& row);

/// By rising name, every parameter that a list sets on either side and that is not set alike; `equal` marks
/// those that mean the same nevertheless (one side sets what is its default). Empty where the values of a
/// side are not known.
[[nodiscard]] std::vector<ParameterChange> compare_parameters(ComparedMachine const& before,
                                                              ComparedAxis const& old_axis,
                                                              ComparedMachine const& after,
                                                              ComparedAxis const& new_axis);

}  // namespace axisc
