#include "validator/engine/rule.hpp"

#include "validator/rules/helpers.hpp"
#include "validator/rules/sentences.hpp"
#include "validator/views/units_text.hpp"
#include "validator/views/written_unit.hpp"

#include <optional>

namespace axisc::validator::checks::ax1014::says {

constexpr Sentence headline{"`{parameter}` is in {unit}, not in {written}",
                            "`{parameter}` gilt in {unit}, nicht in {written}"};
constexpr Sentence reaction{"it ignores the unit", "sie übergeht die Einheit"};
constexpr Sentence help{"write the number in {unit}", "die Zahl in {unit} schreiben"};

}  // namespace axisc::validator::checks::ax1014::says

namespace axisc::validator::checks::ax1014 {
namespace {

Span unit_span(Line const& line) {
  Span const trailer = line.assignment().trailer;
  std::size_t const size = unit_word(line.context.source.slice(trailer)).size();
  return {.begin = trailer.begin, .end = trailer.begin + static_cast<std::uint32_t>(size)};
}

struct WrittenUnit {
  std::string_view unit;        ///< of the parameter
  std::optional<double> ratio;  ///< none where no conversion leads to it
};

/// For a value followed by another unit than the parameter's.
std::optional<WrittenUnit> other_unit(Line const& line) {
  LineValue const& line_value = line.line_value();
  bool const has_text = line.assignment().trailer_kind == grammar::TrailerKind::text;
  if (!has_text || line_value.status != ReadingStatus::value || !schema::is_number(line_value.row->type)) {
    return std::nullopt;
  }
  std::string const word = line.text(unit_span(line));
  auto const type = line.context.axis_type;
  std::string_view const own = unit_of(*line_value.row, type.value_or(machine::AxisType::translatory));
  if (own.empty() || !is_unit(word)) return std::nullopt;
  // A list may be one for all axes, so that the kind of axis is not known.
  std::string_view const other = type ? own : line_value.row->unit_rotary;
  for (std::string_view const unit : {own, other}) {
    auto const ratio = unit_ratio(word, unit);
    if (ratio && *ratio == 1) return std::nullopt;
    if (ratio) return WrittenUnit{.unit = unit, .ratio = ratio};
  }
  return WrittenUnit{.unit = own, .ratio = std::nullopt};
}

void describe(Finding& finding, Line const& line) {
  WrittenUnit const unit = *other_unit(line);
  Span const value = line.assignment().value;
  Span const word = unit_span(line);
  finding.message =
      message(says::headline,
              {{"parameter", line.name()}, {"unit", raw_unit_name(unit.unit)}, {"written", line.text(word)}});
  set_reaction(finding, says::reaction, {}, line.text(value));
  add_physical(finding, *line.line_value().row,
               line.context.axis_type.value_or(machine::AxisType::translatory),
               line.line_value().value.number);
  std::string const number = unit.ratio ? converted_number(line.line_value().value.number, *unit.ratio,
                                                           schema::is_integer(line.line_value().row->type))
                                        : std::string();
  if (number.empty()) {
    finding.help.push_back(message(says::help, {{"unit", raw_unit_name(unit.unit)}}));
    return;
  }
  // The written value stays readable, as a comment.
  finding.fix = replace_by(line.place({.begin = value.begin, .end = value.begin}), number + " ( ",
                           message(validator::says::parameter_fix, {{"replacement", number}}));
}

void unit_in_trailer(ListContext const& context, Report& report) {
  for_each_doubtful(context, [&](Line const& line) {
    if (other_unit(line)) report_line<describe>(report, line, unit_span(line));
  });
}

}  // namespace

extern constinit Rule const rule{
    .check = unit_in_trailer,
};

}  // namespace axisc::validator::checks::ax1014
