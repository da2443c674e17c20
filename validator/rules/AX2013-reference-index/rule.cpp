#include "validator/engine/rule.hpp"

#include "validator/rules/helpers.hpp"
#include "validator/rules/reference_words.hpp"

#include <algorithm>

namespace axisc::validator::checks::ax2013::says {

constexpr Sentence headline{"{p_axis} has the entries 0 to {last}, not {index}",
                            "{p_axis} hat die Einträge 0 bis {last}, nicht {index}"};
constexpr Sentence scalar{"{p_axis} is not an array and has no entry {index}",
                          "{p_axis} ist kein Feld und hat keinen Eintrag {index}"};
constexpr Sentence help{"use an index in range, or write the value itself",
                        "einen gültigen Index verwenden, oder den Wert selbst schreiben"};

}  // namespace axisc::validator::checks::ax2013::says

namespace axisc::validator::checks::ax2013 {
namespace {

/// The index as the list writes it: a number of any length.
std::string written_index(AxisContext const& context, EffectiveValue const& value) {
  std::string const reference = context.sources[value.value_place()->source].utf8(value.value_place()->span);
  return reference.substr(reference.find_last_of('.') + 1);
}

void reference_index(AxisContext const& context, Report& report) {
  for_each_problem(context, ReferenceTrouble::wrong_index,
                   [&](ReferenceProblem const& problem, EffectiveValue const& value) {
                     schema::Catalogue const& catalogue = context.values.catalogue();
                     std::uint16_t entries = 0;
                     for (schema::ParameterId const id :
                          catalogue.find_number(static_cast<std::uint16_t>(problem.p_axis))) {
                       entries = std::max(entries, catalogue.parameter(id).array[0]);
                     }
                     std::string const index = written_index(context, value);
                     Message text = message(says::scalar, {{"p_axis", named(problem)}, {"index", index}});
                     if (entries != 0) {
                       text = message(says::headline, {{"p_axis", named(problem)},
                                                       {"last", std::to_string(entries - 1)},
                                                       {"index", index}});
                     }
                     Finding& finding = report.add(value, std::move(text));
                     keep_earlier(context, finding, value);
                     finding.help.push_back(message(says::help));
                   });
}

}  // namespace

extern constinit Rule const rule{
    .control = "2045",
    .check = reference_index,
};

}  // namespace axisc::validator::checks::ax2013
