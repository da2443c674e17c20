#include "validator/engine/rule.hpp"

#include "validator/rules/filter_words.hpp"
#include "validator/rules/hsc_words.hpp"

namespace axisc::validator::checks::ax3010::says {

constexpr Sentence type{"`{type}` needs the prototype `HSC`", "`{type}` braucht den Prototyp `HSC`"};
constexpr Sentence prototype{"the prototype `HSC` does not match the type `{type}`",
                             "der Prototyp `HSC` passt nicht zum Typ `{type}`"};
constexpr Sentence label{"the prototype is `{prototype}`", "der Prototyp ist `{prototype}`"};
constexpr Sentence limit{
    "{p_axis}: HSC_MEAN and HSC_SHAPER only with prototype HSC, the other types only without",
    "{p_axis}: HSC_MEAN und HSC_SHAPER nur mit Prototyp HSC, die anderen Typen nur ohne"};
constexpr Sentence help{"`{parameter} HSC` makes it an HSC filter",
                        "`{parameter} HSC` macht ihn zum HSC-Filter"};
constexpr Sentence help_standard{"use the prototype `CRIT_DAMPING`, `BUTTERWORTH` or `BESSEL`",
                                 "den Prototyp `CRIT_DAMPING`, `BUTTERWORTH` oder `BESSEL` verwenden"};

}  // namespace axisc::validator::checks::ax3010::says

namespace axisc::validator::checks::ax3010 {
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
  Finding& finding = report.add(place, {type_is_hsc ? says::type : says::prototype, {{"type", type}}});
  finding.label = Message{says::label, {{"prototype", symbol_word(filter.prototype)}}};
  finding.notes.push_back({says::limit, {{"p_axis", parameter_number(filter.type)}}});
  if (place.slot == filter.type.slot) relate_prototype(finding, filter);
  note_default(finding, filter.prototype);
  if (type_is_hsc && filter.port == FilterPort::setpoint) {
    finding.help.push_back({says::help, {{"parameter", parameter_name(filter.prototype)}}});
  } else if (!type_is_hsc) {
    finding.help.push_back({says::help_standard, {}});
  }
}

}  // namespace

extern constinit Rule const rule{
    .parameters = "filters[].prototype filters[].type",
    .silenced_by = codes<3012>,
    .check = hsc_prototype_and_type,
};

}  // namespace axisc::validator::checks::ax3010
