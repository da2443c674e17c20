#include "analysis/motion/program/channel.hpp"

#include <algorithm>

namespace axisc::motion {
namespace {

template <typename Matches>
std::optional<std::size_t> first_axis(std::vector<std::string> const& axes, Matches matches) {
  auto const found = std::find_if(axes.begin(), axes.end(), matches);
  if (found == axes.end()) return std::nullopt;
  return static_cast<std::size_t>(found - axes.begin());
}

}  // namespace

std::optional<std::size_t> ProgramChannel::axis(std::string_view name) const {
  return first_axis(axes, [name](std::string const& axis) { return axis == name; });
}

std::optional<std::size_t> ProgramChannel::axis_beginning_with(char letter) const {
  return first_axis(axes, [letter](std::string const& axis) { return axis.front() == letter; });
}

}  // namespace axisc::motion
