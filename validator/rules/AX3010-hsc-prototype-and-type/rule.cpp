#include "validator/engine/rule.hpp"

#include "validator/rules/filter_words.hpp"
#include "validator/rules/hsc_words.hpp"

namespace axisc::validator::checks {
namespace {

bool is_hsc_type(int type) {
  return type >= 7 && type <= 12 && type != 10 && type != 11;
}

void hsc_prototype_and_type(FilterContext const& context, Report& report) {
  FilterView const& filter = context.filter;
  if (filter.type_unusable() || filter.prototype.unusable) return;
  bool const type_is_hsc = is_hsc_type(filter.type_number());
  if (type_is_hsc == filter.is_hsc()) return;
  std::string const type(filter.type_word());
  EffectiveValue const& place = filter.type.set() ? filter.type : filter.anchor(filter.prototype);
  Finding& finding =
      report.add(place, {type_is_hsc ? Text::ax3010_type : Text::ax3010_prototype, {{"type", type}}});
  finding.label = Message{Text::ax3010_label, {{"prototype", symbol_word(filter.prototype)}}};
  finding.notes.push_back({Text::ax3010_limit, {{"p_axis", parameter_number(filter.type)}}});
  if (place.slot == filter.type.slot) relate_prototype(finding, filter);
  note_default(finding, filter.prototype);
  if (type_is_hsc && filter.port == FilterPort::setpoint) {
    finding.help.push_back({Text::ax3010_help, {{"parameter", parameter_name(filter.prototype)}}});
  }
}

}  // namespace

extern constinit Rule const ax3010{
    .code = Code{3010},
    .name = "hsc-prototype-and-type",
    .silenced_by = codes<3012>,
    .check = hsc_prototype_and_type,
};

}  // namespace axisc::validator::checks
