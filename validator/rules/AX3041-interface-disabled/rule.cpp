#include "validator/engine/rule.hpp"

#include "validator/rules/filter_words.hpp"

#include <tuple>

namespace axisc::validator::checks::ax3041::says {

constexpr Sentence headline{"the additional interface is switched off: `{filter}` has no effect",
                            "die Zusatzschnittstelle ist ausgeschaltet: `{filter}` hat keine Wirkung"};
constexpr Sentence interface_here{"the interface is switched off here",
                                  "hier wird die Schnittstelle ausgeschaltet"};
constexpr Sentence filter_here{"the filter is enabled here", "hier wird der Filter eingeschaltet"};
constexpr Sentence help{"`{interface} 1` switches the interface on (the default)",
                        "`{interface} 1` schaltet die Schnittstelle ein (Standardwert)"};
constexpr Sentence reaction{"setpoints of the additional interface are not used",
                            "Sollwerte der Zusatzschnittstelle werden nicht verwendet"};

}  // namespace axisc::validator::checks::ax3041::says

namespace axisc::validator::checks::ax3041 {
namespace {

void interface_disabled(FilterContext const& context, Report& report) {
  FilterView const& filter = context.filter;
  if (filter.port != FilterPort::additional_interface) return;
  if (!filter.enable.is_on()) return;
  EffectiveValue const& interface = context.axis.values.at("lr_param.add_interface.enable");
  if (interface.unusable || interface.value.flag()) return;
  bool const filter_last =
      std::tuple(interface.origin, interface.line) < std::tuple(filter.enable.origin, filter.enable.line);
  EffectiveValue const& last = filter_last ? filter.enable : interface;
  EffectiveValue const& first = filter_last ? interface : filter.enable;
  Finding& finding = report.add(last, {says::headline, {{"filter", filter_name(filter)}}});
  finding.label = Message{filter_last ? says::filter_here : says::interface_here, {}};
  if (first.value_place()) {
    finding.related.push_back(
        {*first.value_place(), {filter_last ? says::interface_here : says::filter_here, {}}});
  }
  finding.help.push_back({says::help, {{"interface", parameter_name(interface)}}});
  react(finding, {says::reaction, {}});
}

}  // namespace

extern constinit Rule const rule{
    .severity = Severity::warning,
    .parameters =
        "lr_param.add_interface.enable lr_param.add_interface.filter[].enable "
        "lr_param.add_interface.filter[].order lr_param.add_interface.filter[].time_constant",
    .check = interface_disabled,
};

}  // namespace axisc::validator::checks::ax3041
