#include "validator/engine/rule.hpp"

#include "validator/rules/filter_words.hpp"
#include "validator/sentences.hpp"

namespace axisc::validator::checks::ax7009::says {

constexpr Sentence headline{
    "the start-up list names a list of another kind here: its parameters are {kind}, expected are {wanted}",
    "die Hochlaufliste nennt hier eine Liste anderer Art: sie enthält {kind}, erwartet wird {wanted}"};
constexpr Sentence headline_of_list{
    "the machine file names this list as an axis list, but its parameters are {kind}",
    "die Maschinendatei nennt diese Liste als Achsliste, sie enthält aber {kind}"};
constexpr Sentence help{"name the list of an axis in the machine file",
                        "in der Maschinendatei die Liste einer Achse nennen"};
constexpr Sentence in_project{
    "the project holds a list of another kind here: its parameters are {kind}, expected are {wanted}",
    "das Projekt enthält hier eine Liste anderer Art: sie enthält {kind}, erwartet wird {wanted}"};
constexpr Sentence reaction{"it does not find the parameters that it looks for",
                            "sie findet die gesuchten Parameter nicht"};
constexpr Sentence help_here{"name the right list here", "hier die richtige Liste nennen"};

}  // namespace axisc::validator::checks::ax7009::says

namespace axisc::validator::checks::ax7009 {
namespace {

void wrong_kind_in_machine_file(MachineContext const& context, Report& report) {
  for (NamedList const& named : context.machine.lists) {
    if (named.list.kind == configuration::ListKind::axis) continue;
    std::uint32_t const begin = context.sources[named.list.source].text_begin();
    Finding& finding =
        report.add(Place{.source = named.list.source, .span = {.begin = begin, .end = begin}},
                   {says::headline_of_list, {{"kind", configuration::number_prefix(named.list.kind)}}});
    finding.help.push_back({says::help, {}});
  }
}

void wrong_kind(MachineContext const& context, Report& report) {
  if (context.machine.machine_file) wrong_kind_in_machine_file(context, report);
  if (!context.machine.start_up) return;
  for (ListSearch const& search : context.machine.start_up->searches) {
    if (!search.wanted || !search.kind || search.kind == search.wanted) continue;
    SentenceRef const headline = context.machine.start_up->is_project ? says::in_project : says::headline;
    Finding& finding =
        report.add(search.named.place, {headline,
                                        {{"kind", configuration::number_prefix(*search.kind)},
                                         {"wanted", configuration::number_prefix(*search.wanted)}}});
    if (is_default_list(*context.machine.start_up, search)) {
      finding.notes.push_back({validator::says::control_defaults, {}});
    }
    finding.help.push_back({says::help_here, {}});
    react(finding, {says::reaction, {}});
  }
}

}  // namespace

extern constinit Rule const rule{
    .check = wrong_kind,
};

}  // namespace axisc::validator::checks::ax7009
