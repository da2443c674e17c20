#include "validator/engine/rule.hpp"

#include "validator/rules/filter_words.hpp"

namespace axisc::validator::says {

constexpr Sentence headline{
    "the start-up list names a list of another kind here: its parameters are {kind}, expected are {wanted}",
    "die Hochlaufliste nennt hier eine Liste anderer Art: sie enthält {kind}, erwartet wird {wanted}"};
constexpr Sentence in_project{
    "the project holds a list of another kind here: its parameters are {kind}, expected are {wanted}",
    "das Projekt enthält hier eine Liste anderer Art: sie enthält {kind}, erwartet wird {wanted}"};
constexpr Sentence reaction{"it does not find the parameters that it looks for",
                            "sie findet die gesuchten Parameter nicht"};

}  // namespace axisc::validator::says

namespace axisc::validator::checks {
namespace {

void wrong_kind(MachineContext const& context, Report& report) {
  if (!context.machine.start_up) return;
  for (ListSearch const& search : context.machine.start_up->searches) {
    if (!search.wanted || !search.kind || search.kind == search.wanted) continue;
    SentenceRef const headline = context.machine.start_up->is_project ? says::in_project : says::headline;
    Finding& finding =
        report.add(search.named.place, {headline,
                                        {{"kind", configuration::number_prefix(*search.kind)},
                                         {"wanted", configuration::number_prefix(*search.wanted)}}});
    react(finding, {says::reaction, {}});
  }
}

}  // namespace

extern constinit Rule const ax7009{
    .code = Code{7009},
    .name = "wrong-kind",
    .check = wrong_kind,
};

}  // namespace axisc::validator::checks
