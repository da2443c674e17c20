#include "validator/engine/rule.hpp"

#include "design/filter_kinds.hpp"
#include "validator/rules/filter_words.hpp"

namespace axisc::validator::checks::ax3012::says {

constexpr Sentence headline{"the filter type `{type}` is not documented",
                            "der Filtertyp `{type}` ist nicht dokumentiert"};
constexpr Sentence undocumented_type_interface{
    "`{type}` is for `filter[0]` only, not for the additional interface",
    "`{type}` gibt es nur in `filter[0]`, nicht in der Zusatzschnittstelle"};
constexpr Sentence label{"cannot be compiled", "lässt sich nicht kompilieren"};
constexpr Sentence limit{
    "{p_axis}: some builds know the types 7, 9 and 13; what they compute is not documented",
    "{p_axis}: manche Stände kennen die Typen 7, 9 und 13; was sie rechnen, ist nicht dokumentiert"};
constexpr Sentence limit_interface{"{p_axis}: HSC filters can be used as axis filters only",
                                   "{p_axis}: HSC-Filter sind nur als Achsfilter verwendbar"};
constexpr Sentence help{"documented are {types}", "dokumentiert sind {types}"};

}  // namespace axisc::validator::checks::ax3012::says

namespace axisc::validator::checks::ax3012 {
namespace {

bool is_undocumented(int type) {
  return type == 7 || type == 9 || type == 13;
}

/// "LOWPASS, HIGHPASS, …".
std::string standard_types() {
  std::string types;
  for (design::FilterKind const& kind : design::filter_kinds) {
    types.append(types.empty() ? "" : ", ").append(kind.word);
  }
  return types;
}

void undocumented_type(FilterContext const& context, Report& report) {
  FilterView const& filter = context.filter;
  if (filter.type_unusable()) return;
  int const type = filter.type_number();
  bool const misplaced =
      filter.port == FilterPort::additional_interface && design::find_hsc_kind(type) != nullptr;
  if (!is_undocumented(type) && !misplaced) return;
  Finding& finding = report.add(filter.type, {misplaced ? says::undocumented_type_interface : says::headline,
                                              {{"type", std::string(filter.type_word())}}});
  finding.label = Message{says::label, {}};
  finding.notes.push_back(
      {misplaced ? says::limit_interface : says::limit, {{"p_axis", parameter_number(filter.type)}}});
  finding.help.push_back({says::help, {{"types", standard_types()}}});
}

}  // namespace

extern constinit Rule const rule{
    .parameters = "filters[].type",
    .check = undocumented_type,
};

}  // namespace axisc::validator::checks::ax3012
