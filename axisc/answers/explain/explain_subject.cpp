#include "axisc/answers/explain/explain_subject.hpp"

#include "axisc/asked/finding_codes.hpp"
#include "axisc/asked/quantities.hpp"
#include "axisc/environment/failure.hpp"
#include "configuration/list_kind.hpp"
#include "diagnostics/ascii.hpp"
#include "schema/closest_word.hpp"
#include "schema/descriptions/description.hpp"

namespace axisc::says {

constexpr Sentence unknown_subject{
    "\"{word}\" is not a code, a message of the control, a parameter or a part of one, nor a word for path "
    "dynamics (G60, #SLOPE); `axisc explain --all` lists the codes",
    "\"{word}\" ist weder ein Code noch eine Meldung der Steuerung noch ein Parameter oder ein Teil davon, "
    "auch kein Wort zur Bahndynamik (G60, #SLOPE); `axisc explain --all` nennt die Codes"};
constexpr Sentence unknown_subject_meant{
    "\"{word}\" is not a code, a message of the control, a parameter or a part of one, nor a word for path "
    "dynamics (G60, #SLOPE); did you mean {meant}?",
    "\"{word}\" ist weder ein Code noch eine Meldung der Steuerung noch ein Parameter oder ein Teil davon, "
    "auch kein Wort zur Bahndynamik (G60, #SLOPE); war {meant} gemeint?"};

}  // namespace axisc::says

namespace axisc {

namespace {

/// By code ("AX3005", "ax3005", "3005") or name ("delay-too-long").
validator::Rule const* rule_of(std::string const& word) {
  auto const code = find_code(word);
  auto const by_number = code ? code : find_code("AX" + word);
  return by_number ? validator::find_rule(*by_number) : nullptr;
}

/// Rows with the number in "P-AXIS-00140" or "P-CHAN-00035". The number may stand alone for a parameter of
/// axes; zeros in front may be missing.
std::vector<schema::Parameter const*> rows_of_number(std::span<schema::Catalogue const> catalogues,
                                                     std::string const& word) {
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
std::vector<schema::Parameter const*> rows_of_name(std::span<schema::Catalogue const> catalogues,
                                                   std::string const& word) {
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
  throw Failure({meant.empty() ? says::unknown_subject : says::unknown_subject_meant,
                 {{"word", word}, {"meant", meant}}});
}

/// "50663" is in "50663/60311/70451".
bool foretells(validator::Rule const& rule, std::string const& number) {
  return ("/" + std::string(rule.control) + "/").find("/" + number + "/") != std::string::npos;
}

/// Upper and lower case are equal; the meaning counts where no name contains the word.
std::vector<schema::Parameter const*> parameters_with(schema::Catalogue const& catalogue,
                                                      std::string const& word) {
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
  return search([](schema::Parameter const& parameter) {
    auto const what = schema::description_of(parameter).what;
    return std::string(what.english) + "\n" + std::string(what.german);
  });
}

}  // namespace

ExplainSubject explain_subject(std::span<schema::Catalogue const> catalogues, std::string const& word) {
  ExplainSubject subject;
  subject.motion_word = schema::find_motion_word(std::string_view(word));
  if (subject.motion_word != nullptr) return subject;
  if (auto const* const rule = rule_of(word)) subject.rules.push_back(rule);
  for (auto const& rule : validator::rules()) {
    if (foretells(rule, word)) subject.foretelling.push_back(&rule);
  }
  if (!subject.rules.empty() || !subject.foretelling.empty()) return subject;
  subject.parameters = rows_of_number(catalogues, word);
  if (subject.parameters.empty()) subject.parameters = rows_of_name(catalogues, word);
  if (!subject.parameters.empty()) return subject;
  subject.is_searched = true;
  for (auto const& catalogue : catalogues) {
    auto const found = parameters_with(catalogue, word);
    subject.parameters.insert(subject.parameters.end(), found.begin(), found.end());
    if (!subject.parameters.empty() && catalogue.kind() == schema::ListKind::axis) break;
  }
  if (!subject.parameters.empty()) return subject;
  refuse(catalogues.front(), word);
}

}  // namespace axisc
