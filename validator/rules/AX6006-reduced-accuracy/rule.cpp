#include "validator/engine/rule.hpp"

#include "diagnostics/format_number.hpp"
#include "validator/rules/filter_words.hpp"

#include <algorithm>

namespace axisc::validator::checks::ax6006::says {

constexpr Sentence headline{"rounding leaves `{filter}` an accuracy of about {error}",
                            "die Rundung lässt `{filter}` eine Genauigkeit von etwa {error}"};
constexpr Sentence label{"above 0.475/T = {limit} Hz", "über 0,475/T = {limit} Hz"};
constexpr Sentence note{
    "up to {limit} Hz every response is within 1e-09 of the designed one; close to half the sampling rate it "
    "is not",
    "bis {limit} Hz stimmt jede Antwort auf 1e-09 mit der entworfenen überein; nahe der halben Abtastrate "
    "nicht"};
constexpr Sentence help{"use a frequency up to {limit} Hz", "eine Frequenz bis {limit} Hz verwenden"};

}  // namespace axisc::validator::checks::ax6006::says

namespace axisc::validator::checks::ax6006 {
namespace {

constexpr double stated_accuracy = 1e-9;
constexpr double highest_share_of_nyquist = 0.95;

void reduced_accuracy(FilterContext const& context, Report& report) {
  FilterView const& filter = context.filter;
  design::FilterDesign const* const design = context.axis.designs.of(filter);
  if (design == nullptr || !design::uses_frequency(*filter.standard_type)) return;
  double const limit = highest_share_of_nyquist * context.axis.cycle_time.nyquist().value;
  if (filter.frequency.value.number <= limit) return;
  double const error = std::max(stated_accuracy, design::rounding_error(*design));
  Finding& finding =
      report.add(filter.anchor(filter.frequency),
                 {says::headline, {{"filter", filter_name(filter)}, {"error", format_rounded(error, 1)}}});
  finding.label = Message{says::label, {{"limit", number(limit)}}};
  finding.notes.push_back({says::note, {{"limit", number(limit)}}});
  finding.help.push_back({says::help, {{"limit", number(limit)}}});
}

}  // namespace

extern constinit Rule const rule{
    .severity = Severity::note,
    .parameters = "filters[].*",
    .needs = Needs::cycle_time,
    .silenced_by = codes<6001>,
    .check = reduced_accuracy,
};

}  // namespace axisc::validator::checks::ax6006
