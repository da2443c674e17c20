#include "editor/meaning/program_help.hpp"

#include "axisc/asked/filter_symbols.hpp"
#include "design/kernels/kernel_design.hpp"
#include "diagnostics/ascii.hpp"
#include "diagnostics/format_number.hpp"
#include "editor/meaning/guard_figures.hpp"
#include "editor/reading/requests.hpp"
#include "grammar/nc_program.hpp"
#include "validator/commands/command_check.hpp"
#include "validator/commands/command_keywords.hpp"
#include "validator/views/axis_delay.hpp"
#include "validator/views/guard_view.hpp"

#include <algorithm>
#include <array>

namespace axisc::editor::says {

constexpr Sentence axis_lists{"the axis lists' values", "die Werte der Achslisten"};
constexpr Sentence in_force{"In force from here: {parameters}.", "Ab hier gilt: {parameters}."};
constexpr Sentence filters_off{"FIR and HSC filters are off from here.",
                               "Ab hier sind FIR- und HSC-Filter aus."};
constexpr Sentence hsc{"Acts on the HSC filters alone.", "Wirkt nur auf die HSC-Filter."};
constexpr Sentence guards_off{"Vibration Guards are off from here.",
                              "Ab hier sind die Vibration Guards aus."};
constexpr Sentence axis_guard{"- {axis}: Vibration Guard, {figures}", "- {axis}: Vibration Guard, {figures}"};
constexpr Sentence axis_without_guard{"- {axis}: no Vibration Guard", "- {axis}: kein Vibration Guard"};
constexpr Sentence axis_kernel{"- {axis}: {kernel} of order {order}, delay {delay} ms",
                               "- {axis}: {kernel} der Ordnung {order}, Verzögerung {delay} ms"};
constexpr Sentence axis_without{"- {axis}: no FIR filter", "- {axis}: kein FIR-Filter"};

}  // namespace axisc::editor::says

namespace axisc::editor {

namespace {

std::string guard_of_axis(validator::LoadedAxis const& axis, design::CycleTime cycle_time,
                          machine::FilterParameters const& given, Language language) {
  auto const listed = validator::GuardView(axis.merged.values).specification(cycle_time);
  auto const guard = listed ? validator::guard_after(*listed, given) : std::nullopt;
  bool const is_there =
      guard && axis.type != machine::AxisType::spindle && validator::can_be_compiled(*guard, cycle_time);
  if (!is_there) return say(says::axis_without_guard, language, {{"axis", axis.name}});
  return say(says::axis_guard, language,
             {{"axis", axis.name}, {"figures", guard_text(*guard, axis, cycle_time, language)}});
}

std::string line_of_axis(validator::LoadedAxis const& axis, design::CycleTime cycle_time,
                         machine::FilterParameters const& given, Language language) {
  if (given.guard) return guard_of_axis(axis, cycle_time, given, language);
  auto const delay = validator::axis_delay(axis.merged.values, cycle_time);
  bool const has_kernel = delay && delay->kernel && delay->kernel->family == machine::KernelFamily::fir;
  if (!has_kernel) return say(says::axis_without, language, {{"axis", axis.name}});
  auto const specification = machine::with_parameters(delay->kernel->specification, given);
  bool const is_off = specification.order == 0 || (specification.type == design::KernelType::time_delay &&
                                                   specification.order > design::longest_kernel_delay);
  if (is_off) return say(says::axis_without, language, {{"axis", axis.name}});
  auto const design = design::design_kernel(specification, cycle_time);
  return say(says::axis_kernel, language,
             {{"axis", axis.name},
              {"kernel", text_of(kernel_symbol(specification.type).words, language)},
              {"order", std::to_string(specification.order)},
              {"delay",
               format_rounded(design.group_delay_cycles * cycle_time.microseconds() / 1000, shown_digits)}});
}

/// The end of the command: after `]`, or at the end of its line.
std::uint32_t end_of(grammar::NcCommand const& command, std::string_view text) {
  auto const line_end = std::min(text.find_first_of("\r\n", command.name.begin), text.size());
  auto const bracket = text.find(']', command.name.begin);
  return static_cast<std::uint32_t>(
      std::min(line_end, bracket == std::string_view::npos ? line_end : bracket + 1));
}

}  // namespace

std::optional<CommandHelp> command_help(std::string_view text, std::size_t offset,
                                        validator::LoadedMachine const* machine, Language language) {
  auto const program = grammar::parse_nc_program(text, 0);
  validator::CommandLimits limits;
  if (machine != nullptr && machine->cycle_time) limits.cycle_time = *machine->cycle_time;
  if (machine != nullptr) limits.readings = machine->readings;
  machine::FilterParameters in_force;
  for (auto const& command : program.commands) {
    if (command.name.begin > offset) break;
    auto const checked = validator::check_command(command, text, limits, validator::Variables::accepted);
    auto const end = end_of(command, text);
    bool const is_here = offset <= end;
    if (!checked.command) {
      if (is_here) return std::nullopt;
      continue;
    }
    in_force = machine::parameters_after(in_force, *checked.command);
    if (!is_here) continue;
    CommandHelp help{.text = {}, .begin = command.name.begin, .end = end};
    if (checked.command->filter_switch == machine::FilterSwitch::off) {
      help.text =
          say(checked.command->parameters.guard ? says::guards_off : says::filters_off, language) + "\n";
    } else if (checked.command->hsc) {
      help.text = say(says::hsc, language) + "\n";
    } else {
      auto const parameters = in_force.empty() ? say(says::axis_lists, language) : to_text(in_force);
      help.text = say(says::in_force, language, {{"parameters", parameters}}) + "\n";
      if (machine != nullptr && !machine->axes.empty()) help.text += "\n";
      for (std::size_t i = 0; machine != nullptr && i < machine->axes.size(); ++i) {
        help.text += line_of_axis(machine->axes[i], limits.cycle_time, in_force, language) + "\n";
      }
    }
    return help;
  }
  return std::nullopt;
}

namespace {

/// The words of one line; a command is the word that it begins with.
class LineWords final : public grammar::ProgramListener {
 public:
  void word(grammar::Word const& word) override { spans.push_back(word.span); }
  void command(grammar::NcCommand command) override { spans.push_back(command.name); }
  void directive(grammar::Directive const& /*directive*/) override {}

