#include "cli/commands/commands.hpp"
#include "cli/commands/sentences.hpp"
#include "cli/failure.hpp"
#include "cli/files/path_machine.hpp"
#include "cli/formats/contour_formats.hpp"
#include "cli/formats/contour_groups.hpp"
#include "cli/options/command_line.hpp"
#include "cli/options/quantities.hpp"
#include "cli/sentences.hpp"
#include "diagnostics/format_number.hpp"

#include <algorithm>

namespace axisc::cli::says {

constexpr Sentence purpose{
    R"(Predicts what the filters do to a contour at constant path velocity: axis error and contour deviation at a
corner, on a circle, on a straight line and between paths in opposite directions; the feed and the order that
keep a tolerance. FIR and HSC filters are on, as after #FILTER ON.)",
    R"(Sagt vorher, was die Filter bei konstanter Bahngeschwindigkeit mit einer Kontur machen: Achsfehler und
Bahnabweichung an einer Ecke, auf einem Kreis, auf einer Geraden und zwischen gegenläufigen Bahnen; Vorschub
und Ordnung, die eine Toleranz einhalten. FIR- und HSC-Filter sind an, wie nach #FILTER ON.)"};
constexpr Sentence examples{R"(Examples:
  axisc contour machine.json --feed 4000
  axisc contour machine.json --feed 1000,2000,4000 --order 20,40,80
  axisc contour machine.json --feed 4000 --tolerance 0.001 --angle 60 --format json)",
                            R"(Beispiele:
  axisc contour maschine.json --feed 4000
  axisc contour maschine.json --feed 1000,2000,4000 --order 20,40,80
  axisc contour maschine.json --feed 4000 --tolerance 0.001 --angle 60 --format json)"};
constexpr Sentence option_feed{"feed rates in mm/min (default: 1000)",
                               "Vorschübe in mm/min (Standardwert: 1000)"};
constexpr Sentence option_order{"orders instead of the lists'", "Ordnungen statt derer der Listen"};
constexpr Sentence option_angle{"change of direction at the corner in degrees, 0 to 180 (default: 90)",
                                "Richtungsänderung an der Ecke in Grad, 0 bis 180 (Standardwert: 90)"};
constexpr Sentence option_radius{"radius of the circle in mm (default: 10)",
                                 "Radius des Kreises in mm (Standardwert: 10)"};
constexpr Sentence feed_above_limit{
    "axis {axis} cannot move at {feed} mm/min; its vb_max (P-AXIS-00212) is {limit} mm/min",
    "Achse {axis} kann nicht mit {feed} mm/min fahren; ihr vb_max (P-AXIS-00212) ist {limit} mm/min"};
constexpr Sentence option_tolerance{
    "allowed axis error in mm: which feed and which order keep it",
    "erlaubter Achsfehler in mm: welcher Vorschub, welche Ordnung hält ihn ein"};
constexpr Sentence option_filter{
    R"(what the program commands, "#FILTER ON [ORDER=20]" or "#FILTER OFF")",
    R"(was das Programm kommandiert, "#FILTER ON [ORDER=20]" oder "#FILTER OFF")"};
constexpr Sentence option_format{"output format (default: text)", "Ausgabeformat (Standardwert: text)"};
constexpr Sentence bad_positive{"{option} needs numbers above 0, not \"{value}\"",
                                "{option} braucht Zahlen über 0, nicht \"{value}\""};
constexpr Sentence bad_angle{"--angle needs a number from 0 to 180, not \"{value}\"",
                             "--angle braucht eine Zahl von 0 bis 180, nicht \"{value}\""};
constexpr Sentence bad_orders{"--order needs whole numbers from 0 to {limit}, not \"{value}\"",
                              "--order braucht ganze Zahlen von 0 bis {limit}, nicht \"{value}\""};

}  // namespace axisc::cli::says

namespace axisc::cli {

namespace {

constexpr double mm_per_min_of_um_per_s = 0.06;

enum class Format : std::uint8_t { text, csv, json };

struct ContourOptions {
  std::optional<std::string> machine, cycle_time, feeds, orders, angle, radius, tolerance, filter, group;
  Format format = Format::text;
};

void declare(CommandLine& command_line, ContourOptions& options) {
  command_line.argument("MACHINE", options.machine, says::argument_input);
  command_line.value("--feed", "F[,F...]", options.feeds, says::option_feed);
  command_line.value("--order", "N[,N...]", options.orders, says::option_order);
  command_line.value("--angle", "DEGREES", options.angle, says::option_angle);
  command_line.value("--radius", "MM", options.radius, says::option_radius);
  command_line.value("--tolerance", "MM", options.tolerance, says::option_tolerance);
  command_line.value("--filter", "COMMAND", options.filter, says::option_filter);
  command_line.value("--group", "NAME", options.group, says::option_group);
  command_line.value("--cycle-time", "TIME", options.cycle_time, says::option_cycle_time);
  command_line.choice("--format", {{"text", Format::text}, {"csv", Format::csv}, {"json", Format::json}},
                      options.format, says::option_format);
}

[[noreturn]] void refuse(SentenceRef text, std::string option, std::string value) {
  throw Failure(
      {.sentence = text, .arguments = {{"option", std::move(option)}, {"value", std::move(value)}}});
}

double positive(std::string const& option, std::string const& word) {
  auto const value = parse_finite(word);
  if (!value || !(*value > 0)) refuse(says::bad_positive, option, word);
  return *value;
}

ContourRequest read_options(ContourOptions const& options) {
  ContourRequest wanted;
  if (options.feeds) {
    wanted.feeds.clear();
    for (auto const& word : split_list(*options.feeds)) wanted.feeds.push_back(positive("--feed", word));
    if (wanted.feeds.empty()) refuse(says::bad_positive, "--feed", *options.feeds);
  }
  if (options.orders) {
    wanted.orders.clear();
    for (auto const& word : split_list(*options.orders)) {
      auto const order = parse_count(word);
      if (!order || *order > design::longest_kernel_order) {
        throw Failure(
            {.sentence = says::bad_orders,
             .arguments = {{"limit", std::to_string(design::longest_kernel_order)}, {"value", word}}});
      }
      wanted.orders.emplace_back(static_cast<std::uint32_t>(*order));
    }
    if (wanted.orders.empty()) {
      throw Failure({.sentence = says::bad_orders,
                     .arguments = {{"limit", std::to_string(design::longest_kernel_order)},
                                   {"value", *options.orders}}});
    }
  }
  if (options.angle) {
    auto const angle = parse_finite(*options.angle);
    if (!angle || *angle < 0 || *angle > 180) {
      throw Failure({.sentence = says::bad_angle, .arguments = {{"value", *options.angle}}});
    }
    wanted.angle_deg = *angle;
  }
  if (options.radius) wanted.radius_mm = positive("--radius", *options.radius);
  if (options.tolerance) wanted.tolerance_mm = positive("--tolerance", *options.tolerance);
  return wanted;
}

/// Says which of the wanted feeds no motion of the group reaches.
void remark_feeds(machine::Machine const& machine, machine::MachineGroup const& group,
                  ContourOptions const& options, ContourRequest const& wanted, Invocation const& invocation) {
  double const fastest = *std::max_element(wanted.feeds.begin(), wanted.feeds.end());
  for (auto const index : group.axes) {
    auto const& axis = machine.axes[index];
    double const limit = axis.velocity_limit * mm_per_min_of_um_per_s;
    if (!options.feeds || axis.type != machine::AxisType::translatory || !(limit > 0) || fastest <= limit) {
      continue;
    }
    invocation.streams.err.write(warning_line({.sentence = says::feed_above_limit,
                                               .arguments = {{"feed", format_exact(fastest)},
                                                             {"axis", axis.name},
                                                             {"limit", format_rounded(limit, 6)}}},
                                              invocation.language));
    return;
  }
}

}  // namespace

ExitStatus contour(Invocation const& invocation) {
  ContourOptions options;
  CommandLine command_line("contour", says::purpose, says::examples, invocation.language);
  declare(command_line, options);
  auto& out = invocation.streams.out;
  if (command_line.answers(invocation)) return ExitStatus::success;
  command_line.require(options.machine.has_value(), "MACHINE");
  auto const wanted = read_options(options);
  auto const checked = checked_machine(*options.machine, options.cycle_time, invocation,
                                       use_color(command_line.color(), system::Stream::error));
  if (!checked) return ExitStatus::findings;
  auto const& machine = checked->machine;
  auto const first = chosen_group(machine, options.group, *options.machine);

  ShownContour shown{.cycle_time_us = machine.cycle_time.microseconds(),
                     .angle_deg = wanted.angle_deg,
                     .radius_mm = wanted.radius_mm,
                     .groups = {}};
  for (std::size_t i = first; i < machine.groups.size(); ++i) {
    if (machine.groups[i].axes.empty()) continue;
    remark_feeds(machine, machine.groups[i], options, wanted, invocation);
    auto const commands = options.filter
                              ? std::vector{read_filter_command(machine, machine.groups[i], *options.filter,
                                                                invocation.language)}
                              : filters_on();
    shown.groups.push_back(predict_contour(
        {.machine = machine, .group = i, .commands = commands, .path = *options.machine}, wanted));
    if (options.group) break;
  }
  switch (options.format) {
    case Format::text:
      out.write(contour_text(shown, invocation.language));
      break;
    case Format::csv:
      out.write(contour_csv(shown));
      break;
    case Format::json:
      out.write(contour_json(shown));
      break;
  }
  return ExitStatus::success;
}

}  // namespace axisc::cli
