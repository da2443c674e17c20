#include "validator/rules/filter_checks.hpp"
#include "validator/rules/filter_words.hpp"

namespace axisc::validator::checks {

void interface_disabled(FilterContext const& context, Report& report) {
  FilterView const& filter = context.filter;
  if (filter.port != FilterPort::additional_interface) return;
  if (filter.enable.unusable || !filter.enable.value.flag()) return;
  EffectiveValue const& interface = context.axis.values.at("lr_param.add_interface.enable");
  if (interface.unusable || interface.value.flag()) return;
  Finding& finding = report.add(interface, {Text::ax3041, {{"filter", filter_name(filter)}}});
  finding.label = Message{Text::ax3041_label, {}};
  if (filter.enable.value_place) {
    finding.related.push_back({*filter.enable.value_place, {Text::ax3041_filter_here, {}}});
  }
  finding.help.push_back({Text::ax3041_help, {{"interface", parameter_name(interface)}}});
  react(finding, "", {Text::ax3041_reaction, {}});
}

}  // namespace axisc::validator::checks
