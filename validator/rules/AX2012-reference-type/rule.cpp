#include "validator/engine/rule.hpp"

#include "validator/rules/helpers.hpp"
#include "validator/rules/reference_words.hpp"

namespace axisc::validator::checks::ax2012::says {

constexpr Sentence headline{"`{parameter}` is {type}, but {p_axis} is {other}",
                            "`{parameter}` ist {type}, {p_axis} aber {other}"};
constexpr Sentence symbol{"`{value}`, the value of {p_axis}, is not a valid value for `{parameter}`",
                          "`{value}`, der Wert von {p_axis}, ist kein gültiger Wert für `{parameter}`"};
constexpr Sentence help{"refer to a parameter of the same type, or write the value itself",
                        "auf einen Parameter gleichen Typs verweisen, oder den Wert selbst schreiben"};

}  // namespace axisc::validator::checks::ax2012::says

namespace axisc::validator::checks::ax2012 {
namespace {

void reference_type(AxisContext const& context, Report& report) {
  for_each_problem(
      context, ReferenceTrouble::wrong_type,
      [&](ReferenceProblem const& problem, EffectiveValue const& value) {
        schema::DataType const type = context.values.row(problem.slot).type;
        schema::DataType const other = context.values.row(*problem.target).type;
        Message text = message(says::headline, {{"parameter", name_of(context, problem.slot)},
                                                {"type", std::string(schema::data_type_name(type))},
                                                {"p_axis", named(problem)},
                                                {"other", std::string(schema::data_type_name(other))}});
        if (type == other) {
          text = message(says::symbol, {{"parameter", name_of(context, problem.slot)},
                                        {"value", std::string(context.values[*problem.target].value.text)},
                                        {"p_axis", named(problem)}});
        }
        Finding& finding = report.add(value, std::move(text));
        keep_earlier(context, finding, value);
        finding.help.push_back(message(says::help));
        add_target(context, finding, problem);
      });
}

}  // namespace

extern constinit Rule const rule{
    .control = "2062",
    .check = reference_type,
};

}  // namespace axisc::validator::checks::ax2012
