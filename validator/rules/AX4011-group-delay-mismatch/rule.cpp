#include "validator/engine/rule.hpp"

#include "diagnostics/format_number.hpp"
#include "validator/rules/filter_words.hpp"
#include "validator/rules/group_delays.hpp"
#include "validator/rules/sentences.hpp"
#include "validator/views/fir_view.hpp"
#include "validator/views/hsc_view.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <set>

namespace axisc::validator::checks::ax4011::says {

constexpr Sentence headline{
    "the axes of the channel are out of step: their filter delays differ by {cycles} ({milliseconds} "
    "ms)",
    "die Achsen des Kanals laufen nicht synchron: ihre Filterverzögerungen unterscheiden sich um {cycles} "
    "({milliseconds} ms)"};
constexpr Sentence headline_at_start{
    "the axes of the channel are out of step from start-up on: their filter delays differ by {cycles} "
    "({milliseconds} ms)",
    "die Achsen des Kanals laufen vom Hochlauf an nicht synchron: ihre Filterverzögerungen unterscheiden "
    "sich um {cycles} ({milliseconds} ms)"};
constexpr Sentence waits_for_command{
    "the linear-phase filter of axis \"{axis}\" works only after `#FILTER ON`",
    "der linearphasige Filter der Achse „{axis}“ wirkt erst nach `#FILTER ON`"};
constexpr Sentence help_enable{"set `filter_fir.enable` alike in all axes",
                               "`filter_fir.enable` in allen Achsen gleich setzen"};
constexpr Sentence odd{"axis \"{axis}\" is out of step with the others: `{filter}` makes the difference",
                       "Achse „{axis}“ läuft nicht mit den anderen: `{filter}` macht den Unterschied"};
constexpr Sentence limit{
    "filter[0] to filter[2] if active, filter_fir or HSC if configured, at 0 Hz; differences below half a "
    "cycle are ignored",
    "filter[0] bis filter[2], wo aktiv, filter_fir oder HSC, wo konfiguriert, bei 0 Hz; Unterschiede unter "
    "einem halben Zyklus zählen nicht"};
constexpr Sentence limit_at_start{
    "filter[0] to filter[2] if active, filter_fir if enabled, at 0 Hz; differences below half a cycle are "
    "ignored",
    "filter[0] bis filter[2], wo aktiv, filter_fir, wo eingeschaltet, bei 0 Hz; Unterschiede unter einem "
    "halben Zyklus zählen nicht"};
constexpr Sentence help_delay{
    "use the same filter in all axes, or a time delay (`filter_fir.type 4`) in those that lack it",
    "denselben Filter in allen Achsen verwenden, oder eine Zeitverzögerung (`filter_fir.type 4`) in denen "
    "ohne ihn"};
constexpr Sentence fix{"add time delays: {axes}", "Zeitverzögerungen ergänzen: {axes}"};

}  // namespace axisc::validator::checks::ax4011::says

namespace axisc::validator::checks::ax4011 {
namespace {

/// Writes the time delay into the list of an axis that has no linear-phase filter.
class DelayWriter {
 public:
  DelayWriter(LoadedMachine const& machine, SourceSet const& sources)
      : machine_(machine), sources_(sources) {}

  [[nodiscard]] static bool is_possible(DelayedAxis const& axis, double cycles) {
    EffectiveValues const& values = axis.axis.merged.values;
    EffectiveValue const& guard = values.at("vib_guard.active");
    bool const free = !axis.delay.kernel && configured_hsc(values).empty() && !FirView(values).configured();
    bool const guarded = guard.unusable || guard.value.flag();
    return free && !guarded && cycles >= 1 && cycles <= design::longest_kernel_delay;
  }

