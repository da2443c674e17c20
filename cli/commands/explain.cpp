#include "axisc/answers/explain/explain_formats.hpp"
#include "axisc/asked/finding_codes.hpp"
#include "axisc/asked/quantities.hpp"
#include "axisc/environment/codes.hpp"
#include "axisc/environment/failure.hpp"
#include "axisc/settings/settings.hpp"
#include "cli/commands/commands.hpp"
#include "cli/options/check_options.hpp"
#include "cli/options/command_line.hpp"
#include "configuration/list_kind.hpp"
#include "diagnostics/ascii.hpp"
#include "schema/closest_word.hpp"
#include "schema/descriptions/description.hpp"

namespace axisc::cli::says {

constexpr Sentence unknown_subject{
    "\"{word}\" is not a code, a message of the control, a parameter or a part of one; `axisc explain --all` "
    "lists the codes",
    "\"{word}\" ist weder ein Code noch eine Meldung der Steuerung noch ein Parameter oder ein Teil davon; "
    "`axisc explain --all` nennt die Codes"};
constexpr Sentence unknown_subject_meant{
    "\"{word}\" is not a code, a message of the control, a parameter or a part of one; did you mean {meant}?",
    "\"{word}\" ist weder ein Code noch eine Meldung der Steuerung noch ein Parameter oder ein Teil davon; "
    "war "
    "{meant} gemeint?"};
constexpr Sentence argument_subject{
    "a code (AX3005), its name, a number (P-AXIS-00140), a parameter (filter[0].order), a part of one, or a "
    "message number of the control",
    "ein Code (AX3005), sein Name, eine Nummer (P-AXIS-00140), ein Parameter (filter[0].order), ein Teil "
    "davon "
    "oder eine Meldungsnummer der Steuerung"};
constexpr Sentence option_format{"output format (default: markdown)",
                                 "Ausgabeformat (Standardwert: markdown)"};
constexpr Sentence option_all{"every code in one Markdown document", "alle Codes in einem Markdown-Dokument"};

}  // namespace axisc::cli::says

