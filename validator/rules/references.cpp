// AX2010 to AX2014: values that name another parameter.
#include "diagnostics/format_number.hpp"
#include "validator/rules/checks.hpp"
#include "validator/rules/helpers.hpp"
#include "validator/units_text.hpp"

#include <algorithm>

namespace axisc::validator {
namespace {

/// "P-AXIS-00212" as the reference names it, also where no such number exists.
std::string named(ReferenceProblem const& problem) {
  std::string digits = std::to_string(problem.p_axis);
  if (digits.size() < 5) digits.insert(0, 5 - digits.size(), '0');
  return "P-AXIS-" + digits;
}

/// The index as the list writes it: a number of any length.
std::string written_index(AxisContext const& context, EffectiveValue const& value) {
  std::string const reference = context.sources[value.value_place()->source].utf8(value.value_place()->span);
  return reference.substr(reference.find_last_of('.') + 1);
}

template <typename Visit>
void for_each_problem(AxisContext const& context, ReferenceTrouble trouble, Visit visit) {
  for (ReferenceProblem const& problem : context.reference_problems) {
    if (problem.trouble == trouble) visit(problem, context.values[problem.slot]);
  }
}

std::string name_of(AxisContext const& context, schema::Slot slot) {
  return parameter_name(context.values[slot]);
}

/// The value of the default list, or the documented default; none where that is not known either.
void keep_earlier(AxisContext const& context, Finding& finding, EffectiveValue const& value) {
  std::string earlier(value.value.text);
  if (earlier.empty() && default_value(*value.row)) earlier = format_exact(value.value.number);
  bool const is_number = value.value.text.empty() && !earlier.empty();
  set_reaction(finding, Text::reference_lost, {}, std::move(earlier));
  if (is_number) add_physical(finding, *value.row, context.type, value.value.number);
}

void add_target(AxisContext const& context, Finding& finding, ReferenceProblem const& problem) {
  if (!problem.target) return;
  std::string const name = name_of(context, *problem.target);
  finding.notes.push_back(message(Text::reference_target, {{"p_axis", named(problem)}, {"name", name}}));
  if (auto const& place = context.values[*problem.target].value_place()) {
    finding.related.push_back(
        {.place = *place, .message = message(Text::reference_target_here, {{"name", name}})});
  }
}

}  // namespace

void checks::reference_unresolvable(AxisContext const& context, Report& report) {
  for_each_problem(context, ReferenceTrouble::unresolvable,
                   [&](ReferenceProblem const& problem, EffectiveValue const& value) {
                     Message const text =
                         problem.target
                             ? message(Text::ax2010_no_value, {{"name", name_of(context, *problem.target)},
                                                               {"p_axis", named(problem)}})
                             : message(Text::ax2010, {{"p_axis", named(problem)}});
                     keep_earlier(context, report.add(value, text), value);
                   });
}

void checks::reference_circular(AxisContext const& context, Report& report) {
  for_each_problem(
      context, ReferenceTrouble::circular, [&](ReferenceProblem const& problem, EffectiveValue const& value) {
        Text const text = problem.circle.empty() ? Text::ax2011_itself : Text::ax2011_circle;
        Finding& finding = report.add(value, message(text, {{"parameter", name_of(context, problem.slot)}}));
        keep_earlier(context, finding, value);
        for (schema::Slot const member : problem.circle) {
          finding.related.push_back(
              {.place = *context.values[member].value_place(),
               .message = message(Text::ax2011_member, {{"parameter", name_of(context, member)}})});
        }
      });
}

void checks::reference_type(AxisContext const& context, Report& report) {
  for_each_problem(context, ReferenceTrouble::wrong_type,
                   [&](ReferenceProblem const& problem, EffectiveValue const& value) {
                     schema::DataType const type = context.values.row(problem.slot).type;
                     schema::DataType const other = context.values.row(*problem.target).type;
                     Message text =
                         message(Text::ax2012, {{"parameter", name_of(context, problem.slot)},
                                                {"type", std::string(schema::data_type_name(type))},
                                                {"p_axis", named(problem)},
                                                {"other", std::string(schema::data_type_name(other))}});
                     if (type == other) {
                       text = message(Text::ax2012_symbol,
                                      {{"parameter", name_of(context, problem.slot)},
                                       {"value", std::string(context.values[*problem.target].value.text)},
                                       {"p_axis", named(problem)}});
                     }
                     Finding& finding = report.add(value, std::move(text));
                     keep_earlier(context, finding, value);
                     add_target(context, finding, problem);
                   });
}

void checks::reference_index(AxisContext const& context, Report& report) {
  for_each_problem(
      context, ReferenceTrouble::wrong_index,
      [&](ReferenceProblem const& problem, EffectiveValue const& value) {
        schema::Catalogue const& catalogue = context.values.catalogue();
        std::uint16_t entries = 0;
        for (schema::ParameterId const id :
             catalogue.find_number(static_cast<std::uint16_t>(problem.p_axis))) {
          entries = std::max(entries, catalogue.parameter(id).array[0]);
        }
        std::string const index = written_index(context, value);
        Message text = message(Text::ax2013_scalar, {{"p_axis", named(problem)}, {"index", index}});
        if (entries != 0) {
          text =
              message(Text::ax2013,
                      {{"p_axis", named(problem)}, {"last", std::to_string(entries - 1)}, {"index", index}});
        }
        keep_earlier(context, report.add(value, std::move(text)), value);
      });
}

void checks::reference_unit(AxisContext const& context, Report& report) {
  for_each_problem(
      context, ReferenceTrouble::other_unit,
      [&](ReferenceProblem const& problem, EffectiveValue const& value) {
        Finding& finding = report.add(
            value,
            message(Text::ax2014,
                    {{"parameter", name_of(context, problem.slot)},
                     {"unit", raw_unit_name(unit_of(context.values.row(problem.slot), context.type))},
                     {"p_axis", named(problem)},
                     {"other", raw_unit_name(unit_of(context.values.row(*problem.target), context.type))}}));
        set_reaction(finding, Text::ax2014_reaction);
        add_target(context, finding, problem);
      });
}

}  // namespace axisc::validator
