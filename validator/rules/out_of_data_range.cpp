#include "diagnostics/format_number.hpp"
#include "validator/rules/checks.hpp"
#include "validator/rules/helpers.hpp"

namespace axisc::validator {
namespace {

/// Exact text of a limit: doubles cannot hold those of the 64-bit types.
std::string limit_text(schema::DataType type, bool highest) {
  if (type == schema::DataType::uns64 && highest) return "18446744073709551615";
  if (type == schema::DataType::sgn64) return highest ? "9223372036854775807" : "-9223372036854775808";
  DataRange const range = data_range(type);
  return format_exact(highest ? range.highest : range.lowest);
}

void add(AxisContext const& context, Report& report, Place place, schema::Parameter const& row,
         schema::Slot slot, std::string value, bool positive) {
  schema::DataType const type = row.type;
  std::string type_name(schema::data_type_name(type));
  Finding& finding =
      report.add(place, row, slot,
                 message_of(Text::ax2004, Argument{"value", std::move(value)}, Argument{"type", type_name}));
  std::string lowest = limit_text(type, false);
  std::string highest = limit_text(type, true);
  set_reaction(finding, Text::ax2004_reaction, {}, positive ? highest : lowest);
  finding.notes.push_back(message_of(Text::ax2004_range, Argument{"type", std::move(type_name)},
                                     Argument{"lowest", std::move(lowest)},
                                     Argument{"highest", std::move(highest)}));
  DataRange const range = data_range(type);
  add_physical(finding, row, context.type, positive ? range.highest : range.lowest);
}

}  // namespace

void checks::out_of_data_range(AxisContext const& context, Report& report) {
  for (LoadedList const* const list : lists_of(context)) {
    if (list == nullptr) continue;
    SourceText const& source = context.sources[list->source];
    for_each_doubtful(*list, [&](grammar::Assignment const& assignment, Reading const& reading) {
      if (reading.status != ReadingStatus::out_of_data_range || !reading.known()) return;
      Place const place{.source = list->source, .span = assignment.value};
      add(context, report, place, *reading.row, reading.slot, source.utf8(assignment.value),
          reading.value.number > 0);
    });
  }
  for (ReferenceProblem const& problem : context.reference_problems) {
    if (problem.trouble != ReferenceTrouble::out_of_data_range) continue;
    EffectiveValue const& value = context.values[problem.slot];
    add(context, report, *value.value_place(), *value.row, problem.slot, format_exact(problem.number),
        problem.number > 0);
  }
}

}  // namespace axisc::validator
