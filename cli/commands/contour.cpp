#include "axisc/answers/contour/contour_formats.hpp"
#include "axisc/answers/contour/contour_groups.hpp"
#include "axisc/checking/path_machine.hpp"
#include "axisc/environment/failure.hpp"
#include "cli/commands/commands.hpp"
#include "cli/commands/sentences.hpp"
#include "cli/options/check_options.hpp"
#include "cli/options/command_line.hpp"
#include "cli/options/contour_words.hpp"
#include "cli/options/sentences.hpp"
#include "cli/output/printed_errors.hpp"
#include "diagnostics/format_number.hpp"

#include <algorithm>

namespace axisc::cli::says {

constexpr Sentence feed_above_limit{
    "axis {axis} cannot move at {feed} mm/min; its vb_max (P-AXIS-00212) is {limit} mm/min",
    "Achse {axis} kann nicht mit {feed} mm/min fahren; ihr vb_max (P-AXIS-00212) ist {limit} mm/min"};
constexpr Sentence option_filter{
    R"(what the program commands, "#FILTER ON [ORDER=20]" or "#FILTER OFF")",
    R"(was das Programm kommandiert, "#FILTER ON [ORDER=20]" oder "#FILTER OFF")"};
constexpr Sentence option_format{"output format (default: text)", "Ausgabeformat (Standardwert: text)"};
}  // namespace axisc::cli::says

namespace axisc::cli {

namespace {

constexpr double mm_per_min_of_um_per_s = 0.06;

enum class Format : std::uint8_t { text, csv, json };

struct ContourOptions {
  std::optional<std::string> machine, cycle_time, filter, group;
  ContourWords words;
  bool alone = false;
  Format format = Format::text;
};

void declare(CommandLine& command_line, ContourOptions& options) {
  command_line.argument("MACHINE", options.machine, says::argument_input);
  declare_feeds(command_line, options.words);
  declare_orders(command_line, options.words);
  declare_angle(command_line, options.words);
  declare_radius(command_line, options.words);
  declare_tolerance(command_line, options.words);
  command_line.value("--filter", "COMMAND", options.filter, says::option_filter);
  command_line.value("--group", "NAME", options.group, says::option_group);
  command_line.value("--cycle-time", "TIME", options.cycle_time, says::option_cycle_time);
  declare_alone(command_line, options.alone);
  command_line.choice("--format", {{"text", Format::text}, {"csv", Format::csv}, {"json", Format::json}},
                      options.format, says::option_format);
}

/// Says which of the wanted feeds no motion of the group reaches.
void remark_feeds(machine::Machine const& machine, machine::MachineGroup const& group,
                  ContourOptions const& options, ContourRequest const& wanted, Invocation const& invocation) {
  double const fastest = *std::max_element(wanted.feeds.begin(), wanted.feeds.end());
  for (auto const index : group.axes) {
    auto const& axis = machine.axes[index];
    double const limit = axis.velocity_limit * mm_per_min_of_um_per_s;
    if (!options.words.feeds || axis.type != machine::AxisType::translatory || !(limit > 0) ||
        fastest <= limit) {
      continue;
    }
    invocation.streams.err.write(warning_line({.sentence = says::feed_above_limit,
                                               .arguments = {{"feed", exact_number(fastest)},
                                                             {"axis", axis.name},
                                                             {"limit", format_rounded(limit, 6)}}},
                                              invocation.language));
    return;
  }
}

}  // namespace

ExitStatus contour(Invocation const& invocation) {
  ContourOptions options;
  CommandLine command_line("contour", invocation.language);
  declare(command_line, options);
  auto& out = invocation.streams.out;
  if (command_line.answers(invocation)) return ExitStatus::success;
  command_line.require(options.machine.has_value(), "MACHINE");
  auto const wanted = read_contour_words(options.words);
  auto const checked = checked_machine(
      {.input = *options.machine, .cycle_time = asked_cycle_time(options.cycle_time), .alone = options.alone},
      printed_errors(invocation, use_color(command_line.color(), system::Stream::error)));
  if (!checked) return ExitStatus::findings;
  auto const& machine = checked->machine;
  auto const& chosen = options.group ? options.group : checked->group;
  auto const first = chosen_group(machine, chosen, *options.machine);

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
    if (chosen) break;
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
