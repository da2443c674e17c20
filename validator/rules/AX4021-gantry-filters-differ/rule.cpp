#include "validator/engine/rule.hpp"

#include "diagnostics/format_number.hpp"
#include "validator/rules/filter_words.hpp"
#include "validator/rules/unequal_filters.hpp"

namespace axisc::validator::checks::ax4021::says {

constexpr Sentence headline{
    R"(gantry "{master}"/"{slave}": the filters of master and slave are {cycles} ({milliseconds} ms) apart)",
    "Gantry „{master}“/„{slave}“: die Filter von Master- und Slaveachse liegen {cycles} "
    "({milliseconds} ms) auseinander"};
constexpr Sentence headline_positions{
    R"(gantry "{master}"/"{slave}": the positions of master and slave are {cycles} ({milliseconds} ms) apart)",
    "Gantry „{master}“/„{slave}“: die Positionen von Master- und Slaveachse liegen {cycles} "
    "({milliseconds} ms) auseinander"};
constexpr Sentence headline_same_delay{
    R"(gantry "{master}"/"{slave}": master and slave have different filters)",
    "Gantry „{master}“/„{slave}“: Master- und Slaveachse haben verschiedene Filter"};
constexpr Sentence skew{
    "at the master's `{parameter}` ({p_axis}), {velocity}, the portal skews by {skew} mm",
    "bei `{parameter}` der Masterachse ({p_axis}), {velocity}, steht das Portal um {skew} mm schief"};
constexpr Sentence same_delay{
    "their delays agree, so the portal skews only while it accelerates",
    "die Verzögerungen stimmen überein; das Portal steht nur beim Beschleunigen schief"};
constexpr Sentence help{"configure the same filters in master and slave",
                        "in Master- und Slaveachse dieselben Filter konfigurieren"};
constexpr Sentence help_feedforward{"use the same feedforward in master and slave",
                                    "in Master- und Slaveachse dieselbe Vorsteuerung verwenden"};

}  // namespace axisc::validator::checks::ax4021::says

namespace axisc::validator::checks::ax4021 {
namespace {

void add_skew(Finding& finding, LoadedAxis const& master, double seconds) {
  EffectiveValue const& limit = master.merged.values.at("getriebe[].dynamik.vb_max");
  if (limit.unusable || master.type != machine::AxisType::translatory) return;
  double const velocity = limit.value.number / 1000;
  finding.notes.push_back({says::skew,
                           {{"parameter", parameter_name(limit)},
                            {"p_axis", parameter_number(limit)},
                            {"velocity", format_rounded(velocity, 4) + " mm/s"},
                            {"skew", format_rounded(velocity * seconds, 3)}}});
}

void gantry_filters_differ(MachineContext const& context, Report& report) {
  for (LoadedGantry const& gantry : context.machine.gantries) {
    auto const master = delayed_axis(context, gantry.master);
    if (!master) continue;
    for (std::size_t const index : gantry.slaves) {
      auto const slave = delayed_axis(context, index);
      auto const difference = slave ? compare_positions({*master, *slave}) : std::nullopt;
      if (!difference) continue;
      double const seconds = difference->cycles * context.cycle_time.seconds();
      SentenceRef const headline =
          difference->feedforward_differs ? says::headline_positions : says::headline;
      Finding& finding = report_difference(
          *difference, difference->is_apart() ? headline : says::headline_same_delay, context, report);
      if (difference->is_apart()) {
        add_skew(finding, master->axis, seconds);
      } else {
        finding.notes.push_back({says::same_delay, {}});
      }
      finding.help.push_back({difference->filters_differ ? says::help : says::help_feedforward, {}});
    }
  }
}

}  // namespace

extern constinit Rule const rule{
    .parameters =
        "filter[].* filter_fir.* vib_guard.* kenngr.achs_mode kenngr.gantry_ax_nr vorsteuer.vorsteuerung "
        "vorsteuer.default_active vorsteuer.global_disable vorsteuer.feedforward_without_delay "
        "vorsteuer.timeconst_sym_filter kenngr.antr_typ",
    .needs = Needs::cycle_time,
    .check = gantry_filters_differ,
};

}  // namespace axisc::validator::checks::ax4021
