#include "validator/engine/rule.hpp"

#include "diagnostics/format_number.hpp"
#include "validator/rules/helpers.hpp"

#include <cstdint>
#include <string>

namespace axisc::validator::checks::ax2004::says {

constexpr Sentence headline{"{value} does not fit {type}", "{value} passt nicht in {type}"};
constexpr Sentence range{"{type} holds {lowest} to {highest}", "{type} fasst {lowest} bis {highest}"};
constexpr Sentence reaction{"it clips the value", "sie begrenzt den Wert"};

}  // namespace axisc::validator::checks::ax2004::says

namespace axisc::validator::checks::ax2004 {
namespace {

/// Exact text of a limit: doubles cannot hold those of the 64-bit types.
std::string limit_text(schema::DataType type, bool highest) {
  if (type == schema::DataType::uns64 && highest) return "18446744073709551615";
  if (type == schema::DataType::sgn64) return highest ? "9223372036854775807" : "-9223372036854775808";
  schema::DataRange const range = schema::data_range(type);
  double const limit = highest ? range.highest : range.lowest;
  return schema::is_integer(type) ? std::to_string(static_cast<std::int64_t>(limit)) : format_exact(limit);
}

void describe(Finding& finding, schema::Parameter const& row, schema::Slot slot, std::string value,
              bool positive) {
  name_parameter(finding, row, slot);
  std::string type_name(schema::data_type_name(row.type));
  finding.message = message_of(says::headline, Argument{"value", Wording::number(std::move(value))},
                               Argument{"type", type_name});
  std::string lowest = limit_text(row.type, false);
  std::string highest = limit_text(row.type, true);
  set_reaction(finding, says::reaction, {}, positive ? highest : lowest);
  finding.notes.push_back(message_of(says::range, Argument{"type", std::move(type_name)},
                                     Argument{"lowest", Wording::number(std::move(lowest))},
                                     Argument{"highest", Wording::number(std::move(highest))}));
}

void describe(Finding& finding, AxisContext const& context, schema::Slot slot, std::string value,
              bool positive) {
  schema::Parameter const& row = context.values.row(slot);
  describe(finding, row, slot, std::move(value), positive);
  schema::DataRange const range = schema::data_range(row.type);
  add_physical(finding, row, context.type, positive ? range.highest : range.lowest);
}

void out_of_data_range_in_list(ListContext const& context, Report& report) {
  for_each_doubtful(context, [&](Line const& line) {
    if (line.line_value().status != ReadingStatus::out_of_data_range || !line.line_value().known()) return;
    Span const value = line.assignment().value;
    report.later(line.place(value), [line](Finding& finding) {
      LineValue const& line_value = line.line_value();
      describe(finding, *line_value.row, line_value.slot, line.text(line.assignment().value),
               line_value.value.number > 0);
    });
  });
}

void out_of_data_range(AxisContext const& context, Report& report) {
  for_each_doubtful(context, [&](AxisLine const& line) {
    if (line.line_value().status != ReadingStatus::out_of_data_range || !line.line_value().known()) return;
    report.later(line.place(), [line](Finding& finding) {
      SourceText const& source = line.context.sources[line.list().source];
      describe(finding, line.context, line.line_value().slot, source.utf8(line.assignment().value),
               line.line_value().value.number > 0);
    });
  });
  for (ReferenceProblem const& problem : context.reference_problems) {
    if (problem.trouble != ReferenceTrouble::out_of_data_range) continue;
    report.later(*context.values[problem.slot].value_place(), [&context, &problem](Finding& finding) {
      describe(finding, context, problem.slot, format_exact(problem.number), problem.number > 0);
    });
  }
}

}  // namespace

extern constinit Rule const rule{
    .control = "1001138",
    .about = [](schema::Parameter const& parameter) { return schema::is_integer(parameter.type); },
    .precedence = Precedence::before_family,
    .check = out_of_data_range,
    .list_check = out_of_data_range_in_list,
};

}  // namespace axisc::validator::checks::ax2004