namespace axisc::cli {

namespace {

/// Of axis lists with what schema files add, then of the other kinds.
using Catalogues = std::vector<schema::Catalogue>;

Catalogues all_catalogues(schema::Catalogue of_axes) {
  Catalogues catalogues{std::move(of_axes)};
  for (auto const& row : schema::list_kind_rows) {
    if (row.kind != schema::ListKind::axis) catalogues.push_back(schema::Catalogue::of(row.kind));
  }
  return catalogues;
}

/// By code ("AX3005", "ax3005", "3005") or name ("delay-too-long").
validator::Rule const* rule_of(std::string const& word) {
  auto const code = find_code(word);
  auto const by_number = code ? code : find_code("AX" + word);
  return by_number ? validator::find_rule(*by_number) : nullptr;
}

/// Rows with the number in "P-AXIS-00140" or "P-CHAN-00035". The number may stand alone for a parameter of axes; zeros in
/// front may be missing.
std::vector<schema::Parameter const*> rows_of_number(Catalogues const& catalogues, std::string const& word) {
  auto const text = ascii::upper_case(word);
  std::vector<schema::Parameter const*> rows;
  for (auto const& catalogue : catalogues) {
    auto const prefix = configuration::number_prefix(catalogue.kind()) + "-";
    bool const has_prefix = text.starts_with(prefix);
    if (!has_prefix && catalogue.kind() != schema::ListKind::axis) continue;
    auto const number = parse_count(std::string_view(text).substr(has_prefix ? prefix.size() : 0));
    if (!number || *number > 0xFFFFU) continue;
    for (auto const id : catalogue.find_number(static_cast<std::uint16_t>(*number))) {
      rows.push_back(&catalogue.parameter(id));
    }
  }
  return rows;
}

/// `filter[2].order` and `filter[].order` both name a row of the catalogue.
schema::Parameter const* row_of_name(schema::Catalogue const& catalogue, std::string const& word) {
  for (auto const& parameter : catalogue.parameters()) {
    if (parameter.name == word) return &parameter;
  }
  return catalogue.find(word).row;
}

/// Those of axis lists, else of the other kinds: several of them may know one name.
std::vector<schema::Parameter const*> rows_of_name(Catalogues const& catalogues, std::string const& word) {
  std::vector<schema::Parameter const*> rows;
  for (auto const& catalogue : catalogues) {
    if (auto const* const row = row_of_name(catalogue, word)) rows.push_back(row);
    if (!rows.empty() && catalogue.kind() == schema::ListKind::axis) break;
  }
  return rows;
}

[[noreturn]] void refuse(schema::Catalogue const& catalogue, std::string const& word) {
  std::string meant;
  // Of a single word everything is similar to some name.
  auto const names =
      word.find('.') == std::string::npos ? std::vector<std::string>() : catalogue.suggest_names(word).names;
  if (!names.empty()) meant = names.front();
  if (meant.empty()) {
    std::vector<std::string> texts;
    for (auto const& rule : validator::rules()) {
      texts.push_back(code_text(rule.code));
      texts.emplace_back(rule.name);
    }
    std::vector<std::string_view> const known(texts.begin(), texts.end());
    meant = schema::closest_word(word, known);
  }
  throw Failure({.sentence = meant.empty() ? says::unknown_subject : says::unknown_subject_meant,
                 .arguments = {{"word", word}, {"meant", meant}}});
}

enum class Format : std::uint8_t { markdown, json };

/// The subject that the user named.
struct Subject {
  std::vector<validator::Rule const*> rules;
  std::vector<schema::Parameter const*> parameters;
  std::string message;  ///< number of the control, which `foretelling` name
  std::vector<validator::Rule const*> foretelling;
  bool searched = false;  ///< `parameters` are those that contain the word
};

/// "50663" is in "50663/60311/70451".
bool foretells(validator::Rule const& rule, std::string const& number) {
  return ("/" + std::string(rule.control) + "/").find("/" + number + "/") != std::string::npos;
}

/// Upper and lower case are equal; the meaning counts where no name contains the word.
std::vector<schema::Parameter const*> parameters_with(schema::Catalogue const& catalogue,
                                                      std::string const& word, Language language) {
  auto const wanted = ascii::lower_case(word);
  auto const search = [&](auto const& text_of) {
    std::vector<schema::Parameter const*> found;
    for (auto const& parameter : catalogue.parameters()) {
      if (ascii::lower_case(text_of(parameter)).find(wanted) != std::string::npos) {
        found.push_back(&parameter);
      }
    }
    return found;
  };
  constexpr std::size_t shortest = 3;
  if (word.size() < shortest) return {};
  auto found = search([](schema::Parameter const& parameter) { return std::string(parameter.name); });
  if (!found.empty()) return found;
  return search([&](schema::Parameter const& parameter) {
    return std::string(schema::description_of(parameter).what.in(language));
  });
}

Subject subject_of(Catalogues const& catalogues, std::string const& word, Language language) {
  Subject subject;
  if (auto const* const rule = rule_of(word)) subject.rules.push_back(rule);
  for (auto const& rule : validator::rules()) {
    if (!foretells(rule, word)) continue;
    subject.message = word;
    subject.foretelling.push_back(&rule);
  }
  if (!subject.rules.empty() || !subject.foretelling.empty()) return subject;
  subject.parameters = rows_of_number(catalogues, word);
  if (subject.parameters.empty()) subject.parameters = rows_of_name(catalogues, word);
  if (!subject.parameters.empty()) return subject;
  subject.searched = true;
  for (auto const& catalogue : catalogues) {
    auto const found = parameters_with(catalogue, word, language);
    subject.parameters.insert(subject.parameters.end(), found.begin(), found.end());
    if (!subject.parameters.empty() && catalogue.kind() == schema::ListKind::axis) break;
  }
  if (!subject.parameters.empty()) return subject;
  refuse(catalogues.front(), word);
}

Subject everything(schema::Catalogue const& catalogue) {
  Subject subject;
  for (auto const& rule : validator::rules()) subject.rules.push_back(&rule);
  for (auto const& parameter : catalogue.parameters()) subject.parameters.push_back(&parameter);
  return subject;
}

std::string explain_markdown(schema::Catalogue const& catalogue, Subject const& subject, Language language) {
  std::string text;
  for (auto const* const rule : subject.rules) text += explain_rule(*rule, 1, language);
  if (!subject.message.empty()) {
    if (!text.empty()) text += "\n";
    text += explain_message(subject.message, subject.foretelling, language);
  }
  if (subject.searched) return list_parameters(subject.parameters, language);
  for (auto const* const parameter : subject.parameters) {
    if (!text.empty()) text += "\n";
    text += explain_parameter(catalogue, *parameter, language);
  }
  return text;
}

}  // namespace

ExitStatus explain(Invocation const& invocation) {
  std::optional<std::string> word;
  bool all = false;
  Format format = Format::markdown;
  CommandLine command_line("explain", invocation.language);
  command_line.argument("CODE|P-AXIS-NNNNN|PARAMETER|MESSAGE|WORD", word, says::argument_subject);
  command_line.flag("--all", all, says::option_all);
  command_line.choice("--format", {{"markdown", Format::markdown}, {"json", Format::json}}, format,
                      says::option_format);
  std::vector<std::string> schema_files;
  declare_schema(command_line, schema_files);
  if (command_line.answers(invocation)) return ExitStatus::success;
  command_line.require(word || all, "CODE|P-AXIS-NNNNN|PARAMETER|MESSAGE|WORD");
  auto const language = invocation.language;
  // The parameters that lists of the working folder may set.
  auto const catalogue = SettingsFinder(schema_files).catalogue("-");
  if (format == Format::json) {
    auto subject = all ? everything(catalogue) : subject_of(all_catalogues(catalogue), *word, language);
    subject.rules.insert(subject.rules.end(), subject.foretelling.begin(), subject.foretelling.end());
    invocation.streams.out.write(explain_json(catalogue, subject.rules, subject.parameters, language));
  } else {
    invocation.streams.out.write(
        all ? explain_all(language)
            : explain_markdown(catalogue, subject_of(all_catalogues(catalogue), *word, language), language));
  }
  return ExitStatus::success;
}

}  // namespace axisc::cli
