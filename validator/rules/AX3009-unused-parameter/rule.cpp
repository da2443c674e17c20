#include "validator/rule.hpp"

#include "validator/fir_view.hpp"
#include "validator/rules/filter_words.hpp"

#include <array>
#include <string>

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
  auto const standard = static_cast<design::FilterType>(type);
  return {.frequency = design::uses_frequency(standard),
          .prototype = design::uses_prototype(standard),
          .time_constant = design::uses_time_constant(standard),
          .quality = design::uses_quality(standard)};
}

bool has_kernel(FilterView const& filter) {
  int const type = filter.type_number();
  return filter.port == FilterPort::setpoint && filter.is_hsc() && !filter.type_unusable() &&
         (type == hsc_mean || type == hsc_novib);
}

Finding* check(EffectiveValue const& parameter, bool used, std::string const& type, Text users,
               Report& report) {
  if (used || !configured(parameter)) return nullptr;
  Finding& finding =
      report.add(parameter, {Text::ax3009, {{"type", type}, {"parameter", parameter_name(parameter)}}});
  std::string const value =
      parameter.value.text.empty() ? number(parameter.value.number) : std::string(parameter.value.text);
  finding.label = Message{Text::ax3009_label, {{"value", value}}};
  finding.notes.push_back({users, {{"p_axis", parameter_number(parameter)}}});
  react(finding, {Text::filter_value_ignored, {}});
  return &finding;
}

struct Candidate {
  EffectiveValue const& parameter;
  bool used;
  Text users;
};

void check_filter(FilterView const& filter, Report& report) {
  if (!filter.active() && !has_kernel(filter)) return;
  Use const use = use_of(filter.type_number());
  std::array const candidates{
      Candidate{filter.frequency, use.frequency, Text::ax3009_frequency},
      Candidate{filter.prototype, use.prototype, Text::ax3009_prototype},
      Candidate{filter.time_constant, use.time_constant, Text::ax3009_time_constant},
      Candidate{filter.quality, use.quality, Text::ax3009_quality},
  };
  for (Candidate const& candidate : candidates) {
    Finding* const finding =
        check(candidate.parameter, candidate.used, std::string(filter.type_word()), candidate.users, report);
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
    Finding* const finding = check(candidate.parameter, candidate.used, name, candidate.users, report);
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
