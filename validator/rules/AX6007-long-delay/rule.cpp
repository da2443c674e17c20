#include "validator/engine/rule.hpp"

#include "diagnostics/format_number.hpp"
#include "validator/rules/group_delays.hpp"

namespace axisc::validator::checks::ax6007::says {

constexpr Sentence headline{"the filters of this axis delay its setpoint by {milliseconds} ms",
                            "die Filter dieser Achse verzögern ihren Sollwert um {milliseconds} ms"};
constexpr Sentence contributions{"in cycles: {shares}", "in Zyklen: {shares}"};
constexpr Sentence note{
    "above 100 ms every stop, corner and feed hold lags noticeably; is the frequency in Hz, the time in µs?",
    "über 100 ms kommt jeder Halt, jede Ecke und jeder Vorschubhalt merklich später; ist die Frequenz in Hz, "
    "die Zeit in µs?"};
constexpr Sentence help{"use a higher frequency, or a shorter time",
                        "eine höhere Frequenz oder eine kürzere Zeit verwenden"};

}  // namespace axisc::validator::checks::ax6007::says

namespace axisc::validator::checks::ax6007 {
namespace {

constexpr double noticeable_seconds = 0.1;

void long_delay(AxisContext const& axis, Report& report) {
  auto const delay = axis_delay(axis.values, axis.cycle_time);
  if (!delay || delay->cause == nullptr) return;
  double const seconds = delay->cycles * axis.cycle_time.seconds();
  if (seconds <= noticeable_seconds) return;
  Finding& finding =
      report.add(*delay->cause, {says::headline, {{"milliseconds", format_rounded(seconds * 1e3, 3)}}});
  finding.label = Message{says::contributions, {{"shares", shares_text(*delay)}}};
  finding.notes.push_back({says::note, {}});
  finding.help.push_back({says::help, {}});
}

}  // namespace

extern constinit Rule const rule{
    .severity = Severity::note,
    .parameters = "filter[].* filter_fir.*",
    .needs = Needs::cycle_time,
    .check = long_delay,
};

}  // namespace axisc::validator::checks::ax6007
