#include "axisc/checking/checking_options.hpp"

#include "axisc/asked/finding_codes.hpp"
#include "axisc/asked/quantities.hpp"
#include "axisc/environment/failure.hpp"
#include "axisc/environment/sentences.hpp"
#include "diagnostics/ascii.hpp"
#include "diagnostics/format_number.hpp"
#include "schema/closest_word.hpp"
#include "validator/engine/rule.hpp"

#include <algorithm>
#include <thread>

namespace axisc::says {

constexpr Sentence bad_build{
    "\"{value}\" is not a build of the control; write V3.1.3075.04, V2.11.2803 or V3.00.3013",
    "\"{value}\" ist kein Stand der Steuerung; Schreibweise V3.1.3075.04, V2.11.2803 oder V3.00.3013"};
constexpr Sentence bad_cycle_time{
    "\"{value}\" is not a valid cycle time; write 1ms, 250us or 1000 (µs), in whole nanoseconds",
    "\"{value}\" ist keine gültige Zykluszeit; richtig ist 1ms, 250us oder 1000 (µs), in ganzen "
    "Nanosekunden"};
constexpr Sentence unusual_cycle_time{
    "{time}? A cycle time is between 20 µs and 100 ms; write {meant}",
    "{time}? Eine Zykluszeit liegt zwischen 20 µs und 100 ms; {meant} schreiben"};
constexpr Sentence unknown_code{"there is no code \"{code}\"; `axisc explain --all` lists them",
                                "den Code \"{code}\" gibt es nicht; `axisc explain --all` nennt alle"};
constexpr Sentence unknown_code_meant{"there is no code \"{code}\"; did you mean {meant}?",
                                      "den Code \"{code}\" gibt es nicht; war {meant} gemeint?"};

}  // namespace axisc::says

namespace axisc {

namespace {

constexpr std::uint64_t most_threads = 1024;

std::vector<Code> parse_codes(std::string const& word) {
  if (auto found = find_codes(word); !found.empty()) return found;
  std::vector<std::string> codes;
  for (auto const& rule : validator::rules()) {
    codes.push_back(code_text(rule.code));
    codes.emplace_back(rule.name);
  }
  std::vector<std::string_view> const known(codes.begin(), codes.end());
  auto const meant = schema::closest_word(word, known);
  throw Failure({meant.empty() ? says::unknown_code : says::unknown_code_meant,
                 {{"code", word}, {"meant", std::string(meant)}}});
}

std::vector<Code> codes_in(std::vector<std::string> const& lists) {
  std::vector<Code> codes;
  for (auto const& list : lists) {
    for (auto const& word : split_list(list)) {
      auto const found = parse_codes(word);
      codes.insert(codes.end(), found.begin(), found.end());
    }
  }
  return codes;
}

machine::AxisType parse_axis_type(std::string const& word) {
  auto const letter = ascii::upper_case(word);
  if (letter == "T") return machine::AxisType::translatory;
  if (letter == "R") return machine::AxisType::rotary;
  if (letter == "S") return machine::AxisType::spindle;
  throw Failure({says::bad_choice, {{"option", "--axis-type"}, {"value", word}, {"choices", "T, R, S"}}});
}

schema::ListKind parse_kind(std::string const& word) {
  if (auto const kind = schema::find_list_kind(&schema::ListKindRow::word, word)) return *kind;
  std::string words;
  for (auto const& row : schema::list_kind_rows) words.append(words.empty() ? "" : ", ").append(row.word);
  throw Failure({says::bad_choice, {{"option", "--kind"}, {"value", word}, {"choices", words}}});
}

}  // namespace

std::optional<design::CycleTime> asked_cycle_time(std::optional<std::string> const& word) {
  if (!word) return std::nullopt;
  auto const time = parse_cycle_time(*word);
  if (!time) throw Failure({says::bad_cycle_time, {{"value", *word}}});
  if (design::is_possible(*time)) return time;
  // A bare number was meant in milliseconds.
  auto const meant = parse_cycle_time(*word + "ms");
  bool const possible = meant && design::is_possible(*meant);
  throw Failure(
      {says::unusual_cycle_time,
       {{"time", exact_number(time->microseconds()) + " µs"}, {"meant", possible ? *word + "ms" : "1ms"}}});
}

Overrides overrides_with(std::optional<std::string> const& cycle_time,
                         std::vector<std::string> schema_files) {
  Overrides overrides{.schema_files = std::move(schema_files)};
  overrides.options.cycle_time = asked_cycle_time(cycle_time);
  return overrides;
}

validator::CheckOptions check_options(CheckingOptions const& given) {
  validator::CheckOptions options;
  options.pedantic = given.pedantic;
  options.cycle_time = asked_cycle_time(given.cycle_time);
  if (given.axis_type) options.axis_type = parse_axis_type(*given.axis_type);
  if (given.kind) options.kind = parse_kind(*given.kind);
  if (given.build) {
    options.build = validator::parse_build_version(*given.build);
    if (!options.build) throw Failure({says::bad_build, {{"value", *given.build}}});
  }
  options.disabled = codes_in(given.disabled);
  if (given.selected.empty()) return options;
  auto const selected = codes_in(given.selected);
  for (auto const& rule : validator::rules()) {
    // What could not be read or judged is always said.
    bool const is_of_run = code_text(rule.code).starts_with("AX9");
    bool const is_selected = std::find(selected.begin(), selected.end(), rule.code) != selected.end();
    if (!is_of_run && !is_selected) options.disabled.push_back(rule.code);
  }
  return options;
}

std::optional<unsigned> asked_threads(std::optional<std::string> const& threads) {
  if (!threads) return std::nullopt;
  auto const count = parse_count(*threads);
  if (!count || *count == 0 || *count > most_threads) {
    throw Failure({says::bad_count, {{"option", "-j"}, {"value", *threads}}});
  }
  return static_cast<unsigned>(*count);
}

unsigned thread_count(std::optional<unsigned> asked, std::size_t tasks) {
  if (asked) return *asked;
  return tasks <= 1 ? 1 : std::max(1U, std::thread::hardware_concurrency());
}

bool objectionable(CheckingOptions const& options, FindingCounts const& counts) {
  return counts.errors > 0 || (options.werror && counts.warnings > 0);
}

}  // namespace axisc
