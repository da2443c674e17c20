#include "validator/engine/rule.hpp"

#include "design/filter_analysis.hpp"
#include "diagnostics/format_number.hpp"
#include "validator/rules/filter_words.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>

namespace axisc::validator::checks::ax6003::says {

constexpr Sentence headline{"the filters of this axis need more than 10 s to settle",
                            "die Filter dieser Achse brauchen mehr als 10 s, um einzuschwingen"};
constexpr Sentence measured{"a step stays within 0.01 % after {seconds} s",
                            "ein Sprung bleibt nach {seconds} s innerhalb von 0,01 %"};
constexpr Sentence beyond{"a step is not settled after {seconds} s",
                          "ein Sprung ist nach {seconds} s nicht eingeschwungen"};
constexpr Sentence slowest{"`{filter}` is the slowest filter of the chain",
                           "`{filter}` ist der langsamste Filter der Kette"};
constexpr Sentence frequency{"`{parameter}` is {value} Hz", "`{parameter}` ist {value} Hz"};
constexpr Sentence time{"`{parameter}` is {value} µs", "`{parameter}` ist {value} µs"};
constexpr Sentence cause_here{"this value makes it slow", "dieser Wert macht ihn langsam"};
constexpr Sentence help_frequency{"raise `{parameter}`, or lower the order",
                                  "`{parameter}` erhöhen, oder die Ordnung senken"};
constexpr Sentence help_time{"shorten `{parameter}`", "`{parameter}` verkürzen"};

}  // namespace axisc::validator::checks::ax6003::says

namespace axisc::validator::checks::ax6003 {
namespace {

constexpr double longest_seconds = 10;
constexpr double measured_seconds = 40;
constexpr double tolerance = 1e-4;

enum class Settling : std::uint8_t { in_time, late };

struct Result {
  Settling settling = Settling::in_time;
  std::optional<double> seconds;  ///< none if it was not measured
};

Result settling(std::vector<ChainLink> const& chain, design::CycleTime cycle_time) {
  double const allowed = longest_seconds / cycle_time.seconds();
  auto const filters = designs(chain);
  if (std::ceil(design::settling_bound(filters, tolerance, std::floor(allowed))) <= allowed) return {};
  auto const longest = static_cast<std::uint64_t>(measured_seconds / cycle_time.seconds());
  auto const settled = design::settling_cycles(filters, longest, tolerance);
  if (!settled) return {.settling = Settling::late, .seconds = std::nullopt};
  auto const cycles = static_cast<double>(*settled);
  if (cycles <= allowed) return {};
  return {.settling = Settling::late, .seconds = cycles * cycle_time.seconds()};
}

void long_settling(AxisContext const& axis, Report& report) {
  auto const chain = axis.designs.setpoint_chain();
  if (chain.empty()) return;
  auto const slowest =
      std::max_element(chain.begin(), chain.end(), [](ChainLink const& left, ChainLink const& right) {
        return left.design->pole_radius < right.design->pole_radius;
      });
  Result const result = settling(chain, axis.cycle_time);
  if (result.settling == Settling::in_time) return;

  FilterView const& filter = *slowest->filter;
  Finding& finding = report.add(filter.anchor(filter.enable), {says::headline, {}});
  finding.label = result.seconds ? Message{says::measured, {{"seconds", format_rounded(*result.seconds, 3)}}}
                                 : Message{says::beyond, {{"seconds", number(measured_seconds)}}};
  if (chain.size() > 1) {
    finding.notes.push_back({says::slowest, {{"filter", filter_name(filter)}}});
  }
  bool const by_frequency = design::uses_frequency(*filter.standard_type);
  EffectiveValue const& cause = by_frequency ? filter.frequency : filter.time_constant;
  finding.notes.push_back({by_frequency ? says::frequency : says::time,
                           {{"parameter", parameter_name(cause)}, {"value", number(cause.value.number)}}});
  finding.help.push_back(
      {by_frequency ? says::help_frequency : says::help_time, {{"parameter", parameter_name(cause)}}});
  if (cause.value_place()) {
    finding.related.push_back({*cause.value_place(), {says::cause_here, {}}});
  }
}

}  // namespace

extern constinit Rule const rule{
    .severity = Severity::warning,
    .parameters =
        "filters[].fg_f0 filters[].time_constant filters[].guete filters[].type filters[].prototype "
        "filters[].order filters[].enable filters[].share_percent",
    .needs = Needs::cycle_time,
    .check = long_settling,
};

}  // namespace axisc::validator::checks::ax6003
