#include "validator/engine/rule.hpp"

#include "diagnostics/ascii.hpp"
#include "validator/rules/helpers.hpp"

#include <algorithm>

namespace axisc::validator::says {

constexpr Sentence headline{"`{text}` looks like a second value", "`{text}` sieht wie ein zweiter Wert aus"};
constexpr Sentence reaction{"it ignores the rest of the line", "sie übergeht den Rest der Zeile"};
constexpr Sentence help{"start a comment with `(`", "einen Kommentar mit `(` beginnen"};
constexpr Sentence fix{"make it a comment", "zum Kommentar machen"};

}  // namespace axisc::validator::says

namespace axisc::validator::checks {
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

bool looks_like_value(schema::Catalogue const& catalogue, std::string_view word) {
  return schema::is_complete_number(word) || is_reference(word) ||
         (std::none_of(word.begin(), word.end(), ascii::is_small) &&
          catalogue.is_symbol_of_any_parameter(word));
}

/// After numbers, booleans and references the control ignores everything; text after symbols is left to AX1009.
bool ends_at_blank(grammar::Assignment const& assignment, Reading const& reading) {
  using grammar::ValueKind;
  if (reading.status == ReadingStatus::reference) return true;
  bool const usable = reading.status == ReadingStatus::value || reading.status == ReadingStatus::not_judged ||
                      reading.status == ReadingStatus::out_of_data_range;
  if (!usable) return false;
  if (reading.row_known()) {
    schema::Parameter const& parameter = *reading.row;
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

void describe(Finding& finding, Line const& line) {
  Span const word = first_word(line);
  finding.message = message(says::headline, {{"text", line.text(word)}});
  set_reaction(finding, says::reaction, {}, line.text(line.assignment().value));
  finding.help.push_back(message(says::help));
  Span const before{.begin = word.begin, .end = word.begin};
  finding.fix = replace_by(line.place(before), "( ", message(says::fix), FixSafety::safe);
}

void suspicious_trailer(ListContext const& context, Report& report) {
  for_each_doubtful(context, [&](Line const& line) {
    grammar::Assignment const& assignment = line.assignment();
    bool const has_text = assignment.trailer_kind == grammar::TrailerKind::text;
    if (!has_text || !ends_at_blank(assignment, line.reading())) return;
    Span const word = first_word(line);
    if (!looks_like_value(context.list.catalogue, context.source.slice(word))) return;
    report_line<describe>(report, line, word);
  });
}

}  // namespace

extern constinit Rule const ax1007{
    .code = Code{1007},
    .name = "suspicious-trailer",
    .severity = Severity::warning,
    .check = suspicious_trailer,
};

}  // namespace axisc::validator::checks
