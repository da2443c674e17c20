#include "validator/commands/command_check.hpp"

#include "diagnostics/ascii.hpp"
#include "diagnostics/joined.hpp"
#include "schema/closest_word.hpp"
#include "validator/commands/command_keywords.hpp"
#include "validator/commands/command_mistake.hpp"
#include "validator/commands/keyword_value.hpp"
#include "validator/commands/resembling_command.hpp"
#include "validator/sentences.hpp"

#include <algorithm>
#include <array>
#include <utility>

namespace axisc::validator::says {

constexpr Sentence filter_syntax_letter_case{"`{text}` is written in capitals: `{command}`",
                                             "`{text}` wird groß geschrieben: `{command}`"};
constexpr Sentence filter_syntax_unexpected{"`{text}` does not belong in the command `{command}`",
                                            "`{text}` gehört nicht in den Befehl `{command}`"};
constexpr Sentence filter_syntax_expected_keyword{
    "expected a keyword or `]`, not `{text}`",
    "hier wird ein Schlüsselwort oder `]` erwartet, nicht `{text}`"};
constexpr Sentence filter_syntax_unclosed{"this bracket of `{command}` is not closed",
                                          "diese Klammer von `{command}` ist nicht geschlossen"};
constexpr Sentence filter_syntax_switch_in_brackets{"`{switch}` is written before the brackets",
                                                    "`{switch}` steht vor den Klammern"};
constexpr Sentence filter_syntax_no_value_allowed{"the keyword `{keyword}` takes no value",
                                                  "das Schlüsselwort `{keyword}` nimmt keinen Wert an"};
constexpr Sentence filter_syntax_no_filter_command{"this is neither #FILTER nor #VIB GUARD",
                                                   "das ist weder #FILTER noch #VIB GUARD"};
constexpr Sentence filter_keyword_unknown{"`{command}` has no keyword `{keyword}`",
                                          "`{command}` hat kein Schlüsselwort `{keyword}`"};
constexpr Sentence filter_keyword_known{"keywords: {keywords}", "Schlüsselwörter: {keywords}"};
constexpr Sentence filter_keyword_repeated{"the keyword `{keyword}` occurs twice in one command",
                                           "das Schlüsselwort `{keyword}` steht in einem Befehl zweimal"};
constexpr Sentence filter_keyword_beside_hsc{"`{keyword}` together with `HSC` is not supported",
                                             "`{keyword}` zusammen mit `HSC` wird nicht unterstützt"};

}  // namespace axisc::validator::says

namespace axisc::validator {
namespace {

using grammar::CommandKind;
using grammar::CommandProblemKind;
using grammar::CommandSwitch;
using grammar::Keyword;
using grammar::KeywordValue;
using grammar::NcCommand;

constexpr std::string_view hsc = "HSC";

/// ON or OFF for a word that means it: in other letters, or in German; empty for other words.
std::string_view switch_meant(std::string_view word) {
  constexpr std::array<std::pair<std::string_view, std::string_view>, 5> words{
      {{"ON", "ON"}, {"OFF", "OFF"}, {"EIN", "ON"}, {"AN", "ON"}, {"AUS", "OFF"}}};
  auto const* const known = std::find_if(words.begin(), words.end(), [word](auto const& row) {
    return ascii::equal_ignoring_case(word, row.first);
  });
  return known == words.end() ? std::string_view() : known->second;
}

SentenceRef text_of(CommandProblemKind kind) {
  switch (kind) {
    case CommandProblemKind::letter_case: return says::filter_syntax_letter_case;
    case CommandProblemKind::unexpected_text: return says::filter_syntax_unexpected;
    case CommandProblemKind::expected_keyword: return says::filter_syntax_expected_keyword;
    case CommandProblemKind::unclosed_bracket: return says::filter_syntax_unclosed;
  }
  return says::filter_syntax_unexpected;
}

class CommandChecker {
 public:
  CommandChecker(NcCommand const& command, std::string_view text, CommandLimits const& limits,
                 Variables variables)
      : command_(command), text_(text), limits_(limits), variables_(variables) {}

