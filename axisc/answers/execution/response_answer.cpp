#include "axisc/answers/execution/response_answer.hpp"

#include "axisc/answers/labels.hpp"
#include "axisc/asked/frequencies.hpp"
#include "axisc/environment/failure.hpp"
#include "axisc/environment/sentences.hpp"
#include "design/filter_kinds.hpp"

#include <cmath>
#include <numbers>

namespace axisc::says {

constexpr Sentence title{"frequency response of {image}", "Frequenzgang von {image}"};

}  // namespace axisc::says

namespace axisc {

namespace {

using namespace presentation;

/// Axes with a filter at that port; the setpoint of an axis without filters passes unchanged and is shown so.
std::vector<std::size_t> axes_with_port(ImageFile const& file, ResponseQuestion const& question) {
  auto axes = chosen_axes(file.contents, question.axis);
  std::erase_if(axes, [&](std::size_t axis) {
    auto const& contents = file.contents.axes[axis];
    if (question.port == Port::interface) return contents.interface_filters.empty();
    return question.port == Port::velocity && !contents.control;
  });
  if (!axes.empty()) return axes;
  throw Failure({question.port == Port::velocity ? says::no_velocities : says::no_interface_filter,
                 {{"file", question.image}}});
}

/// Frequencies at which the chains do what they were made for: corners, notches, vibrations.
std::vector<double> frequencies_of_filters(image::ImageContents const& image,
                                           std::vector<std::size_t> const& axes, Port port) {
  std::vector<double> frequencies;
  auto const add = [&](std::vector<image::ImageFilter> const& filters) {
    for (auto const& filter : filters) {
      auto const& specification = filter.specification;
      if (design::uses_frequency(specification.type)) frequencies.push_back(specification.frequency.value);
    }
  };
  for (auto const axis : axes) {
    auto const& contents = image.axes[axis];
    if (port == Port::setpoint) add(contents.filters);
    if (port == Port::interface) add(contents.interface_filters);
    if (port != Port::velocity || !contents.control) continue;
    for (auto const& stage : contents.control->stages) add(stage.filters);
  }
  return frequencies;
}

std::vector<Column> columns() {
  return {{.key = "axis", .label = labels::axis, .is_head = true},
          {.key = "frequency_hz", .label = labels::frequency, .unit = Unit::hertz, .is_head = true},
          {.key = "magnitude", .label = labels::gain, .audience = Audience::programs},
          {.key = "phase_rad", .label = labels::phase, .unit = Unit::radian, .audience = Audience::programs},
          {.key = "group_delay_s",
           .label = labels::group_delay,
           .unit = Unit::second,
           .audience = Audience::programs},
          {.key = "magnitude_db", .label = labels::gain, .unit = Unit::decibel},
          {.key = "phase_deg", .label = labels::phase, .unit = Unit::degree},
          {.key = {}, .label = labels::group_delay, .unit = Unit::millisecond, .audience = Audience::people}};
}

std::vector<Value> row_of(std::string const& axis, double frequency, design::ResponsePoint const& point) {
  // No gain is minus infinity: where nothing passes.
  return {axis,
          Quantity{.value = frequency},
          Quantity{.value = point.magnitude},
          Quantity{.value = point.phase_rad},
          Quantity{.value = point.group_delay_s},
          Quantity{.value = 20 * std::log10(point.magnitude)},
          Quantity{.value = point.phase_rad * 180 / std::numbers::pi},
          Quantity{.value = point.group_delay_s * 1000}};
}

}  // namespace

Document response_answer(ResponseQuestion const& question, ImageFile const& file) {
  auto const cycle_time = file.contents.cycle_time;
  auto const axes = axes_with_port(file, question);
  auto const frequencies =
      question.frequencies
          ? *question.frequencies
          : default_frequencies(cycle_time, frequencies_of_filters(file.contents, axes, question.port));
  auto host = start_runtime(question.image, file, question.level);
  for (auto const& command : question.commands) execute(command, host, file.contents, question.image);
  Table table{.key = "response", .columns = columns(), .rows = {}};
  for (auto const axis : axes) {
    PortResponse const response(file.contents, host, axis, question.port);
    auto const name = axis_label(file.contents, axis);
    for (double const frequency : frequencies) {
      table.rows.push_back(row_of(name, frequency, response.at({frequency})));
    }
  }
  Quantity const cycle{
      .value = cycle_time.microseconds(), .unit = Unit::microsecond, .digits = Digits::exact()};
  return {.version = 1,
          .title = Words(says::title, {{"image", question.image}}),
          .blocks = {Facts{{data("port", port_name(question.port)),
                            {.key = "cycle_time_us", .label = labels::cycle_time, .value = cycle}}},
                     std::move(table)},
          .csv_table = "response"};
}

}  // namespace axisc
