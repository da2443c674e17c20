#include "axisc/answers/identify/identified_axis.hpp"

#include "axisc/answers/identify/model_refusal.hpp"
#include "axisc/environment/codes.hpp"
#include "axisc/environment/failure.hpp"
#include "diagnostics/format_number.hpp"
#include "validator/views/drive.hpp"

#include <cmath>
#include <utility>

namespace axisc::says {

constexpr Sentence needs_recording{
    "a recording of the axis is missing: MACHINE RECORDING...; `axisc compare --emit template --for "
    "identify` sets the scope up",
    "es fehlt eine Aufzeichnung der Achse: MASCHINE AUFZEICHNUNG...; `axisc compare --emit template --for "
    "identify` richtet das Scope ein"};
constexpr Sentence other_sample_time{
    "{file} has a sample every {own} ms, {first} every {other} ms; record all with one sample time",
    "{file} hat alle {own} ms einen Abtastwert, {first} alle {other} ms; alle mit einer Abtastzeit "
    "aufzeichnen"};
constexpr Sentence other_force{
    "{file} has its force in another unit than {first}; export both alike",
    "{file} hat die Kraft in einer anderen Einheit als {first}; beide gleich exportieren"};

}  // namespace axisc::says

namespace axisc {

namespace {

/// None where no list says it, and where the drive controls the position.
std::optional<double> kv_of(validator::LoadedAxis const& axis) {
  constexpr double unit = 0.01;  // 1/s, of P-AXIS-00099
  auto const& kv = axis.merged.values.at("getriebe[].kv");
  bool const is_control = validator::position_controller(axis) != machine::PositionController::drive;
  return kv.set() && !kv.unusable && is_control ? std::optional(kv.value.number * unit) : std::nullopt;
}

void refuse_other(MotionSignals const& own, std::string const& file, IdentifiedAxis const& found,
                  std::string const& first) {
  constexpr double alike = 0.01;
  if (std::abs(own.sample_time_ms - found.sample_time_ms) > alike * found.sample_time_ms) {
    throw Failure({says::other_sample_time,
                   {{"file", file},
                    {"first", first},
                    {"own", format_rounded(own.sample_time_ms, 6)},
                    {"other", format_rounded(found.sample_time_ms, 6)}}},
                  csv_malformed);
  }
  if (own.force != found.force) {
    throw Failure({says::other_force, {{"file", file}, {"first", first}}}, csv_malformed);
  }
}

}  // namespace

std::optional<IdentifiedAxis> identified_axis(Workspace& workspace, IdentifyQuestion const& question,
                                              ErrorSink const& errors) {
  if (question.recordings.empty()) throw Failure({says::needs_recording});
  RequestedMachine const requested(workspace, question.machine, errors);
  if (!requested.checked) return std::nullopt;
  auto const& machine = *requested.checked->machine;
  auto const axis = requested.axis(question.axis);
  auto const image = image_of(machine, requested.path);
  constexpr double microseconds = 1000;
  bool const in_machine = machine.axes.size() > 1 || names_machine(question.machine.input);
  MovedAxis const moved{.place = axis_place(machine, axis, in_machine),
                        .configured = image.contents.axes[axis],
                        .cycle_ms = machine.cycle_time.microseconds() / microseconds};
  IdentifiedAxis found{.axis = machine.axes[axis].name,
                       .is_rotary = moved.is_rotary(),
                       .force = {},
                       .model = {},
                       .mapping = {},
                       .kv = kv_of(requested.loaded->axes[axis]),
                       .files = requested.checked->files};
  auto const& files = question.recordings;
  std::vector<tuning::MotionRecord> records;
  for (auto const& file : files) {
    auto signals = motion_signals(open_recording(file), moved, question.columns, question.units);
    if (records.empty()) {
      found.force = signals.force;
      found.sample_time_ms = signals.sample_time_ms;
    }
    refuse_other(signals, file, found, files.front());
    found.is_unit_guessed = found.is_unit_guessed || signals.is_unit_guessed;
    std::string const prefix = files.size() > 1 ? file + ": " : "";
    found.mapping.push_back({prefix + "position", signals.mapping[0]});
    found.mapping.push_back({prefix + "force", signals.mapping[1]});
    records.push_back(std::move(signals.record));
    found.files.push_back(file);
  }
  found.model = tuning::rigid_model_of(records, found.sample_time_ms / microseconds);
  if (!found.model.has_mass()) throw model_refusal(files, found.model);
  return found;
}

}  // namespace axisc
