#include "validator/engine/rule.hpp"

#include "validator/rules/filter_words.hpp"

namespace axisc::validator::checks::ax3014::says {

constexpr Sentence headline{"an all-pass of order {order} should use the prototype `BESSEL`",
                            "ein Allpass der Ordnung {order} sollte den Prototyp `BESSEL` verwenden"};
constexpr Sentence label{"with `{prototype}` the group delay is less even over the frequencies",
                         "mit `{prototype}` ist die Gruppenlaufzeit weniger gleichmäßig über der Frequenz"};
constexpr Sentence help{"`{parameter} BESSEL` delays all frequencies nearly alike",
                        "`{parameter} BESSEL` verzögert alle Frequenzen nahezu gleich"};

}  // namespace axisc::validator::checks::ax3014::says

namespace axisc::validator::checks::ax3014 {
namespace {

void allpass_prototype(FilterContext const& context, Report& report) {
  FilterView const& filter = context.filter;
  if (!filter.active() || filter.standard_type != design::FilterType::allpass) return;
  if (filter.prototype.unusable || filter.order.value.number <= 1) return;
  constexpr auto bessel = static_cast<double>(design::Prototype::bessel);
  if (filter.prototype.value.number == bessel) return;
  Finding& finding = report.add(filter.anchor(filter.prototype),
                                {says::headline, {{"order", number(filter.order.value.number)}}});
  finding.label = Message{says::label, {{"prototype", symbol_word(filter.prototype)}}};
  note_default(finding, filter.prototype);
  finding.help.push_back({says::help, {{"parameter", parameter_name(filter.prototype)}}});
}

}  // namespace

extern constinit Rule const rule{
    .severity = Severity::warning,
    .parameters = "filters[].prototype filters[].type filters[].order filters[].enable",
    .check = allpass_prototype,
};

}  // namespace axisc::validator::checks::ax3014
