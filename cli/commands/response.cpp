#include "cli/codes.hpp"
#include "cli/commands/commands.hpp"
#include "cli/commands/sentences.hpp"
#include "cli/execution/port_response.hpp"
#include "cli/files/image_file.hpp"
#include "cli/options/command_line.hpp"
#include "cli/options/frequencies.hpp"
#include "cli/options/timed_commands.hpp"
#include "cli/report/csv.hpp"
#include "cli/report/json_text.hpp"
#include "cli/report/text_table.hpp"
#include "design/filter_kinds.hpp"
#include "diagnostics/format_number.hpp"

#include <cmath>
#include <numbers>

namespace axisc::cli::says {

constexpr Sentence purpose{
    R"(Frequency response of each chain, computed from the image's coefficients. Columns: axis, frequency_hz,
magnitude, phase_rad, group_delay_s, magnitude_db, phase_deg; with --format text decibels, degrees and milliseconds.)",
    R"(Frequenzgang jeder Filterkette, aus den Koeffizienten des Abbilds gerechnet. Spalten: axis, frequency_hz,
magnitude, phase_rad, group_delay_s, magnitude_db, phase_deg; mit --format text Dezibel, Grad und Millisekunden.)"};
constexpr Sentence examples{R"(Examples:
  axisc response mill.axim --axis X
  axisc response mill.axim --frequencies 0,1,2.5,42
  axisc response mill.axim --axis X --format text
  axisc response mill.axim --port interface --format json)",
                            R"(Beispiele:
  axisc response fraese.axim --axis X
  axisc response fraese.axim --frequencies 0,1,2.5,42
  axisc response fraese.axim --axis X --format text
  axisc response fraese.axim --port interface --format json)"};
constexpr Sentence option_axis{"only this axis (default: all)", "nur diese Achse (Standardwert: alle)"};
constexpr Sentence option_port{"which chain (default: setpoint)",
                               "welche Filterkette (Standardwert: setpoint)"};
constexpr Sentence option_format{"output format (default: csv)", "Ausgabeformat (Standardwert: csv)"};
constexpr Sentence option_frequencies{
    "in Hz, from 0 to 0.5/T (default: 200 logarithmic points up to 0.5/T, and the frequencies of the "
    "filters)",
    "in Hz, von 0 bis 0,5/T (Standardwert: 200 logarithmische Punkte bis 0,5/T und die Frequenzen der "
    "Filter)"};
constexpr Sentence column_axis{"axis", "Achse"};
constexpr Sentence column_frequency{"frequency", "Frequenz"};
constexpr Sentence column_gain{"gain", "Verstärkung"};
constexpr Sentence column_phase{"phase", "Phase"};
constexpr Sentence column_delay{"group delay", "Gruppenlaufzeit"};

}  // namespace axisc::cli::says

