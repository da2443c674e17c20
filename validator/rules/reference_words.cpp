#include "validator/rules/reference_words.hpp"

#include "diagnostics/format_number.hpp"
#include "validator/rules/helpers.hpp"

#include <utility>

namespace axisc::validator::says {

constexpr Sentence lost{"the parameter keeps its earlier value",
                        "der Parameter behält seinen vorherigen Wert"};
constexpr Sentence target{"{p_axis} is `{name}`", "{p_axis} ist `{name}`"};
constexpr Sentence target_here{"`{name}` is set here", "hier wird `{name}` gesetzt"};

}  // namespace axisc::validator::says

namespace axisc::validator::checks {

std::string named(ReferenceProblem const& problem) {
  std::string digits = std::to_string(problem.p_axis);
  if (digits.size() < 5) digits.insert(0, 5 - digits.size(), '0');
  return "P-AXIS-" + digits;
}

std::string name_of(AxisContext const& context, schema::Slot slot) {
  return parameter_name(context.values[slot]);
}

void keep_earlier(AxisContext const& context, Finding& finding, EffectiveValue const& value) {
  std::string earlier(value.value.text);
  if (earlier.empty() && schema::default_value(*value.row)) earlier = format_exact(value.value.number);
  bool const is_number = value.value.text.empty() && !earlier.empty();
  set_reaction(finding, says::lost, {}, std::move(earlier));
  if (is_number) add_physical(finding, *value.row, context.type, value.value.number);
}

void add_target(AxisContext const& context, Finding& finding, ReferenceProblem const& problem) {
  if (!problem.target) return;
  std::string const name = name_of(context, *problem.target);
  finding.notes.push_back(message(says::target, {{"p_axis", named(problem)}, {"name", name}}));
  if (auto const& place = context.values[*problem.target].value_place()) {
    finding.related.push_back({.place = *place, .message = message(says::target_here, {{"name", name}})});
  }
}

}  // namespace axisc::validator::checks