  CheckedCommand check() {
    if (command_.kind == CommandKind::other) {
      check_resembling(command_, text_, checked_);
      return std::move(checked_);
    }
    check_structure();
    hsc_ = command_.kind == CommandKind::filter && means_hsc(command_, text_);
    result_.hsc = hsc_;
    for (std::size_t i = check_switch_in_brackets() ? 1 : 0; i < command_.keywords.size(); ++i) {
      if (check_separated(i)) {
        ++i;
      } else {
        check_keyword(i);
      }
    }
    if (command_.command_switch == CommandSwitch::on) result_.filter_switch = machine::FilterSwitch::on;
    if (command_.command_switch == CommandSwitch::off) result_.filter_switch = machine::FilterSwitch::off;
    checked_.filter_switch = result_.filter_switch;
    checked_.hsc = hsc_;
    if (usable_) checked_.command = finished();
    std::stable_sort(
        checked_.mistakes.begin(), checked_.mistakes.end(),
        [](CommandMistake const& a, CommandMistake const& b) { return a.span.begin < b.span.begin; });
    return std::move(checked_);
  }

 private:
  CommandMistake& add(Code code, Span span, SentenceRef text, std::vector<Argument> arguments = {}) {
    return add_mistake(checked_, command_.kind, code, span, text, std::move(arguments));
  }

  [[nodiscard]] std::string word(Span span) const { return std::string(slice(text_, span)); }

  /// `ORDER=20 SHARE=80` without brackets: all of it.
  [[nodiscard]] Span keywords_from(std::uint32_t begin) const {
    std::uint32_t end = begin;
    for (std::string_view rest = text_.substr(begin); !rest.empty();) {
      std::size_t const name = std::min(rest.find_first_not_of("ABCDEFGHIJKLMNOPQRSTUVWXYZ_"), rest.size());
      if (name == 0 || name == rest.size() || rest[name] != '=') break;
      std::size_t const size = std::min(rest.find_first_of(" \t\r\n([;", name), rest.size());
      end = static_cast<std::uint32_t>(rest.data() + size - text_.data());
      rest.remove_prefix(std::min(rest.find_first_not_of(" \t", size), rest.size()));
    }
    return {.begin = begin, .end = end};
  }

  /// `#filter on`: one fix writes both words.
  void take_switch(CommandMistake& mistake) {
    std::string_view const rest = text_.substr(mistake.span.end);
    std::size_t const begin = std::min(rest.find_first_not_of(" \t"), rest.size());
    std::size_t const end = std::min(rest.find_first_of(" \t\r\n([;", begin), rest.size());
    std::string_view const word = rest.substr(begin, end - begin);
    std::string_view const meant = switch_meant(word);
    if (meant.empty() || word == meant) return;
    usable_ = false;
    mistake.span.end += static_cast<std::uint32_t>(end);
    mistake.better->append(rest.substr(0, begin)).append(meant);
    mistake.message.arguments = {{"command", *mistake.better},
                                 {"text", std::string(slice(text_, mistake.span))}};
  }

  /// `[ON ORDER=20]`: the switch is before the brackets.
  bool check_switch_in_brackets() {
    if (command_.keywords.empty() || command_.keywords[0].kind != KeywordValue::none) return false;
    Span const name = command_.keywords[0].name;
    std::string_view const meant = switch_meant(slice(text_, name));
    std::size_t const opening = text_.substr(0, name.begin).rfind('[');
    if (meant.empty() || opening == std::string_view::npos) return false;
    bool const is_alone = command_.keywords.size() == 1;
    std::size_t const after = std::min(text_.find_first_not_of(" \t", name.end), text_.size());
    if (is_alone && text_.substr(after, 1) != "]") return false;
    usable_ = false;
    std::size_t const end = is_alone ? after + 1 : command_.keywords[1].name.begin;
    CommandMistake& mistake =
        add(syntax_mistake,
            {.begin = static_cast<std::uint32_t>(opening), .end = static_cast<std::uint32_t>(end)},
            says::filter_syntax_switch_in_brackets, {{"switch", std::string(meant)}});
    mistake.better = std::string(meant) + (is_alone ? "" : " [");
    return true;
  }

