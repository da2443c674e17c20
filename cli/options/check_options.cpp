#include "cli/options/check_options.hpp"

#include "cli/failure.hpp"
#include "cli/options/finding_codes.hpp"
#include "cli/options/quantities.hpp"
#include "diagnostics/ascii.hpp"
#include "schema/closest_word.hpp"
#include "validator/engine/rule.hpp"

#include <algorithm>
#include <thread>

namespace axisc::cli {

namespace {

constexpr std::uint64_t most_threads = 1024;

Code parse_code(std::string const& word) {
  std::vector<std::string> codes;
  if (auto const code = find_code(word)) return *code;
  for (auto const& rule : validator::rules()) {
    codes.push_back(code_text(rule.code));
    codes.emplace_back(rule.name);
  }
  std::vector<std::string_view> const known(codes.begin(), codes.end());
  auto const meant = schema::closest_word(word, known);
  throw Failure({.text = meant.empty() ? Text::cli_unknown_code : Text::cli_unknown_code_meant,
                 .arguments = {{"code", word}, {"meant", std::string(meant)}}});
}

machine::AxisType parse_axis_type(std::string const& word) {
  auto const letter = ascii::upper_case(word);
  if (letter == "T") return machine::AxisType::translatory;
  if (letter == "R") return machine::AxisType::rotary;
  if (letter == "S") return machine::AxisType::spindle;
  throw Failure({.text = Text::cli_bad_choice,
                 .arguments = {{"option", "--axis-type"}, {"value", word}, {"choices", "T, R, S"}}});
}

}  // namespace

void declare_checking(CommandLine& command_line, CheckingWords& words) {
  command_line.value("--cycle-time", "TIME", words.cycle_time, Text::cli_opt_cycle_time);
  command_line.value("--axis-type", "T|R|S", words.axis_type, Text::cli_opt_axis_type);
  command_line.value("--build", "VERSION", words.build, Text::cli_opt_build);
  command_line.choice("--format",
                      {{"text", FindingFormat::text},
                       {"json", FindingFormat::json},
                       {"sarif", FindingFormat::sarif},
                       {"github", FindingFormat::github},
                       {"gitlab", FindingFormat::gitlab}},
                      words.format, Text::cli_opt_finding_format);
  command_line.flag("--werror", words.werror, Text::cli_opt_werror);
  command_line.values("--disable", "CODE[,CODE]", words.disabled, Text::cli_opt_disable);
  declare_schema(command_line, words.schema_files);
  command_line.flag("--pedantic", words.pedantic, Text::cli_opt_pedantic);
  declare_threads(command_line, words.threads);
  command_line.flag("-q,--quiet", words.quiet, Text::cli_opt_quiet);
}

void declare_schema(CommandLine& command_line, std::vector<std::string>& files) {
  command_line.values("--schema", "FILE", files, Text::cli_opt_schema);
}

void declare_threads(CommandLine& command_line, std::optional<std::string>& threads) {
  command_line.value("-j,--jobs", "N", threads, Text::cli_opt_jobs);
}

std::optional<design::CycleTime> asked_cycle_time(std::optional<std::string> const& word) {
  if (!word) return std::nullopt;
  auto const time = parse_cycle_time(*word);
  if (!time) throw Failure({.text = Text::cli_bad_cycle_time, .arguments = {{"value", *word}}});
  return time;
}

validator::CheckOptions check_options(CheckingWords const& words) {
  validator::CheckOptions options;
  options.pedantic = words.pedantic;
  options.cycle_time = asked_cycle_time(words.cycle_time);
  if (words.axis_type) options.axis_type = parse_axis_type(*words.axis_type);
  if (words.build) {
    options.build = validator::parse_build_version(*words.build);
    if (!options.build) throw Failure({.text = Text::cli_bad_build, .arguments = {{"value", *words.build}}});
  }
  for (auto const& list : words.disabled) {
    for (auto const& word : split_list(list)) options.disabled.push_back(parse_code(word));
  }
  return options;
}

std::optional<unsigned> asked_threads(std::optional<std::string> const& threads) {
  if (!threads) return std::nullopt;
  auto const count = parse_count(*threads);
  if (!count || *count == 0 || *count > most_threads) {
    throw Failure({.text = Text::cli_bad_count, .arguments = {{"option", "-j"}, {"value", *threads}}});
  }
  return static_cast<unsigned>(*count);
}

unsigned thread_count(std::optional<unsigned> asked, std::size_t tasks) {
  if (asked) return *asked;
  return tasks <= 1 ? 1 : std::max(1U, std::thread::hardware_concurrency());
}

bool objectionable(CheckingWords const& words, FindingCounts const& counts) {
  return counts.errors > 0 || (words.werror && counts.warnings > 0);
}

}  // namespace axisc::cli
