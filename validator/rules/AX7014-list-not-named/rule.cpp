#include "validator/engine/rule.hpp"

#include "validator/rules/helpers.hpp"

namespace axisc::validator::checks::ax7014::says {

constexpr Sentence headline{"no start-up list in this folder names this list",
                            "keine Hochlaufliste in diesem Ordner nennt diese Liste"};
constexpr Sentence reaction{"it does not read the list", "sie liest die Liste nicht"};
constexpr Sentence help{
    "name it in the start-up list, delete it, or leave it out with \"exclude\" in axisc.json",
    "sie in der Hochlaufliste nennen, löschen, oder mit \"exclude\" in axisc.json auslassen"};

}  // namespace axisc::validator::checks::ax7014::says

namespace axisc::validator::checks::ax7014 {
namespace {

void list_not_named(MachineContext const& context, Report& report) {
  LoadedMachine const& machine = context.machine;
  if (!machine.is_beside_start_up_list) return;
  for (auto const* const lists : {&machine.lists, &machine.other_lists}) {
    for (NamedList const& named : *lists) {
      std::uint32_t const begin = context.sources[named.list.source].text_begin();
      Place const place{.source = named.list.source, .span = {.begin = begin, .end = begin}};
      Finding& finding = report.add(place, message(says::headline));
      set_reaction(finding, says::reaction);
      finding.help.push_back(message(says::help));
    }
  }
}

}  // namespace

extern constinit Rule const rule{
    .severity = Severity::note,
    .check = list_not_named,
};

}  // namespace axisc::validator::checks::ax7014
