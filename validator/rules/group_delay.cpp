// AX4010 and AX4011: the axes of a channel must be delayed alike, or the contour is bent.
#include "diagnostics/format_number.hpp"
#include "validator/axis_delay.hpp"
#include "validator/fir_view.hpp"
#include "validator/hsc_view.hpp"
#include "validator/rules/filter_words.hpp"
#include "validator/rules/machine_checks.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <set>

namespace axisc::validator::checks {
namespace {

constexpr double noticeable = 0.5;

struct DelayedAxis {
  LoadedAxis const& axis;
  AxisDelay delay;
};

using Delays = std::vector<DelayedAxis>;

/// The axes whose delay is known.
Delays delays_of(GroupContext const& context) {
  Delays delays;
  if (context.group.axes.size() < 2) return delays;
  for (std::size_t const index : context.group.axes) {
    LoadedAxis const& axis = context.whole.machine.axes[index];
    if (auto const delay = axis_delay(axis.merged.values, context.whole.cycle_time)) {
      delays.push_back({axis, *delay});
    }
  }
  return delays;
}

bool less_delayed(DelayedAxis const& left, DelayedAxis const& right) {
  return left.delay.cycles < right.delay.cycles;
}

double spread(Delays const& delays) {
  if (delays.empty()) return 0;
  auto const [least, most] = std::minmax_element(delays.begin(), delays.end(), less_delayed);
  return most->delay.cycles - least->delay.cycles;
}

/// Index of the axis whose cause stands last in the lists; none where no list delays anything.
std::optional<std::size_t> last_cause(Delays const& delays) {
  std::optional<std::size_t> last;
  for (std::size_t i = 0; i < delays.size(); ++i) {
    EffectiveValue const* const cause = delays[i].delay.cause;
    if (cause == nullptr || !cause->value_place()) continue;
    if (!last || *delays[*last].delay.cause->value_place() < *cause->value_place()) last = i;
  }
  return last;
}

/// Cycles as a person reads them.
std::string cycles_text(double cycles) {
  return format_rounded(std::round(cycles * 1000) / 1000, 6);
}

Message delay_of(DelayedAxis const& axis, Text text) {
  return {text, {{"axis", axis.axis.name}, {"cycles", cycles_text(axis.delay.cycles)}}};
}

void relate_others(Finding& finding, Delays const& delays, std::size_t reported, Text text) {
  std::set<Place> known{*finding.place};
  for (std::size_t i = 0; i < delays.size(); ++i) {
    EffectiveValue const* const cause = delays[i].delay.cause;
    if (i == reported || cause == nullptr || !cause->value_place()) continue;
    if (known.insert(*cause->value_place()).second) {
      finding.related.push_back({*cause->value_place(), delay_of(delays[i], text)});
    }
  }
}

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

  void write(LoadedAxis const& axis, double cycles, std::vector<Edit>& edits) const {
    LoadedList const& list = machine_.lists[axis.list].list;
    SourceText const& source = sources_[list.source];
    std::string_view const line_end = source.bytes().find("\r\n") == std::string_view::npos ? "\n" : "\r\n";
    struct Line {
      std::string_view name;
      double value;
    };
    std::array const lines{Line{"filter_fir.enable", 1}, Line{"filter_fir.type", 4},
                           Line{"filter_fir.order", cycles}, Line{"filter_fir.share", 100}};
    std::string added;
    for (Line const& line : lines) {
      EffectiveValue const& value = axis.merged.values.at(line.name);
      if (value.value.number == line.value && !value.unusable) continue;
      std::string const text = number(line.value);
      if (value.origin == Origin::axis_list && value.value_place()) {
        edits.push_back({*value.value_place(), text});
      } else {
        added.append(line.name).append(" ").append(text).append(line_end);
      }
    }
    if (added.empty()) return;
    std::string_view const bytes = source.bytes();
    bool const open_line = !list.tree.end_marker && !bytes.empty() && bytes.back() != '\n';
    auto const end = static_cast<std::uint32_t>(bytes.size());
    std::uint32_t const at = list.tree.end_marker ? list.tree.end_marker->begin : end;
    edits.push_back({{.source = list.source, .span = {.begin = at, .end = at}},
                     open_line ? std::string(line_end) + added : added});
  }

