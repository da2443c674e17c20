#include "validator/engine/rule.hpp"

#include "diagnostics/ascii.hpp"
#include "validator/rules/helpers.hpp"
#include "validator/sentences.hpp"

#include <algorithm>

namespace axisc::validator::checks::ax1007::says {

constexpr Sentence headline{"`{text}` looks like a second value", "`{text}` sieht wie ein zweiter Wert aus"};
constexpr Sentence reaction{"it ignores the rest of the line", "sie übergeht den Rest der Zeile"};
constexpr Sentence help{"start a comment with `(`", "einen Kommentar mit `(` beginnen"};

}  // namespace axisc::validator::checks::ax1007::says

namespace axisc::validator::checks::ax1007 {
namespace {

/// P-AXIS-00212 or P-AXIS-00212.0.
bool is_reference(std::string_view word) {
  constexpr std::string_view prefix = "P-AXIS-";
  if (word.substr(0, prefix.size()) != prefix) return false;
  word.remove_prefix(prefix.size());
  std::string_view const number = word.substr(0, word.find('.'));
  std::string_view const index = word.substr(std::min(number.size() + 1, word.size()));
  bool const has_index = number.size() < word.size();
  return !number.empty() && std::all_of(number.begin(), number.end(), ascii::is_digit) &&
         has_index == !index.empty() && std::all_of(index.begin(), index.end(), ascii::is_digit);
}

/// Also numbers that the control does not accept: `000`, `1,5`, `,5`.
bool looks_like_number(std::string_view word) {
  constexpr std::string_view signs = "+-";
  if (!word.empty() && signs.find(word.front()) != std::string_view::npos) word.remove_prefix(1);
  return word.find_first_not_of("0123456789.,") == std::string_view::npos &&
         std::any_of(word.begin(), word.end(), ascii::is_digit) && word.back() != ',';
}

bool looks_like_value(schema::Catalogue const& catalogue, std::string_view word) {
  return looks_like_number(word) || schema::is_complete_number(word) || is_reference(word) ||
         (std::none_of(word.begin(), word.end(), ascii::is_small) &&
          catalogue.is_symbol_of_any_parameter(word));
}

/// After numbers, booleans and references the control ignores everything; text after symbols is left to
/// AX1009.
bool ends_at_blank(grammar::Assignment const& assignment, LineValue const& line_value) {
  using grammar::ValueKind;
  if (line_value.status == ReadingStatus::reference) return true;
  bool const usable =
      line_value.status == ReadingStatus::value || line_value.status == ReadingStatus::out_of_data_range;
  if (!usable) return false;
  if (line_value.row_known()) {
    schema::Parameter const& parameter = *line_value.row;
    if (parameter.type == schema::DataType::boolean) return true;
    if (parameter.type == schema::DataType::string && !parameter.is_enumeration()) return false;
  }
  return assignment.kind == ValueKind::integer || assignment.kind == ValueKind::hexadecimal ||
         assignment.kind == ValueKind::real || assignment.kind == ValueKind::reference;
}

/// The first word after the value.
Span first_word(Line const& line) {
  Span const trailer = line.assignment().trailer;
  std::string_view const text = line.context.source.slice(trailer);
  std::size_t const size = std::min(text.find_first_of(" \t("), text.size());
  return {.begin = trailer.begin, .end = trailer.begin + static_cast<std::uint32_t>(size)};
}

/// The number without the blanks in it, `20 000` as 20000; empty where the result is not a number.
std::string joined(Line const& line) {
  std::string number = line.text(line.assignment().value);
  std::string_view rest = line.context.source.slice(line.assignment().trailer);
  while (!rest.empty() && ascii::is_digit(rest.front())) {
    std::string_view const word = rest.substr(0, rest.find_first_of(" \t("));
    if (!std::all_of(word.begin(), word.end(), ascii::is_digit)) break;
    number += word;
    rest = ascii::trimmed(rest.substr(word.size()));
  }
  return schema::is_complete_number(number) ? number : std::string();
}

/// No fix: a comment would hide the mistake, and which number is meant cannot be known.
void describe(Finding& finding, Line const& line) {
  finding.message = message(says::headline, {{"text", line.text(first_word(line))}});
  std::string const value = line.text(line.assignment().value);
  set_reaction(finding, says::reaction, {}, value);
  if (std::string number = joined(line); !number.empty() && number != value) {
    finding.help.push_back(
        message_of(validator::says::parameter_did_you_mean, Argument{"suggestion", std::move(number)}));
  }
  finding.help.push_back(message(says::help));
}

void suspicious_trailer(ListContext const& context, Report& report) {
  for_each_doubtful(context, [&](Line const& line) {
    grammar::Assignment const& assignment = line.assignment();
    bool const has_text = assignment.trailer_kind == grammar::TrailerKind::text;
    if (!has_text || !ends_at_blank(assignment, line.line_value())) return;
    Span const word = first_word(line);
    if (!looks_like_value(context.list.catalogue, context.source.slice(word))) return;
    report_line<describe>(report, line, word);
  });
}

}  // namespace

extern constinit Rule const rule{
    .severity = Severity::warning,
    .check = suspicious_trailer,
};

}  // namespace axisc::validator::checks::ax1007
