#include "validator/engine/rule.hpp"

#include "validator/rules/filter_words.hpp"
#include "validator/rules/sentences.hpp"
#include "validator/views/fir_view.hpp"

#include <array>
#include <string>
#include <utility>

namespace axisc::validator::checks::ax3009::says {

constexpr Sentence headline{"`{type}` does not use `{parameter}`", "`{type}` verwendet `{parameter}` nicht"};
constexpr Sentence label{"{value} has no effect", "{value} hat keine Wirkung"};
constexpr Sentence frequency{"{p_axis}: fg_f0 is for {types} and HSC_SHAPER",
                             "{p_axis}: fg_f0 gilt für {types} und HSC_SHAPER"};
constexpr Sentence prototype{"{p_axis}: prototype is for {types} and HSC filters",
                             "{p_axis}: prototype gilt für {types} und HSC-Filter"};
constexpr Sentence time_constant{"{p_axis}: time_constant is for {types} and HSC filters",
                                 "{p_axis}: time_constant gilt für {types} und HSC-Filter"};
constexpr Sentence quality{"{p_axis}: guete is for {types}", "{p_axis}: guete gilt für {types}"};
constexpr Sentence fir_frequency{"{p_axis}: fcut is for type 3, windowed sinc",
                                 "{p_axis}: fcut gilt für Typ 3, Windowed Sinc"};
constexpr Sentence fir_quality{"{p_axis}: quality is for type 2, Gaussian",
                               "{p_axis}: quality gilt für Typ 2, Gauß"};
constexpr Sentence help{"remove the line, or choose a type that uses the parameter",
                        "die Zeile entfernen, oder einen Typ wählen, der den Parameter verwendet"};

}  // namespace axisc::validator::checks::ax3009::says

namespace axisc::validator::checks::ax3009 {
namespace {

/// The parameters that a type uses (manual "axis filters", table 3.1); every type uses order and share.
struct Use {
  bool frequency = false;
  bool prototype = false;
  bool time_constant = false;
  bool quality = false;
};

Use use_of(int type) {
  if (auto const* const hsc = design::find_hsc_kind(type)) {
    return {.frequency = hsc->uses_frequency, .prototype = true, .time_constant = true};
  }
  design::FilterKind const* const kind = design::find_filter_kind(type);
  if (kind == nullptr) return {};
  return {.frequency = kind->uses_frequency,
          .prototype = kind->uses_prototype,
          .time_constant = kind->time_constant.has_value(),
          .quality = kind->quality.has_value()};
}

bool has_kernel(FilterView const& filter) {
  return filter.port == FilterPort::setpoint && filter.is_hsc() && !filter.type_unusable() &&
         design::find_hsc_kind(filter.type_number()) != nullptr;
}

/// The standard types for which `uses` is true: "BANDPASS, BANDSTOP".
std::string types_with(bool (*uses)(design::FilterType)) {
  std::string types;
  for (design::FilterKind const& kind : design::filter_kinds) {
    if (uses(kind.type)) types.append(types.empty() ? "" : ", ").append(kind.word);
  }
  return types;
}

struct Candidate {
  EffectiveValue const& parameter;
  bool used;
  SentenceRef users;
  bool (*uses)(design::FilterType) = nullptr;  ///< which standard types use it; null for filter_fir
};

Finding* check(Candidate const& candidate, std::string const& type, Report& report) {
  EffectiveValue const& parameter = candidate.parameter;
  if (candidate.used || parameter.is_target || !configured(parameter)) return nullptr;
  Finding& finding =
      report.add(parameter, {says::headline, {{"type", type}, {"parameter", parameter_name(parameter)}}});
  Wording const value = parameter.value.text.empty() ? number(parameter.value.number) : parameter.value.text;
  finding.label = Message{says::label, {{"value", value}}};
  Message users{candidate.users, {{"p_axis", parameter_number(parameter)}}};
  if (candidate.uses != nullptr) users.arguments.push_back({"types", types_with(candidate.uses)});
  finding.notes.push_back(std::move(users));
  finding.help.push_back({says::help, {}});
  react(finding, {validator::says::filter_value_ignored, {}});
  return &finding;
}

void check_filter(FilterView const& filter, Report& report) {
  if (!filter.active() && !has_kernel(filter)) return;
  Use const use = use_of(filter.type_number());
  std::array const candidates{
      Candidate{filter.frequency, use.frequency, says::frequency, design::uses_frequency},
      Candidate{filter.prototype, use.prototype, says::prototype, design::uses_prototype},
      Candidate{filter.time_constant, use.time_constant, says::time_constant, design::uses_time_constant},
      Candidate{filter.quality, use.quality, says::quality, design::uses_quality},
  };
  for (Candidate const& candidate : candidates) {
    Finding* const finding = check(candidate, std::string(filter.type_word()), report);
    if (finding != nullptr) relate_type(*finding, filter);
  }
}

void check_fir(FirView const& fir, Report& report) {
  if (!fir.configured()) return;
  FirType const type = fir.configured_type();
  std::string const name = "filter_fir.type " + number(fir.type.value.number).written();
  std::array const candidates{
      Candidate{fir.frequency, type == FirType::windowed_sinc, says::fir_frequency},
      Candidate{fir.quality, type == FirType::gaussian, says::fir_quality},
  };
  for (Candidate const& candidate : candidates) {
    Finding* const finding = check(candidate, name, report);
    if (finding != nullptr) relate_set_type(*finding, fir.type);
  }
}

void unused_parameter(AxisContext const& axis, Report& report) {
  for (FilterView const& filter : axis.filters) check_filter(filter, report);
  check_fir(axis.fir, report);
}

}  // namespace

extern constinit Rule const rule{
    .severity = Severity::warning,
    .parameters = "filters[].* filter_fir.fcut filter_fir.quality filter_fir.type",
    .precedence = Precedence::after_family,
    .check = unused_parameter,
};

}  // namespace axisc::validator::checks::ax3009
