#include "validator/engine/rule.hpp"

#include "validator/views/fir_view.hpp"
#include "validator/rules/filter_words.hpp"

#include <array>
#include <string>
#include <utility>

namespace axisc::validator::checks {
namespace {

constexpr int hsc_mean = 8;
constexpr int hsc_novib = 12;

/// What a type makes use of (manual "axis filters", table 3.1); every type uses order and share.
struct Use {
  bool frequency = false;
  bool prototype = false;
  bool time_constant = false;
  bool quality = false;
};

Use use_of(int type) {
  if (type == hsc_mean) return {.frequency = false, .prototype = true, .time_constant = true};
  if (type == hsc_novib) return {.frequency = true, .prototype = true, .time_constant = true};
  design::FilterKind const* const kind = design::find_filter_kind(type);
  if (kind == nullptr) return {};
  return {.frequency = kind->uses_frequency,
          .prototype = kind->uses_prototype,
          .time_constant = kind->time_constant.has_value(),
          .quality = kind->quality.has_value()};
}

bool has_kernel(FilterView const& filter) {
  int const type = filter.type_number();
  return filter.port == FilterPort::setpoint && filter.is_hsc() && !filter.type_unusable() &&
         (type == hsc_mean || type == hsc_novib);
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
  Text users;
  bool (*uses)(design::FilterType) = nullptr;  ///< which standard types use it; null for filter_fir
};

Finding* check(Candidate const& candidate, std::string const& type, Report& report) {
  EffectiveValue const& parameter = candidate.parameter;
  if (candidate.used || !configured(parameter)) return nullptr;
  Finding& finding =
      report.add(parameter, {Text::ax3009, {{"type", type}, {"parameter", parameter_name(parameter)}}});
  std::string const value =
      parameter.value.text.empty() ? number(parameter.value.number) : std::string(parameter.value.text);
  finding.label = Message{Text::ax3009_label, {{"value", value}}};
  Message users{candidate.users, {{"p_axis", parameter_number(parameter)}}};
  if (candidate.uses != nullptr) users.arguments.push_back({"types", types_with(candidate.uses)});
  finding.notes.push_back(std::move(users));
  react(finding, {Text::filter_value_ignored, {}});
  return &finding;
}

void check_filter(FilterView const& filter, Report& report) {
  if (!filter.active() && !has_kernel(filter)) return;
  Use const use = use_of(filter.type_number());
  std::array const candidates{
      Candidate{filter.frequency, use.frequency, Text::ax3009_frequency, design::uses_frequency},
      Candidate{filter.prototype, use.prototype, Text::ax3009_prototype, design::uses_prototype},
      Candidate{filter.time_constant, use.time_constant, Text::ax3009_time_constant,
                design::uses_time_constant},
      Candidate{filter.quality, use.quality, Text::ax3009_quality, design::uses_quality},
  };
  for (Candidate const& candidate : candidates) {
    Finding* const finding = check(candidate, std::string(filter.type_word()), report);
    if (finding != nullptr) relate_type(*finding, filter);
  }
}

void check_fir(FirView const& fir, Report& report) {
  if (!fir.configured()) return;
  FirType const type = fir.configured_type();
  std::string const name = "filter_fir.type " + number(fir.type.value.number);
  std::array const candidates{
      Candidate{fir.frequency, type == FirType::windowed_sinc, Text::ax3009_fir_frequency},
      Candidate{fir.quality, type == FirType::gaussian, Text::ax3009_fir_quality},
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

extern constinit Rule const ax3009{
    .code = Code{3009},
    .name = "unused-parameter",
    .severity = Severity::warning,
    .precedence = Precedence::after_family,
    .check = unused_parameter,
};

}  // namespace axisc::validator::checks