  /// `enable`: 1 for a delay that works from start-up, 0 for one that `#FILTER ON` switches on.
  void write(LoadedAxis const& axis, double cycles, double enable, std::vector<Edit>& edits) const {
    LoadedList const& list = machine_.lists[axis.list].list;
    SourceText const& source = sources_[list.source];
    struct Line {
      std::string_view name;
      double value;
    };
    std::array const lines{Line{"filter_fir.enable", enable}, Line{"filter_fir.type", 4},
                           Line{"filter_fir.order", cycles}, Line{"filter_fir.share", 100}};
    std::string added;
    for (Line const& line : lines) {
      EffectiveValue const& value = axis.merged.values.at(line.name);
      if (value.value.number == line.value && !value.unusable) continue;
      std::string const text = format_exact(line.value);
      if (value.origin == Origin::axis_list && value.value_place()) {
        edits.push_back({*value.value_place(), text});
      } else {
        added.append(line.name).append(" ").append(text).append("\n");
      }
    }
    if (added.empty()) return;
    std::string_view const bytes = source.bytes();
    bool const open_line = !list.tree.end_marker && !bytes.empty() && bytes.back() != '\n';
    auto const end = static_cast<std::uint32_t>(bytes.size());
    std::uint32_t const at = list.tree.end_marker ? list.tree.end_marker->begin : end;
    edits.push_back(
        {{.source = list.source, .span = {.begin = at, .end = at}}, open_line ? "\n" + added : added});
  }

