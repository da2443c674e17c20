#include "validator/engine/rule.hpp"

#include "validator/rules/filter_words.hpp"

namespace axisc::validator::checks {
namespace {

void allpass_prototype(FilterContext const& context, Report& report) {
  FilterView const& filter = context.filter;
  if (!filter.active() || filter.standard_type != design::FilterType::allpass) return;
  if (filter.prototype.unusable || filter.order.value.number <= 1) return;
  constexpr auto bessel = static_cast<double>(design::Prototype::bessel);
  if (filter.prototype.value.number == bessel) return;
  Finding& finding = report.add(filter.anchor(filter.prototype),
                                {Text::ax3014, {{"order", number(filter.order.value.number)}}});
  finding.label = Message{Text::ax3014_label, {{"prototype", symbol_word(filter.prototype)}}};
  note_default(finding, filter.prototype);
  finding.help.push_back({Text::ax3014_help, {{"parameter", parameter_name(filter.prototype)}}});
}

}  // namespace

extern constinit Rule const ax3014{
    .code = Code{3014},
    .name = "allpass-prototype",
    .severity = Severity::warning,
    .check = allpass_prototype,
};

}  // namespace axisc::validator::checks
