#include "axisc/answers/suggestion/suggested.hpp"

#include "axisc/answers/execution/group_chains.hpp"
#include "axisc/answers/execution/path_dynamics.hpp"
#include "axisc/answers/suggestion/resonance_words.hpp"
#include "axisc/environment/failure.hpp"
#include "design/units.hpp"
#include "diagnostics/format_number.hpp"
#include "validator/loading/build_version.hpp"
#include "validator/views/channel.hpp"

#include <algorithm>

namespace axisc::says {

constexpr Sentence one_source{"name either --resonance or --measured",
                              "entweder --resonance oder --measured angeben"};
constexpr Sentence of_measured{"--in and --out belong to --measured", "--in und --out gehören zu --measured"};
constexpr Sentence no_channel{
    "axis {axis} belongs to no channel: its setpoint passes no filter of a path",
    "Achse {axis} gehört zu keinem Kanal: ihr Sollwert läuft durch keinen Bahnfilter"};
constexpr Sentence feed_limited{
    "axis {axis} moves at most at {limit} mm/min (vb_max, P-AXIS-00212): this feed counts",
    "Achse {axis} fährt höchstens mit {limit} mm/min (vb_max, P-AXIS-00212): dieser "
    "Vorschub zählt"};
constexpr Sentence too_strict{
    "none of {count} settings keeps {tolerance} mm on a circle of {radius} mm at {feed} mm/min; allow a "
    "larger tolerance, or a lower feed",
    "keine von {count} Einstellungen hält {tolerance} mm auf einem Kreis von {radius} mm bei {feed} mm/min "
    "ein; eine größere Toleranz oder einen kleineren Vorschub zulassen"};
constexpr Sentence too_weak{
    "of {count} settings that keep {tolerance} mm on a circle of {radius} mm at {feed} mm/min, the best "
    "leaves {left} % of the vibration: too much to suggest it; allow a larger tolerance, or a lower feed",
    "von {count} Einstellungen, die {tolerance} mm auf einem Kreis von {radius} mm bei {feed} mm/min "
    "einhalten, lässt die beste {left} % der Schwingung: zu viel für einen Vorschlag; eine größere Toleranz "
    "oder einen kleineren Vorschub zulassen"};

}  // namespace axisc::says