  void check_structure() {
    if (!command_.problem || follows_keyword_without_value()) return;
    std::string const proper(proper_name(command_.kind));
    CommandMistake& mistake = add(syntax_mistake, command_.problem->span, text_of(command_.problem->kind),
                                  {{"command", proper}, {"text", word(command_.problem->span)}});
    if (command_.problem->kind == CommandProblemKind::letter_case) {
      mistake.better = proper;
      take_switch(mistake);
    } else {
      usable_ = false;
      std::string_view const written = slice(text_, command_.problem->span);
      std::string_view const meant = switch_meant(written);
      if (!meant.empty() && meant != written) mistake.better = meant;
      Span const keywords = keywords_from(command_.problem->span.begin);
      bool const lacks_brackets = command_.problem->kind == CommandProblemKind::unexpected_text &&
                                  command_.keywords.empty() && !keywords.empty();
      if (!lacks_brackets) return;
      mistake.span = keywords;
      mistake.better = "[" + word(keywords) + "]";
    }
  }

  /// `AX DEV=0.01`: two words that are one keyword.
  bool check_separated(std::size_t index) {
    if (index + 1 == command_.keywords.size() || command_.keywords[index].kind != KeywordValue::none) {
      return false;
    }
    Span const span{.begin = command_.keywords[index].name.begin,
                    .end = command_.keywords[index + 1].name.end};
    std::string const joined =
        word(command_.keywords[index].name) + "_" + word(command_.keywords[index + 1].name);
    std::vector<std::string_view> const& known = keywords_of(command_.kind);
    if (std::find(known.begin(), known.end(), joined) == known.end()) return false;
    usable_ = false;
    add(keyword_mistake, span, says::filter_keyword_unknown,
        {{"keyword", word(span)}, {"command", std::string(proper_name(command_.kind))}})
        .better = joined;
    return true;
  }

  void check_keyword(std::size_t index) {
    Keyword const& keyword = command_.keywords[index];
    std::string const name = word(keyword.name);
    std::vector<std::string_view> const& known = keywords_of(command_.kind);
    bool const is_hsc = command_.kind == CommandKind::filter && name == hsc;
    if (!is_hsc && std::find(known.begin(), known.end(), name) == known.end()) {
      unknown(keyword, name, known);
    } else if (Keyword const* const first = earlier(index, name)) {
      CommandMistake& mistake =
          add(keyword_mistake, keyword.name, says::filter_keyword_repeated, {{"keyword", name}});
      mistake.first = first->name;
      mistake.control = keyword_repeated;
    } else if (is_hsc) {
      check_hsc(keyword);
    } else if (hsc_) {
      beside_hsc(keyword, name);
    } else {
      auto const value = checked_value(command_, keyword, text_, limits_, variables_, checked_);
      usable_ = usable_ && value;
      if (value) take(name, *value);
    }
  }

  void check_hsc(Keyword const& keyword) {
    if (keyword.kind == KeywordValue::none) return;
    usable_ = false;
    add(syntax_mistake, keyword.name, says::filter_syntax_no_value_allowed, {{"keyword", std::string(hsc)}});
  }

  void unknown(Keyword const& keyword, std::string const& name, std::vector<std::string_view> const& known) {
    usable_ = false;
    CommandMistake& mistake = add(keyword_mistake, keyword.name, says::filter_keyword_unknown,
                                  {{"keyword", name}, {"command", std::string(proper_name(command_.kind))}});
    std::string all = joined(known);
    if (command_.kind == CommandKind::filter) all.append(", ").append(hsc);
    mistake.notes.push_back({says::filter_keyword_known, {{"keywords", std::move(all)}}});
    std::string_view const closest = schema::closest_word(name, known);
    if (closest.empty()) return;
    mistake.better = closest;
    mistake.help.push_back({says::parameter_did_you_mean, {{"suggestion", std::string(closest)}}});
  }

  [[nodiscard]] Keyword const* earlier(std::size_t index, std::string_view name) const {
    for (std::size_t i = 0; i < index; ++i) {
      if (slice(text_, command_.keywords[i].name) == name) return &command_.keywords[i];
    }
    return nullptr;
  }

