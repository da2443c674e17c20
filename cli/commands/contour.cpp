#include "axisc/answers/contour/contour_answer.hpp"
#include "axisc/answers/contour/delay_budget_answer.hpp"
#include "axisc/checking/path_machine.hpp"
#include "axisc/environment/failure.hpp"
#include "cli/commands/commands.hpp"
#include "cli/commands/sentences.hpp"
#include "cli/options/check_options.hpp"
#include "cli/options/command_line.hpp"
#include "cli/options/contour_words.hpp"
#include "cli/options/sentences.hpp"
#include "cli/output/answer_output.hpp"
#include "cli/output/decimal_comma.hpp"
#include "cli/output/printed_errors.hpp"

namespace axisc::cli::says {

constexpr Sentence option_filter{
    R"(what the program commands, "#FILTER ON [ORDER=20]" or "#VIB GUARD ON")",
    R"(was das Programm kommandiert, "#FILTER ON [ORDER=20]" oder "#VIB GUARD ON")"};

constexpr Sentence option_budget{
    "what delays each axis, for position and feedforward, and what the difference costs at the first --feed",
    "was jede Achse verzögert, bei Position und Vorsteuerung, und was der Unterschied beim ersten --feed "
    "kostet"};

}  // namespace axisc::cli::says

namespace axisc::cli {

ExitStatus contour(Invocation const& invocation) {
  std::optional<std::string> input, cycle_time;
  ContourWords words;
  bool alone = false, wants_budget = false;
  ContourQuestion question;
  auto format = presentation::Format::text;
  CommandLine command_line("contour", invocation.language);
  command_line.argument("MACHINE", input, says::argument_input);
  declare_feeds(command_line, words);
  command_line.flag("--budget", wants_budget, says::option_budget);
  command_line.not_with("--budget");
  declare_orders(command_line, words);
  declare_angle(command_line, words);
  declare_radius(command_line, words);
  declare_tolerance(command_line, words);
  command_line.value("--filter", "COMMAND", question.filter, says::option_filter);
  command_line.value("--group", "NAME", question.group, says::option_group);
  command_line.not_with({});
  command_line.value("--cycle-time", "TIME", cycle_time, says::option_cycle_time);
  declare_alone(command_line, alone);
  declare_format(command_line, format);
  if (command_line.answers(invocation)) return ExitStatus::success;
  command_line.require(input.has_value(), "MACHINE");
  question.machine = *input;
  question.language = invocation.language;
  question.wanted = read_contour_words(words);
  remark_decimal_comma(invocation, "--feed", words.feeds);
  remark_decimal_comma(invocation, "--order", words.orders);
  Workspace workspace(overrides_with(cycle_time));
  MachineRequest const request{.input = *input, .alone = alone};
  auto const errors = printed_errors(invocation, use_color(command_line.color(), system::Stream::error));
  if (wants_budget) {
    auto const feed = words.feeds ? std::optional(question.wanted.feeds.front()) : std::nullopt;
    auto const document = delay_budget_answer(workspace, {.machine = request, .feed = feed}, errors);
    if (!document) return ExitStatus::findings;
    print(*document, format, invocation, command_line);
    return ExitStatus::success;
  }
  auto const checked = checked_machine(workspace, request, errors);
  if (!checked) return ExitStatus::findings;
  if (!question.group) question.group = checked->group;
  std::function<void(Message const&)> remark;
  if (words.feeds) remark = printed_remarks(invocation);
  print(contour_answer(question, checked->machine, remark), format, invocation, command_line);
  return ExitStatus::success;
}

}  // namespace axisc::cli
