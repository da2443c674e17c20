#include "validator/commands/keyword_value.hpp"

#include "diagnostics/format_number.hpp"
#include "grammar/number.hpp"
#include "schema/value.hpp"
#include "validator/commands/command_keywords.hpp"
#include "validator/commands/command_mistake.hpp"
#include "validator/sentences.hpp"

#include <cmath>
#include <string>

namespace axisc::validator::says {

constexpr Sentence filter_syntax_no_value{"the keyword `{keyword}` has no value",
                                          "das Schlüsselwort `{keyword}` hat keinen Wert"};
constexpr Sentence filter_syntax_no_number{"`{value}` is not a number, as `{keyword}` needs",
                                           "`{value}` ist keine Zahl, wie `{keyword}` sie braucht"};
constexpr Sentence filter_keyword_range{"`{keyword}={value}` is out of range",
                                        "`{keyword}={value}` liegt außerhalb des Bereichs"};
constexpr Sentence filter_keyword_range_whole{"{text}, a whole number", "{text}, ganzzahlig"};
constexpr Sentence filter_keyword_delay{
    "an axis of the channel has the time delay, which takes at most 100 cycles",
    "eine Achse des Kanals hat die Zeitverzögerung, die höchstens 100 Zyklen annimmt"};
constexpr Sentence guard_without_oscillation{
    "with `{keyword}={value}` there is no oscillation that the Vibration Guard could shape",
    "mit `{keyword}={value}` gibt es keine Schwingung, die der Vibration Guard formen könnte"};
constexpr Sentence filter_keyword_variable{
    "the value of `{keyword}` must be a number, not the variable `{value}`",
    "der Wert von `{keyword}` muss eine Zahl sein, nicht die Variable `{value}`"};

}  // namespace axisc::validator::says

namespace axisc::validator {
namespace {

using grammar::Keyword;
using grammar::KeywordValue;

/// `20,` as 20 and `0,01` as 0.01.
std::optional<std::string> number_meant(std::string value) {
  std::size_t const comma = value.find(',');
  if (comma == std::string::npos) return std::nullopt;
  if (comma + 1 == value.size()) {
    value.pop_back();
  } else {
    value[comma] = '.';
  }
  return schema::is_complete_number(value) ? std::optional(value) : std::nullopt;
}

void add_range_notes(CommandMistake& mistake, std::string const& name, double value,
                     KeywordRange const& range, CommandLimits const& limits) {
  mistake.label =
      Message{range.whole ? says::filter_keyword_range_whole : axisc::says::as_given, {{"text", range.text}}};
  mistake.control = range.control;
  if (range.control.empty()) mistake.reaction.reset();
  bool const order = name == "ORDER" || name == "ORDER_TIME";
  if (order && limits.time_delay) {
    mistake.notes.push_back({says::filter_keyword_delay});
  }
  if (order && value > *range.maximum) {
    mistake.control = "50911";
    mistake.reaction = says::filter_reaction_clipped;
    mistake.value = std::to_string(limits.longest_order());
  } else if (name == "FREQ" && value > range.minimum) {
    mistake.control = "50913";
  } else if (name == "ORDER_TIME") {
    mistake.control = "50910";
    mistake.reaction = says::filter_reaction_inactive;
    if (range.contains(value * 1000)) {
      std::string const replacement = "ORDER_TIME=" + format_exact(value * 1000);
      mistake.help.push_back(
          {says::milliseconds_meant, {{"value", exact_number(value)}, {"replacement", replacement}}});
    }
  }
  mistake.depends_on_cycle_time = range.depends_on_cycle_time;
}

}  // namespace

double number_of(std::string_view token) {
  return grammar::real_value(token).value_or(token.front() == '-' ? -HUGE_VAL : HUGE_VAL);
}

std::optional<double> checked_value(grammar::NcCommand const& command, Keyword const& keyword,
                                    std::string_view text, CommandLimits const& limits, Variables variables,
                                    CheckedCommand& checked) {
  std::string const name(slice(text, keyword.name));
  std::string const written(slice(text, keyword.value));
  auto const add = [&](Code code, Span span, SentenceRef sentence) -> CommandMistake& {
    return add_mistake(checked, command.kind, code, span, sentence, {{"keyword", name}, {"value", written}});
  };
  switch (keyword.kind) {
    case KeywordValue::none:
    case KeywordValue::missing:
      add_mistake(checked, command.kind, syntax_mistake, keyword.name, says::filter_syntax_no_value,
                  {{"keyword", name}});
      return std::nullopt;
    case KeywordValue::malformed:
      add(syntax_mistake, keyword.value, says::filter_syntax_no_number).better = number_meant(written);
      return std::nullopt;
    case KeywordValue::variable:
      if (variables == Variables::refused) add(keyword_mistake, keyword.value, says::filter_keyword_variable);
      return std::nullopt;
    case KeywordValue::integer:
    case KeywordValue::real: break;
  }
  double const value = number_of(written);
  KeywordRange const range = range_of(name, limits);
  if (name == "DAMPING" && value == 1) {
    CommandMistake& mistake = add(without_oscillation, keyword.value, says::guard_without_oscillation);
    mistake.control = no_guard;
    mistake.reaction = says::guard_stops_motion;
    return std::nullopt;
  }
  if (range.contains(value)) return value;
  add_range_notes(add(keyword_mistake, keyword.value, says::filter_keyword_range), name, value, range,
                  limits);
  // An ORDER_TIME below one cycle has a meaning: the filter is off.
  bool const has_meaning = name == "ORDER_TIME" && value >= 0 && value < range.minimum;
  return has_meaning ? std::optional(value) : std::nullopt;
}

}  // namespace axisc::validator