 private:
  LoadedMachine const& machine_;
  SourceSet const& sources_;
};

/// The time delays that make all axes alike; none where they cannot.
std::optional<Fix> repair(GroupContext const& context, Delays const& delays) {
  double const longest = std::max_element(delays.begin(), delays.end(), less_delayed)->delay.cycles;
  DelayWriter const writer(context.whole.machine, context.whole.sources);
  Delays repaired = delays;
  Fix fix;
  std::string axes;
  std::set<std::size_t> written;
  for (std::size_t i = 0; i < delays.size(); ++i) {
    DelayedAxis const& lagging = delays[i];
    double const missing = std::round(longest - lagging.delay.cycles);
    if (missing == 0) continue;
    if (!DelayWriter::is_possible(lagging, missing)) return std::nullopt;
    repaired[i].delay.cycles += missing;
    axes.append(axes.empty() ? "" : ", ").append(lagging.axis.name);
    axes.append(" (").append(number(missing)).append(")");
    if (written.insert(lagging.axis.list).second) writer.write(lagging.axis, missing, fix.edits);
  }
  if (spread(repaired) >= noticeable || fix.edits.empty()) return std::nullopt;
  fix.title = {Text::ax4011_fix, {{"axes", axes}}};
  fix.safety = FixSafety::changes_behaviour;
  return fix;
}

bool same_kernel(std::optional<ConfiguredKernel> const& left, std::optional<ConfiguredKernel> const& right) {
  if (!left || !right) return left.has_value() == right.has_value();
  return left->family == right->family && left->specification == right->specification &&
         left->on_at_start == right->on_at_start;
}

}  // namespace

void group_delay_mismatch(GroupContext const& context, Report& report) {
  Delays const delays = delays_of(context);
  double const difference = spread(delays);
  auto const last = last_cause(delays);
  if (difference < noticeable || !last) return;
  report.axis = delays[*last].axis.name;
  double const milli = difference * context.whole.cycle_time.microseconds() / 1e3;
  Finding& finding = report.add(
      *delays[*last].delay.cause,
      {Text::ax4011, {{"cycles", cycles_text(difference)}, {"milliseconds", format_rounded(milli, 4)}}});
  finding.label = delay_of(delays[*last], Text::ax4011_delay);
  double const longest = std::max_element(delays.begin(), delays.end(), less_delayed)->delay.cycles;
  for (DelayedAxis const& axis : delays) {
    if (&axis == &delays[*last]) continue;
    double const missing = longest - axis.delay.cycles;
    finding.notes.push_back({missing < noticeable ? Text::ax4011_delay : Text::ax4011_missing,
                             {{"axis", axis.axis.name},
                              {"cycles", cycles_text(axis.delay.cycles)},
                              {"missing", cycles_text(missing)}}});
  }
  finding.notes.push_back({Text::ax4011_limit, {}});
  relate_others(finding, delays, *last, Text::ax4011_delay);
  finding.fix = repair(context, delays);
  finding.help.push_back({finding.fix ? Text::ax4011_help_delay : Text::ax4011_help_same, {}});
}

void group_not_identical(GroupContext const& context, Report& report) {
  Delays const delays = delays_of(context);
  auto const last = last_cause(delays);
  if (delays.size() < 2 || spread(delays) >= noticeable || !last) return;
  bool const identical = std::all_of(delays.begin(), delays.end(), [&](DelayedAxis const& axis) {
    return same_kernel(axis.delay.kernel, delays.front().delay.kernel);
  });
  if (identical) return;
  report.axis = delays[*last].axis.name;
  Finding& finding = report.add(*delays[*last].delay.cause, {Text::ax4010, {}});
  finding.label = delay_of(delays[*last], Text::ax4011_delay);
  relate_others(finding, delays, *last, Text::ax4011_delay);
  finding.help.push_back({Text::ax4011_help_same, {}});
}

}  // namespace axisc::validator::checks
