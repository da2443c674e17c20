#include "validator/engine/rule.hpp"

#include "validator/rules/filter_words.hpp"
#include "validator/rules/group_delays.hpp"
#include "validator/rules/sentences.hpp"

#include <algorithm>

namespace axisc::validator::checks::ax4010::says {

constexpr Sentence headline{
    "the axes of the channel have different linear-phase filters, although their delays agree",
    "die Achsen des Kanals haben verschiedene linearphasige Filter, obwohl ihre Verzögerungen "
    "übereinstimmen"};

}  // namespace axisc::validator::checks::ax4010::says

namespace axisc::validator::checks::ax4010 {
namespace {

bool same_kernel(std::optional<machine::ConfiguredKernel> const& left,
                 std::optional<machine::ConfiguredKernel> const& right) {
  if (!left || !right) return left.has_value() == right.has_value();
  return left->family == right->family && left->specification == right->specification &&
         left->on_at_start == right->on_at_start;
}

void group_not_identical(GroupContext const& context, Report& report) {
  Delays const delays = delays_of(context);
  auto const last = last_cause(delays);
  if (delays.size() < 2 || spread(delays) >= noticeable_delay || !last) return;
  if (spread(at_start(delays)) >= noticeable_delay) return;
  bool const identical = std::all_of(delays.begin(), delays.end(), [&](DelayedAxis const& axis) {
    return same_kernel(axis.delay.kernel, delays.front().delay.kernel);
  });
  if (identical) return;
  report.axis = delays[*last].axis.name;
  Finding& finding = report.add(*delays[*last].delay.cause, {says::headline, {}});
  finding.label = delay_of(delays[*last]);
  relate_others(finding, delays, *last);
  finding.help.push_back({validator::says::group_help_same, {}});
}

}  // namespace

extern constinit Rule const rule{
    .severity = Severity::note,
    .parameters = "filter[].* filter_fir.* vib_guard.*",
    .needs = Needs::cycle_time,
    .check = group_not_identical,
};

}  // namespace axisc::validator::checks::ax4010