namespace axisc {

namespace {

/// With the slope that the question wants.
motion::PathDynamics dynamics_of(SuggestQuestion const& question, SuggestionSubject const& subject) {
  auto dynamics = path_dynamics(subject.machine, subject.axis);
  dynamics.channel.slope = question.slope.value_or(dynamics.channel.slope);
  return dynamics;
}

SlopeSource slope_source(SuggestQuestion const& question, tuning::Task const& task) {
  if (question.slope) return SlopeSource::option;
  return task.dynamics.channel.is_from_list ? SlopeSource::channel_list : SlopeSource::control_default;
}

/// Without resonances.
tuning::Task task_of(SuggestQuestion const& question, SuggestionSubject const& subject,
                     std::optional<Message>& remark) {
  auto const& machine = subject.machine;
  auto const& axis = machine.axes[subject.axis];
  double feed = question.feed_mm_per_min;
  double const limit = axis.velocity_limit * design::mm_per_min_of_um_per_s;
  if (limit > 0 && feed > limit) {
    feed = limit;
    remark = {says::feed_limited, {{"axis", axis.name}, {"limit", format_rounded(limit, 6)}}};
  }
  auto const& build = subject.loaded.build;
  auto const knows = [&](validator::BuildVersion const& since) { return !build || !(*build < since); };
  auto const& channel = subject.loaded.groups[subject.group];
  auto const excluded_by = [&](grammar::CommandKind kind) {
    return validator::has_command(subject.loaded, channel, kind) ? tuning::Standing::excluded
                                                                 : tuning::Standing::allowed;
  };
  return {.cycle_time = machine.cycle_time,
          .resonances = {},
          .velocity = path_velocity(feed, machine.cycle_time),
          .dynamics = dynamics_of(question, subject),
          .tolerance = question.tolerance_mm * motion::units_per_mm,
          .radius = question.radius_mm * motion::units_per_mm,
          .goal = question.goal,
          .family =
              knows(validator::builds::fir_command) ? machine::KernelFamily::fir : machine::KernelFamily::hsc,
          .kernels = excluded_by(grammar::CommandKind::vibration_guard),
          .guards = knows(validator::builds::fir) ? excluded_by(grammar::CommandKind::filter)
                                                  : tuning::Standing::unknown,
          .readings = subject.loaded.readings};
}

MeasuredAxis measured_axis(SuggestQuestion const& question, machine::Machine const& machine,
                           std::size_t axis) {
  constexpr double below_nyquist = 0.9;
  constexpr double microseconds = 1000;
  bool const in_machine = machine.axes.size() > 1 || names_machine(question.machine.input);
  return {.place = axis_place(machine, axis, in_machine),
          .is_rotary = machine.axes[axis].type == machine::AxisType::rotary,
          .cycle_ms = machine.cycle_time.microseconds() / microseconds,
          .highest_hz = below_nyquist * machine.cycle_time.nyquist().value};
}

Message nothing_helps(NoSuggestion const& none, SuggestQuestion const& question) {
  bool const keeps = none.keeps > 0;
  constexpr double percent = 100;
  return {keeps ? SentenceRef(says::too_weak) : SentenceRef(says::too_strict),
          {{"count", std::to_string(keeps ? none.keeps : none.looked_at)},
           {"tolerance", exact_number(question.tolerance_mm)},
           {"radius", exact_number(question.radius_mm)},
           {"feed", format_rounded(question.feed_mm_per_min, 6)},
           {"left", format_rounded(none.least_vibration * percent, 3)}}};
}

}  // namespace

std::optional<Suggested> suggest(Workspace& workspace, SuggestQuestion const& question,
                                 ErrorSink const& errors) {
  auto const refuse = [](SentenceRef why) { return Failure({why}); };
  auto const& [in, out] = question.columns;
  if (question.resonances.has_value() != question.measured.empty()) throw refuse(says::one_source);
  if (question.measured.empty() && (in || out)) throw refuse(says::of_measured);
  RequestedMachine const requested(workspace, question.machine, errors);
  if (!requested.checked) return std::nullopt;
  auto const& machine = *requested.checked->machine;
  auto const axis = requested.axis(question.axis);
  auto const channel = channel_of_axis(machine, axis);
  if (!channel) throw Failure({says::no_channel, {{"axis", machine.axes[axis].name}}});
  SuggestionSubject const subject{.path = requested.path,
                                  .workspace = workspace,
                                  .loaded = *requested.loaded,
                                  .sources = requested.sources,
                                  .machine = machine,
                                  .group = *channel,
                                  .axis = axis};
  Suggested found{.axis = machine.axes[axis].name,
                  .group = machine.groups[subject.group].name,
                  .files = requested.checked->files};
  found.files.insert(found.files.end(), question.measured.begin(), question.measured.end());
  if (question.plant) found.files.push_back(*question.plant);
  std::optional<MeasuredResonances> measured;
  std::vector<tuning::Resonance> resonances;
  if (!question.measured.empty()) {
    measured =
        measured_resonances(question.measured, measured_axis(question, machine, axis), question.columns);
    for (auto const& mode : measured->found.modes) {
      resonances.push_back(
          {.frequency = mode.frequency, .damping = mode.damping, .uncertainty = mode.frequency_uncertainty});
    }
  } else {
    resonances = read_resonances(question.resonances.value_or(""), machine.cycle_time);
  }
  found.task = task_of(question, subject, found.remark);
  found.task.resonances = std::move(resonances);
  found.slope_source = slope_source(question, found.task);
  found.ramps = ramp_times_for(subject, found.task);
  if (question.plant) found.damping = damping_for(subject, found.task, *question.plant);
  found.filters = suggestion_for(subject, found.task);
  if (auto* const suggestion = std::get_if<Suggestion>(&found.filters)) {
    suggestion->measured = std::move(measured);
  } else {
    found.refusal = nothing_helps(std::get<NoSuggestion>(found.filters), question);
  }
  return found;
}

}  // namespace axisc
