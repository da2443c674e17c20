#include "validator/engine/rule.hpp"

#include "validator/rules/filter_words.hpp"

namespace axisc::validator::checks {
namespace {

void interface_filter_invalid_default(FilterContext const& context, Report& report) {
  FilterView const& filter = context.filter;
  if (filter.port != FilterPort::additional_interface || !filter.active()) return;
  EffectiveValue const& time = filter.time_constant;
  if (time.unusable || time.value.number != 0) return;
  if (filter.standard_type != design::FilterType::pt2) return;
  Finding& finding = report.add(filter.anchor(time), {Text::ax3040, {}});
  finding.label = Message{Text::ax3040_label, {}};
  finding.notes.push_back({Text::ax3040_limit, {{"p_axis", parameter_number(time)}}});
  note_default(finding, time);
  finding.help.push_back(
      {Text::ax3040_help, {{"time_constant", parameter_name(time)}, {"type", parameter_name(filter.type)}}});
  react(finding, {Text::filter_reaction_off, {}});
}

}  // namespace

extern constinit Rule const ax3040{
    .code = Code{3040},
    .name = "interface-filter-invalid-default",
    .control = "70451",
    .check = interface_filter_invalid_default,
};

}  // namespace axisc::validator::checks
