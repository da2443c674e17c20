#include "axisc/answers/execution/recorded_kind.hpp"

#include "analysis/recordings/objects.hpp"
#include "analysis/recordings/scaling.hpp"
#include "diagnostics/ascii.hpp"

#include <algorithm>
#include <array>
#include <string_view>

namespace axisc {

namespace {

using recordings::Object;
using tuning::InputKind;

template <std::size_t size>
bool has_one_of(std::string const& text, std::array<std::string_view, size> const& words) {
  return std::any_of(words.begin(), words.end(),
                     [&](std::string_view word) { return text.find(word) != std::string::npos; });
}

}  // namespace

InputKind kind_of(recordings::Channel const& channel, ChosenColumn const& column) {
  if (column.object) {
    auto const object = column.object->object;
    return object == Object::torque     ? InputKind::force
           : object == Object::velocity ? InputKind::velocity
                                        : InputKind::position;
  }
  constexpr std::array<std::string_view, 2> positions{"position", "lage"};
  constexpr std::array<std::string_view, 6> forces{"torque",     "force", "current",
                                                   "drehmoment", "kraft", "strom"};
  constexpr std::array<std::string_view, 3> force_units{"[N]", "[Nm]", "[A]"};
  constexpr std::array<std::string_view, 7> velocities{"veloc", "speed", "geschw", "drehzahl",
                                                       "/s]",   "/min]", "rpm"};
  auto const written = channel.name + " [" + channel.unit + "]";
  auto const name = ascii::lower_case(written);
  if (has_one_of(name, velocities)) return InputKind::velocity;
  if (has_one_of(name, positions)) return InputKind::position;
  bool const is_force = has_one_of(name, forces) || has_one_of(written, force_units);
  return is_force ? InputKind::force : InputKind::position;
}

std::string named_unit(recordings::Channel const& channel) {
  std::string named(recordings::unit_in_brackets(channel.name));
  return named.empty() && recordings::names_unit(channel.unit) ? channel.unit : named;
}

}  // namespace axisc
