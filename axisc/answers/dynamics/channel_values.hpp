// How a channel drives its path, parameter by parameter.
#pragma once

#include "configuration/machine/path_dynamics.hpp"

#include <string>
#include <string_view>
#include <vector>

namespace axisc {

/// A parameter with the value that counts: that of the lists, or the control's default.
struct ChannelValue {
  std::string_view number;  ///< "P-CHAN-00071"
  std::string_view name;    ///< "prog_start.slope.profile"
  std::string value;        ///< a number, or a symbol; with a decimal point

  friend bool operator==(ChannelValue const&, ChannelValue const&) = default;
};

/// All of them, in a fixed order.
[[nodiscard]] std::vector<ChannelValue> channel_values(machine::ChannelDynamics const& channel);

}  // namespace axisc
