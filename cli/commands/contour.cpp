#include "cli/options/command_line.hpp"
#include "cli/commands/commands.hpp"
#include "cli/formats/contour_formats.hpp"
#include "cli/formats/contour_groups.hpp"
#include "cli/files/path_machine.hpp"
#include "cli/options/quantities.hpp"

#include <algorithm>

namespace axisc::cli {

namespace {

enum class Form : std::uint8_t { text, csv, json };

struct ContourWords {
  std::optional<std::string> machine, cycle_time, feeds, orders, angle, radius, tolerance, filter, group;
  Form form = Form::text;
};

void declare(CommandLine& command_line, ContourWords& words) {
  command_line.argument("MACHINE", words.machine, Text::cli_arg_input);
  command_line.value("--feed", "F[,F...]", words.feeds, Text::cli_opt_contour_feed);
  command_line.value("--order", "N[,N...]", words.orders, Text::cli_opt_contour_order);
  command_line.value("--angle", "DEGREES", words.angle, Text::cli_opt_contour_angle);
  command_line.value("--radius", "MM", words.radius, Text::cli_opt_contour_radius);
  command_line.value("--tolerance", "MM", words.tolerance, Text::cli_opt_contour_tolerance);
  command_line.value("--filter", "COMMAND", words.filter, Text::cli_opt_contour_filter);
  command_line.value("--group", "NAME", words.group, Text::cli_opt_group);
  command_line.value("--cycle-time", "TIME", words.cycle_time, Text::cli_opt_cycle_time);
  command_line.choice("--format", {{"text", Form::text}, {"csv", Form::csv}, {"json", Form::json}},
                      words.form, Text::cli_opt_contour_format);
}

[[noreturn]] void refuse(Text text, std::string option, std::string value) {
  throw Failure({.text = text, .arguments = {{"option", std::move(option)}, {"value", std::move(value)}}});
}

double positive(std::string const& option, std::string const& word) {
  auto const value = parse_finite(word);
  if (!value || !(*value > 0)) refuse(Text::cli_bad_positive, option, word);
  return *value;
}

ContourRequest read_words(ContourWords const& words) {
  ContourRequest wanted;
  if (words.feeds) {
    wanted.feeds.clear();
    for (auto const& word : split_list(*words.feeds)) wanted.feeds.push_back(positive("--feed", word));
    if (wanted.feeds.empty()) refuse(Text::cli_bad_positive, "--feed", *words.feeds);
  }
  if (words.orders) {
    wanted.orders.clear();
    for (auto const& word : split_list(*words.orders)) {
      auto const order = parse_count(word);
      if (!order || *order > design::longest_kernel_order) {
        throw Failure(
            {.text = Text::cli_bad_orders,
             .arguments = {{"limit", std::to_string(design::longest_kernel_order)}, {"value", word}}});
      }
      wanted.orders.emplace_back(static_cast<std::uint32_t>(*order));
    }
    if (wanted.orders.empty()) {
      throw Failure(
          {.text = Text::cli_bad_orders,
           .arguments = {{"limit", std::to_string(design::longest_kernel_order)}, {"value", *words.orders}}});
    }
  }
  if (words.angle) {
    auto const angle = parse_finite(*words.angle);
    if (!angle || *angle < 0 || *angle > 180) {
      throw Failure({.text = Text::cli_bad_angle, .arguments = {{"value", *words.angle}}});
    }
    wanted.angle_deg = *angle;
  }
  if (words.radius) wanted.radius_mm = positive("--radius", *words.radius);
  if (words.tolerance) wanted.tolerance_mm = positive("--tolerance", *words.tolerance);
  return wanted;
}

}  // namespace

ExitStatus contour(Invocation const& invocation) {
  ContourWords words;
  CommandLine command_line("contour", Text::cli_contour_purpose, Text::cli_contour_examples,
                           invocation.language);
  declare(command_line, words);
  auto& out = invocation.streams.out;
  if (command_line.answers(invocation)) return ExitStatus::success;
  command_line.require(words.machine.has_value(), "MACHINE");
  auto const wanted = read_words(words);
  auto const checked =
      checked_machine(*words.machine, words.cycle_time, invocation, use_color(command_line.color(), system::Stream::error));
  if (!checked) return ExitStatus::findings;
  auto const& machine = checked->machine;
  auto const first = chosen_group(machine, words.group, *words.machine);

  ShownContour shown{.cycle_time_us = machine.cycle_time.microseconds(),
                     .angle_deg = wanted.angle_deg,
                     .radius_mm = wanted.radius_mm,
                     .groups = {}};
  for (std::size_t i = first; i < machine.groups.size(); ++i) {
    if (machine.groups[i].axes.empty()) continue;
    auto const commands =
        words.filter
            ? std::vector{read_filter_command(machine, machine.groups[i], *words.filter, invocation.language)}
            : filters_on();
    shown.groups.push_back(predict_contour(
        {.machine = machine, .group = i, .commands = commands, .path = *words.machine}, wanted));
    if (words.group) break;
  }
  switch (words.form) {
    case Form::text:
      out.write(contour_text(shown, invocation.language));
      break;
    case Form::csv:
      out.write(contour_csv(shown));
      break;
    case Form::json:
      out.write(contour_json(shown));
      break;
  }
  return ExitStatus::success;
}

}  // namespace axisc::cli
