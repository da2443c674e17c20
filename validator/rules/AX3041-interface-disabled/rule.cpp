#include "validator/engine/rule.hpp"

#include "validator/rules/filter_words.hpp"

#include <tuple>

namespace axisc::validator::checks {
namespace {

void interface_disabled(FilterContext const& context, Report& report) {
  FilterView const& filter = context.filter;
  if (filter.port != FilterPort::additional_interface) return;
  if (filter.enable.unusable || !filter.enable.value.flag()) return;
  EffectiveValue const& interface = context.axis.values.at("lr_param.add_interface.enable");
  if (interface.unusable || interface.value.flag()) return;
  bool const filter_last =
      std::tuple(interface.origin, interface.line) < std::tuple(filter.enable.origin, filter.enable.line);
  EffectiveValue const& last = filter_last ? filter.enable : interface;
  EffectiveValue const& first = filter_last ? interface : filter.enable;
  Finding& finding = report.add(last, {Text::ax3041, {{"filter", filter_name(filter)}}});
  finding.label = Message{filter_last ? Text::ax3041_filter_here : Text::ax3041_interface_here, {}};
  if (first.value_place()) {
    finding.related.push_back(
        {*first.value_place(), {filter_last ? Text::ax3041_interface_here : Text::ax3041_filter_here, {}}});
  }
  finding.help.push_back({Text::ax3041_help, {{"interface", parameter_name(interface)}}});
  react(finding, {Text::ax3041_reaction, {}});
}

}  // namespace

extern constinit Rule const ax3041{
    .code = Code{3041},
    .name = "interface-disabled",
    .severity = Severity::warning,
    .check = interface_disabled,
};

}  // namespace axisc::validator::checks
