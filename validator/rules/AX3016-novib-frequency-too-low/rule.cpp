#include "validator/engine/rule.hpp"

#include "diagnostics/format_number.hpp"
#include "validator/rules/filter_words.hpp"
#include "validator/views/hsc_view.hpp"

namespace axisc::validator::checks::ax3016::says {

constexpr Sentence headline{"HSC NoVib cannot suppress {frequency} Hz at this cycle time",
                            "HSC NoVib kann {frequency} Hz bei dieser Zykluszeit nicht unterdrücken"};
constexpr Sentence label{"this needs order {order}; at most {limit} is possible",
                         "dafür ist die Ordnung {order} nötig, möglich ist höchstens {limit}"};
constexpr Sentence limit{"{p_axis}: f ≥ 1/(101 T) = {lowest} Hz at T = {cycle}",
                         "{p_axis}: f ≥ 1/(101 T) = {lowest} Hz bei T = {cycle}"};
constexpr Sentence help{"for lower frequencies use `BANDSTOP`, which does not have this limit",
                        "für kleinere Frequenzen `BANDSTOP` verwenden, das diese Grenze nicht hat"};

}  // namespace axisc::validator::checks::ax3016::says

namespace axisc::validator::checks::ax3016 {
namespace {

void novib_frequency_too_low(FilterContext const& context, Report& report) {
  FilterView const& filter = context.filter;
  EffectiveValue const& frequency = filter.frequency;
  if (hsc_type(filter) != HscType::novib || frequency.unusable || !(frequency.value.number > 0)) return;
  design::CycleTime const cycle_time = context.axis.cycle_time;
  std::uint32_t const order = design::novib_order({frequency.value.number}, cycle_time);
  if (order <= design::longest_kernel_order) return;
  double const lowest = design::lowest_novib_frequency(cycle_time).value;
  Finding& finding =
      report.add(filter.anchor(frequency), {says::headline, {{"frequency", number(frequency.value.number)}}});
  finding.label =
      Message{says::label, {{"order", number(order)}, {"limit", number(design::longest_kernel_order)}}};
  finding.notes.push_back({says::limit,
                           {{"p_axis", parameter_number(frequency)},
                            {"lowest", format_rounded(lowest, 7)},
                            {"cycle", microseconds(cycle_time.microseconds())}}});
  note_default(finding, frequency);
  finding.help.push_back({says::help, {}});
}

}  // namespace

extern constinit Rule const rule{
    .parameters = "filter[].fg_f0 filter[].type filter[].prototype",
    .needs = Needs::cycle_time,
    .check = novib_frequency_too_low,
};

}  // namespace axisc::validator::checks::ax3016