  std::vector<Span> spans;
};

}  // namespace

std::optional<MotionWordPlace> motion_word_at(std::string_view text, std::size_t offset) {
  if (offset > text.size()) return std::nullopt;
  std::size_t const before = offset == 0 ? std::string_view::npos : text.find_last_of("\r\n", offset - 1);
  std::size_t const begin = before == std::string_view::npos ? 0 : before + 1;
  std::size_t const end = std::min(text.find_first_of("\r\n", offset), text.size());
  LineWords line;
  grammar::ProgramReader reader(line, grammar::ProgramDetail::words);
  reader.line(text.substr(begin, end - begin), static_cast<std::uint32_t>(begin));
  reader.finish();
  std::vector<std::string_view> words;
  for (Span const& span : line.spans) words.push_back(text.substr(span.begin, span.size()));
  for (std::size_t i = 0; i < words.size(); ++i) {
    bool const is_command = words[i].starts_with('#');
    auto const* const found = is_command ? schema::find_motion_word(std::span(words).subspan(i))
                              : words[i].starts_with('G') ? schema::find_motion_word(words[i])
                                                          : nullptr;
    if (found == nullptr) continue;
    Span const last = line.spans[i + schema::length_of(*found) - 1];
    if (offset >= line.spans[i].begin && offset <= last.end) {
      return MotionWordPlace{.word = found, .begin = line.spans[i].begin, .end = last.end};
    }
  }
  return std::nullopt;
}

std::vector<std::string> command_words(std::string_view typed) {
  std::vector<std::string> words;
  auto const hash = typed.rfind('#');
  if (hash == std::string_view::npos) return words;
  auto const command = typed.substr(hash);
  constexpr std::array names = {std::string_view("#FILTER"), std::string_view("#VIB GUARD")};
  for (auto const name : names) {
    if (!ascii::equal_ignoring_case(command.substr(0, name.size()), name)) {
      if (ascii::equal_ignoring_case(name.substr(0, command.size()), command)) words.emplace_back(name);
      continue;
    }
    auto const kind = name == names[0] ? grammar::CommandKind::filter : grammar::CommandKind::vibration_guard;
    auto const rest = command.substr(name.size());
    if (rest.find('[') == std::string_view::npos) return {"ON", "OFF", "["};
    if (rest.find(']') != std::string_view::npos) return {};
    for (auto const keyword : validator::keywords_of(kind)) words.push_back(std::string(keyword) + "=");
    if (kind == grammar::CommandKind::filter) words.emplace_back("HSC");
    return words;
  }
  return words;
}

}  // namespace axisc::editor
