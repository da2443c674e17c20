#include "validator/engine/rule.hpp"

#include "validator/rules/filter_words.hpp"
#include "validator/rules/unequal_filters.hpp"
#include "validator/views/gantry.hpp"

namespace axisc::validator::checks::ax4022::says {

constexpr Sentence headline{
    R"(coupled axes "{master}" and "{slave}": their filters are {cycles} ({milliseconds} ms) apart)",
    "gekoppelte Achsen „{master}“ und „{slave}“: ihre Filter liegen {cycles} ({milliseconds} ms) "
    "auseinander"};
constexpr Sentence headline_positions{
    R"(coupled axes "{master}" and "{slave}": their positions are {cycles} ({milliseconds} ms) apart)",
    "gekoppelte Achsen „{master}“ und „{slave}“: ihre Positionen liegen {cycles} ({milliseconds} ms) "
    "auseinander"};
constexpr Sentence headline_same_delay{
    R"(the coupled axes "{master}" and "{slave}" have different filters)",
    "die gekoppelten Achsen „{master}“ und „{slave}“ haben verschiedene Filter"};
constexpr Sentence same_delay{"their delays agree, so they differ only while they accelerate",
                              "die Verzögerungen stimmen überein; sie weichen nur beim Beschleunigen ab"};
constexpr Sentence coupled_here{"the coupling stands here", "hier steht die Kopplung"};
constexpr Sentence help{"configure the same filters in both axes",
                        "in beiden Achsen dieselben Filter konfigurieren"};
constexpr Sentence help_feedforward{"use the same feedforward in both axes",
                                    "in beiden Achsen dieselbe Vorsteuerung verwenden"};

}  // namespace axisc::validator::checks::ax4022::says

namespace axisc::validator::checks::ax4022 {
namespace {

void check_pair(configuration::CoupledPair const& pair, MachineContext const& context, Report& report) {
  if (!pair.master || !pair.slave) return;
  auto const master_index = axis_numbered(context.machine, pair.master->number);
  auto const slave_index = axis_numbered(context.machine, pair.slave->number);
  // Axes that a gantry couples as well are reported by AX4021.
  if (!master_index || !slave_index || master_index == slave_index) return;
  if (master_of(context.machine, *slave_index) == master_index) return;
  auto const master = delayed_axis(context, *master_index);
  auto const slave = delayed_axis(context, *slave_index);
  auto const difference = master && slave ? compare_positions({*master, *slave}) : std::nullopt;
  if (!difference) return;
  bool const apart = difference->is_apart();
  SentenceRef const headline = difference->feedforward_differs ? says::headline_positions : says::headline;
  Finding& finding =
      report_difference(*difference, apart ? headline : says::headline_same_delay, context, report);
  finding.related.push_back({.place = pair.slave->place, .message = {says::coupled_here, {}}});
  if (!apart) finding.notes.push_back({says::same_delay, {}});
  finding.help.push_back({difference->filters_differ ? says::help : says::help_feedforward, {}});
}

void coupled_filters_differ(MachineContext const& context, Report& report) {
  for (LoadedGroup const& group : context.machine.groups) {
    for (configuration::CoupledPair const& pair : group.pairs) check_pair(pair, context, report);
  }
}

}  // namespace

extern constinit Rule const rule{
    .severity = Severity::warning,
    .parameters =
        "filter[].* filter_fir.* vib_guard.* kopf.achs_nr vorsteuer.vorsteuerung vorsteuer.default_active "
        "vorsteuer.global_disable vorsteuer.feedforward_without_delay vorsteuer.timeconst_sym_filter "
        "kenngr.antr_typ",
    .needs = Needs::cycle_time,
    .check = coupled_filters_differ,
};

}  // namespace axisc::validator::checks::ax4022