 private:
  LoadedMachine const& machine_;
  SourceSet const& sources_;
};

bool is_hsc(DelayedAxis const& axis) {
  return axis.delay.kernel && axis.delay.kernel->family == machine::KernelFamily::hsc;
}

/// The delays with time delays added; none if that is impossible, or would hold in one state alone.
std::optional<Delays> repaired(Delays const& delays, bool works_at_start) {
  // HSC filters have commands of their own.
  if (!works_at_start && std::any_of(delays.begin(), delays.end(), is_hsc)) return std::nullopt;
  double const longest = std::max_element(delays.begin(), delays.end(), less_delayed)->delay.cycles;
  Delays result = delays;
  Delays started = at_start(delays);
  for (std::size_t i = 0; i < delays.size(); ++i) {
    double const missing = std::round(longest - delays[i].delay.cycles);
    if (missing == 0) continue;
    if (!DelayWriter::is_possible(delays[i], missing)) return std::nullopt;
    result[i].delay.cycles += missing;
    if (works_at_start) started[i].delay.cycles += missing;
  }
  if (spread(result) >= noticeable_delay || spread(started) >= noticeable_delay) return std::nullopt;
  return result;
}

/// The time delays that make all delays equal, at start-up and after `#FILTER ON`; none if that is
/// impossible.
std::optional<Fix> repair(GroupContext const& context, Delays const& delays) {
  double enable = 1;
  auto goal = repaired(delays, true);
  if (!goal) {
    enable = 0;
    goal = repaired(delays, false);
  }
  if (!goal) return std::nullopt;
  DelayWriter const writer(context.whole.machine, context.whole.sources);
  Fix fix;
  std::string axes;
  std::set<std::size_t> written;
  for (std::size_t i = 0; i < delays.size(); ++i) {
    LoadedAxis const& axis = delays[i].axis;
    double const added = (*goal)[i].delay.cycles - delays[i].delay.cycles;
    double const missing = std::round(added);
    if (missing == 0) continue;
    axes.append(axes.empty() ? "" : ", ").append(axis.name);
    axes.append(" (").append(format_exact(missing)).append(")");
    if (written.insert(axis.list).second) writer.write(axis, missing, enable, fix.edits);
  }
  if (fix.edits.empty()) return std::nullopt;
  fix.title = {says::fix, {{"axes", axes}}};
  fix.safety = FixSafety::changes_behaviour;
  return fix;
}

bool in_step(DelayedAxis const& left, DelayedAxis const& right) {
  return std::abs(left.delay.cycles - right.delay.cycles) < noticeable_delay;
}

std::size_t companions(Delays const& delays, DelayedAxis const& of) {
  return static_cast<std::size_t>(std::count_if(delays.begin(), delays.end(),
                                                [&](DelayedAxis const& axis) { return in_step(axis, of); }));
}

/// An axis that the others disagree with, one of those, and the filter of the former that makes the
/// difference.
struct OddAxis {
  std::size_t index;
  std::size_t typical;
  DelayShare const* filter;
};

/// None where no axis stands alone against a majority, or where it lacks what the others have.
std::optional<OddAxis> odd_axis(Delays const& delays) {
  std::size_t typical = 0;
  for (std::size_t i = 1; i < delays.size(); ++i) {
    if (companions(delays, delays[i]) > companions(delays, delays[typical])) typical = i;
  }
  if (2 * companions(delays, delays[typical]) <= delays.size()) return std::nullopt;
  std::optional<OddAxis> odd;
  for (std::size_t i = 0; i < delays.size(); ++i) {
    if (in_step(delays[i], delays[typical])) continue;
    DelayShare const* const filter = largest_difference(delays[i].delay, delays[typical].delay);
    if (filter == nullptr) return std::nullopt;
    odd = {.index = i, .typical = typical, .filter = filter};
  }
  return odd;
}

/// What the axes are delayed by after their filters makes them equal.
bool makes_up_for_feedforward(Delays const& delays) {
  Delays whole = delays;
  for (DelayedAxis& axis : whole) axis.delay.cycles += axis.after_filters;
  return spread(whole) < noticeable_delay;
}

bool out_of_step(Delays const& delays) {
  return spread(delays) >= noticeable_delay && last_cause(delays) && !makes_up_for_feedforward(delays);
}

Finding& report_mismatch(GroupContext const& context, Delays const& delays, SentenceRef headline,
                         Report& report) {
  double const difference = spread(delays);
  auto const odd = odd_axis(delays);
  std::size_t const reported = odd ? odd->index : *last_cause(delays);
  report.axis = delays[reported].axis.name;
  double const milli = difference * context.whole.cycle_time.microseconds() / 1e3;
  Finding& finding = report.add(
      odd ? *odd->filter->cause : *delays[reported].delay.cause,
      {headline, {{"cycles", counted_cycles(difference)}, {"milliseconds", format_rounded(milli, 4)}}});
  finding.label = delay_of(delays[reported]);
  if (odd) {
    finding.notes.push_back(
        {says::odd, {{"axis", std::string(report.axis)}, {"filter", odd->filter->filter}}});
  }
  for (DelayedAxis const& axis : delays) {
    if (&axis != &delays[reported]) finding.notes.push_back(delay_of(axis));
  }
  auto const [least, most] = extremes_after_filters(delays);
  if (most->after_filters - least->after_filters >= noticeable_delay) {
    for (DelayedAxis const& axis : delays) finding.notes.push_back(delay_after_filters_of(axis));
  }
  if (!odd) relate_others(finding, delays, reported);
  return finding;
}

void report_configured(GroupContext const& context, Delays const& delays, Report& report) {
  Finding& finding = report_mismatch(context, delays, says::headline, report);
  finding.notes.push_back({says::limit, {}});
  finding.fix = repair(context, delays);
  finding.help.push_back({finding.fix ? says::help_delay : validator::says::group_help_same, {}});
}

/// `configured` agree.
void report_at_start(GroupContext const& context, Delays const& configured, Delays const& started,
                     Report& report) {
  Finding& finding = report_mismatch(context, started, says::headline_at_start, report);
  for (DelayedAxis const& axis : configured) {
    if (!axis.delay.kernel || axis.delay.kernel->on_at_start) continue;
    finding.notes.push_back({says::waits_for_command, {{"axis", axis.axis.name}}});
  }
  finding.notes.push_back({says::limit_at_start, {}});
  finding.help.push_back({says::help_enable, {}});
}

void group_delay_mismatch(GroupContext const& context, Report& report) {
  Delays const configured = delays_of(context);
  if (out_of_step(configured)) {
    report_configured(context, configured, report);
    return;
  }
  Delays const started = at_start(configured);
  if (out_of_step(started)) report_at_start(context, configured, started, report);
}

}  // namespace

extern constinit Rule const rule{
    .severity = Severity::warning,
    .parameters = "filter[].* filter_fir.* vib_guard.*",
    .needs = Needs::cycle_time,
    .check = group_delay_mismatch,
};

}  // namespace axisc::validator::checks::ax4011