namespace axisc::cli {

namespace {

enum class Format : std::uint8_t { csv, json, text };

struct ResponseOptions {
  std::optional<std::string> image;
  std::optional<std::string> axis;
  std::optional<std::string> frequencies;
  std::optional<std::string> level;
  std::vector<std::string> commands;
  Port port = Port::setpoint;
  Format format = Format::csv;
};

void declare(CommandLine& command_line, ResponseOptions& options) {
  command_line.argument("IMAGE.axim", options.image, says::argument_image);
  command_line.value("--axis", "NAME", options.axis, says::option_axis);
  command_line.choice(
      "--port", {{"setpoint", Port::setpoint}, {"interface", Port::interface}, {"velocity", Port::velocity}},
      options.port, says::option_port);
  command_line.value("--frequencies", "F[,F...]", options.frequencies, says::option_frequencies);
  command_line.value("--level", level_names, options.level, says::option_level);
  command_line.values("--at", "CYCLE:COMMAND", options.commands, says::option_at);
  command_line.choice("--format", {{"csv", Format::csv}, {"json", Format::json}, {"text", Format::text}},
                      options.format, says::option_format);
}

/// Axes with a filter at that port; the setpoint of an axis without filters passes unchanged and is shown so.
std::vector<std::size_t> axes_with_port(ImageFile const& file, ResponseOptions const& options) {
  auto axes = chosen_axes(file.contents, options.axis);
  std::erase_if(axes, [&](std::size_t axis) {
    auto const& contents = file.contents.axes[axis];
    if (options.port == Port::interface) return contents.interface_filters.empty();
    return options.port == Port::velocity && !contents.control;
  });
  if (!axes.empty()) return axes;
  throw Failure({.sentence = options.port == Port::velocity ? says::no_velocities : says::no_interface_filter,
                 .arguments = {{"file", *options.image}}});
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

/// -inf where nothing passes.
double decibels(design::ResponsePoint const& point) {
  return 20 * std::log10(point.magnitude);
}

double degrees(design::ResponsePoint const& point) {
  return point.phase_rad * 180 / std::numbers::pi;
}

void write_text(Console& out, ImageFile const& file, ResponseOptions const& options,
                std::vector<std::size_t> const& axes, std::vector<double> const& frequencies,
                image::RuntimeHost const& host, Language language) {
  constexpr int digits = 4;
  auto const say = [language](SentenceRef text) {
    return render({.sentence = text, .arguments = {}}, language);
  };
  std::vector<std::vector<std::string>> rows{
      {say(says::column_axis), say(says::column_frequency) + " [Hz]", say(says::column_gain) + " [dB]",
       say(says::column_phase) + " [°]", say(says::column_delay) + " [ms]"}};
  for (auto const axis : axes) {
    PortResponse const response(file.contents, host, axis, options.port);
    for (double const frequency : frequencies) {
      auto const point = response.at({frequency});
      rows.push_back({axis_label(file.contents, axis), format_rounded(frequency, digits).in(language),
                      format_rounded(decibels(point), digits).in(language),
                      format_rounded(degrees(point), digits).in(language),
                      format_rounded(point.group_delay_s * 1000, digits).in(language)});
    }
  }
  out.write(text_table(rows, 0));
}

void write_csv_rows(Console& out, std::string const& axis, PortResponse const& response,
                    std::vector<double> const& frequencies) {
  std::string name;
  append_csv_name(name, axis);
  for (double const frequency : frequencies) {
    auto const point = response.at({frequency});
    std::string line = name + ",";
    append_csv_row(line, std::array{frequency, point.magnitude, point.phase_rad, point.group_delay_s,
                                    decibels(point), degrees(point)});
    out.write(line);
  }
}

std::string json_rows(std::string const& axis, PortResponse const& response,
                      std::vector<double> const& frequencies) {
  std::string text;
  for (double const frequency : frequencies) {
    auto const point = response.at({frequency});
    if (!text.empty()) text += ",\n";
    text += "    {\"axis\": " + json_string(axis) + ", \"frequency_hz\": " + json_number(frequency) +
            ", \"magnitude\": " + json_number(point.magnitude) +
            ", \"phase_rad\": " + json_number(point.phase_rad) +
            ", \"group_delay_s\": " + json_number(point.group_delay_s) +
            ", \"magnitude_db\": " + json_number(decibels(point)) +
            ", \"phase_deg\": " + json_number(degrees(point)) + "}";
  }
  return text;
}

void write_json(Console& out, ImageFile const& file, ResponseOptions const& options,
                std::vector<std::size_t> const& axes, std::vector<double> const& frequencies,
                image::RuntimeHost const& host) {
  auto const cycle_time = file.contents.cycle_time;
  out.write("{\n  \"version\": 1,\n  \"port\": " + json_string(port_name(options.port)) +
            ",\n  \"cycle_time_us\": " + json_number(cycle_time.microseconds()) + ",\n  \"response\": [\n");
  bool first = true;
  for (auto const axis : axes) {
    if (!first) out.write(",\n");
    first = false;
    out.write(json_rows(axis_label(file.contents, axis),
                        PortResponse(file.contents, host, axis, options.port), frequencies));
  }
  out.write("\n  ]\n}\n");
}

}  // namespace

ExitStatus response(Invocation const& invocation) {
  ResponseOptions options;
  CommandLine command_line("response", says::purpose, says::examples, invocation.language);
  declare(command_line, options);
  auto& out = invocation.streams.out;
  if (command_line.answers(invocation)) return ExitStatus::success;
  command_line.require(options.image.has_value(), "IMAGE.axim");
  auto const file = load_image(*options.image);
  auto const cycle_time = file.contents.cycle_time;
  auto const axes = axes_with_port(file, options);
  auto const frequencies =
      options.frequencies
          ? parse_frequencies(*options.frequencies, cycle_time)
          : default_frequencies(cycle_time, frequencies_of_filters(file.contents, axes, options.port));
  auto host = start_runtime(*options.image, file, level_of(options.level));
  for (auto const& command :
       read_timed_commands(options.commands, file, *options.image, invocation.language)) {
    execute(command, host, file.contents, *options.image);
  }
  if (options.format == Format::json) {
    write_json(out, file, options, axes, frequencies, host);
    return ExitStatus::success;
  }
  if (options.format == Format::text) {
    write_text(out, file, options, axes, frequencies, host, invocation.language);
    return ExitStatus::success;
  }
  out.write("axis,frequency_hz,magnitude,phase_rad,group_delay_s,magnitude_db,phase_deg\n");
  for (auto const axis : axes) {
    write_csv_rows(out, axis_label(file.contents, axis),
                   PortResponse(file.contents, host, axis, options.port), frequencies);
  }
  return ExitStatus::success;
}

}  // namespace axisc::cli