  void beside_hsc(Keyword const& keyword, std::string const& name) {
    usable_ = false;
    if (std::exchange(beside_hsc_reported_, true)) return;
    add(keyword_mistake, keyword.name, says::filter_keyword_beside_hsc, {{"keyword", name}});
  }

  void take(std::string_view name, double value) {
    machine::FilterParameters& parameters = result_.parameters;
    if (name == "ORDER") parameters.order = static_cast<std::uint32_t>(value);
    if (name == "ORDER_TIME") order_of_time_ = design::order_of_time({value}, limits_.cycle_time).value_or(0);
    if (name == "SHARE") parameters.share_percent = value;
    if (name == "FCUT") parameters.frequency = design::Hertz{value};
    if (name == "QUALITY") parameters.quality = value;
    if (name == "MODE") parameters.order = static_cast<std::uint32_t>(value);
    if (name == "FREQ") parameters.frequency = design::Hertz{value};
    if (name == "DAMPING") parameters.quality = value;
    if (name == "AX_DEV") result_.tolerance = value;
    if (name == "ACC_FACT") result_.acceleration_factor = value;
  }

  machine::FilterCommand finished() {
    if (command_.kind == CommandKind::vibration_guard) {
      result_.parameters.guard = true;
      if (!result_.tolerance && command_.command_switch != CommandSwitch::off) result_.tolerance = 0;
      return result_;
    }
    if (!result_.parameters.order) result_.parameters.order = order_of_time_;
    return result_;
  }

  /// `[ORDER 20]` is one mistake: reported as the keyword without value.
  [[nodiscard]] bool follows_keyword_without_value() const {
    if (command_.keywords.empty() || command_.problem->kind == CommandProblemKind::letter_case) return false;
    Keyword const& last = command_.keywords.back();
    bool const complete = last.kind != KeywordValue::none && last.kind != KeywordValue::missing &&
                          last.kind != KeywordValue::malformed;
    return !complete && slice(text_, last.name) != hsc;
  }

  NcCommand const& command_;
  std::string_view text_;
  CommandLimits const& limits_;
  Variables variables_;
  CheckedCommand checked_;
  machine::FilterCommand result_;
  std::optional<std::uint32_t> order_of_time_;
  bool hsc_ = false;
  bool beside_hsc_reported_ = false;
  bool usable_ = true;
};

}  // namespace

CheckedCommand check_command(NcCommand const& command, std::string_view text, CommandLimits const& limits,
                             Variables variables) {
  return CommandChecker(command, text, limits, variables).check();
}

CheckedCommand parse_filter_command(std::string_view text, CommandLimits const& limits) {
  std::optional<NcCommand> const command = grammar::parse_nc_command(text);
  if (command && command->kind != CommandKind::other && command->kind != CommandKind::axis_exchange) {
    return check_command(*command, text, limits, Variables::refused);
  }
  CheckedCommand none;
  CommandMistake& mistake = none.mistakes.emplace_back();
  mistake.code = syntax_mistake;
  mistake.span = command ? command->name : Span{.begin = 0, .end = static_cast<std::uint32_t>(text.size())};
  mistake.message = {says::filter_syntax_no_filter_command};
  mistake.notes.push_back(syntax_of(CommandKind::filter));
  return none;
}

Keyword const* find_keyword(NcCommand const& command, std::string_view text, std::string_view name) {
  auto const found = std::find_if(command.keywords.begin(), command.keywords.end(),
                                  [&](Keyword const& known) { return slice(text, known.name) == name; });
  return found == command.keywords.end() ? nullptr : &*found;
}

bool means_hsc(NcCommand const& command, std::string_view text) {
  return find_keyword(command, text, hsc) != nullptr;
}

bool gives_order(NcCommand const& command, std::string_view text) {
  bool const switches_off = command.command_switch == CommandSwitch::off;
  if (command.kind != CommandKind::filter || switches_off || means_hsc(command, text)) return false;
  Keyword const* const order = find_keyword(command, text, "ORDER");
  if (order == nullptr) return find_keyword(command, text, "ORDER_TIME") != nullptr;
  bool const number = order->kind == KeywordValue::integer || order->kind == KeywordValue::real;
  return !number || number_of(slice(text, order->value)) != 0;
}

}  // namespace axisc::validator
