#include "validator/engine/rule.hpp"

#include "validator/rules/filter_words.hpp"
#include "validator/rules/proved_chain.hpp"

#include <algorithm>
#include <vector>

namespace axisc::validator::checks::ax6008::says {

constexpr Sentence headline{"an image proves less than usual about `{filter}`",
                            "über `{filter}` beweist ein Abbild weniger als sonst"};
constexpr Sentence loose{"not at rest after 4194304 cycles", "nach 4194304 Zyklen nicht in Ruhe"};
constexpr Sentence loose_note{
    "the bound of its gain is true, but not tight, and exact standstill is not claimed",
    "die Schranke seiner Verstärkung ist wahr, aber nicht knapp, und exakter Stillstand wird nicht zugesagt"};
constexpr Sentence uncertain{"not proved to come to rest: rounding may keep it moving",
                             "Ruhe ist nicht bewiesen: die Rundung kann Bewegung erhalten"};
constexpr Sentence uncertain_note{
    "the bound of its gain is true; neither rounding nor exact standstill is claimed",
    "die Schranke seiner Verstärkung ist wahr; weder Rundung noch exakter Stillstand werden zugesagt"};
constexpr Sentence help_slower{"lower `{parameter}`", "`{parameter}` verringern"};
constexpr Sentence help_faster{"raise `{parameter}`", "`{parameter}` erhöhen"};
constexpr Sentence help_time{"shorten `{parameter}`", "`{parameter}` verkürzen"};

}  // namespace axisc::validator::checks::ax6008::says

namespace axisc::validator::checks::ax6008 {
namespace {

/// At a value at which no finding about the same filter's speed is: AX6003 is at `enable`, AX6006 at a high
/// frequency.
void report_filter(FilterView const& filter, Proof proof, design::CycleTime cycle_time, Report& report) {
  bool const by_frequency = design::uses_frequency(*filter.standard_type);
  EffectiveValue const& cause = by_frequency ? filter.frequency : filter.time_constant;
  bool const is_fast = by_frequency && filter.frequency.value.number > cycle_time.nyquist().value / 2;
  Finding& finding = report.add(filter.anchor(is_fast ? filter.order : cause),
                                {says::headline, {{"filter", filter_name(filter)}}});
  bool const is_loose = proof == Proof::loose;
  finding.label = Message{is_loose ? says::loose : says::uncertain, {}};
  finding.notes.push_back({is_loose ? says::loose_note : says::uncertain_note, {}});
  SentenceRef help = by_frequency ? says::help_faster : says::help_time;
  if (is_fast) help = says::help_slower;
  finding.help.push_back({help, {{"parameter", parameter_name(cause)}}});
}

Proof proof_of_chain(std::vector<ChainLink> const& chain, AxisContext const& axis) {
  std::vector<design::FilterSpecification> specifications;
  specifications.reserve(chain.size());
  for (ChainLink const& link : chain) specifications.push_back(*axis.designs.specification(*link.filter));
  return proof_of(designs(chain), specifications, axis.cycle_time);
}

void loose_bounds(AxisContext const& axis, Report& report) {
  auto const report_chain = [&](std::vector<ChainLink> const& chain) {
    Proof const proof = proof_of_chain(chain, axis);
    if (proof == Proof::tight) return;
    auto const slowest =
        std::max_element(chain.begin(), chain.end(), [](ChainLink const& left, ChainLink const& right) {
          return left.design->pole_radius < right.design->pole_radius;
        });
    report_filter(*slowest->filter, proof, axis.cycle_time, report);
  };
  report_chain(axis.designs.setpoint_chain());
  for (FilterView const& filter : axis.filters) {
    design::FilterDesign const* const design = axis.designs.of(filter);
    if (filter.port != FilterPort::additional_interface || design == nullptr) continue;
    report_chain({{.filter = &filter, .design = design}});
  }
}

}  // namespace

extern constinit Rule const rule{
    .severity = Severity::note,
    .parameters =
        "filters[].fg_f0 filters[].time_constant filters[].guete filters[].type filters[].prototype "
        "filters[].order filters[].enable filters[].share_percent",
    .needs = Needs::cycle_time,
    .check = loose_bounds,
};

}  // namespace axisc::validator::checks::ax6008
