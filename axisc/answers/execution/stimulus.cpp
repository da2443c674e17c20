#include "axisc/answers/execution/stimulus.hpp"

#include <algorithm>
#include <array>
#include <utility>

namespace axisc {

namespace {

/// Every column that the image uses, in image order.
std::vector<Channel> all_channels(image::ImageContents const& image) {
  std::vector<Channel> channels;
  for (std::size_t axis = 0; axis < image.axes.size(); ++axis) {
    channels.push_back({.axis = axis, .input = Input::setpoint});
    if (!image.axes[axis].interface_filters.empty()) {
      channels.push_back({.axis = axis, .input = Input::interface});
    }
    auto const& control = image.axes[axis].control;
    if (!control || control->stages.empty()) continue;
    for (auto const input : {Input::v_set, Input::v_motor, Input::v_direct}) {
      channels.push_back({.axis = axis, .input = input});
    }
  }
  return channels;
}

}  // namespace

Port port_of(Input input) {
  if (input == Input::setpoint) return Port::setpoint;
  return input == Input::interface ? Port::interface : Port::velocity;
}

std::string channel_name(image::ImageContents const& image, Channel const& channel) {
  constexpr std::array<char const*, inputs> suffixes = {"", ".interface", ".v_set", ".v_motor", ".v_direct"};
  return axis_label(image, channel.axis) + suffixes[static_cast<std::size_t>(channel.input)];
}

SignalStimulus::SignalStimulus(image::ImageContents const& image, Facts const& facts)
    : facts_(facts), cycle_time_(image.cycle_time), channels_(all_channels(image)) {
  std::erase_if(channels_, [&](Channel const& channel) { return port_of(channel.input) != facts.port; });
}

bool SignalStimulus::next(std::span<double> values) {
  if (cycle_ == facts_.cycles) return false;
  double const value = facts_.signal.at(cycle_++, facts_.amplitude, cycle_time_);
  std::fill(values.begin(), values.end(), value);
  return true;
}

CsvStimulus::CsvStimulus(image::ImageContents const& image, std::string name, ByteSource source)
    : reader_(std::move(name), std::move(source)) {
  auto const known = all_channels(image);
  for (std::size_t column = 0; column < reader_.header().size(); ++column) {
    auto const found = std::find_if(known.begin(), known.end(), [&](Channel const& channel) {
      // As a person writes it, or as `run` does.
      auto const known_name = channel_name(image, channel);
      auto const& wanted = reader_.header()[column];
      return known_name == wanted || csv_name(known_name) == wanted;
    });
    if (found == known.end()) {
      std::string names;
      for (auto const& channel : known) names += (names.empty() ? "" : ", ") + channel_name(image, channel);
      reader_.refuse_column(column, names);
    }
    channels_.push_back(*found);
  }
}

}  // namespace axisc
