#include "axisc/answers/replay/replay_report.hpp"

#include "axisc/answers/labels.hpp"
#include "axisc/files/image_file.hpp"
#include "diagnostics/format_number.hpp"

#include <bit>

namespace axisc::says {

constexpr Sentence title{"replay of {cycles} cycles", "Wiederholung von {cycles} Zyklen"};
constexpr Sentence instruction_set{"instruction set", "Befehlssatz"};
constexpr Sentence cycle{"cycle", "Zyklus"};
constexpr Sentence last_cycle{"last cycle", "letzter Zyklus"};
constexpr Sentence subject{"axis or channel", "Achse oder Kanal"};
constexpr Sentence call{"call", "Aufruf"};
constexpr Sentence status{"status", "Status"};
constexpr Sentence reset{"reset to {value}", "zurückgesetzt auf {value}"};
constexpr Sentence reset_interface{"additional interface reset to {value}",
                                   "Zusatzschnittstelle zurückgesetzt auf {value}"};
constexpr Sentence reset_velocity{"velocities reset", "Geschwindigkeiten zurückgesetzt"};
constexpr Sentence rebase{"origin shifted by {value}", "Nullpunkt um {value} verschoben"};
constexpr Sentence same{"every output is the same, bit for bit", "jede Ausgabe ist gleich, Bit für Bit"};
constexpr Sentence differs{
    "{count} calls gave something else than the controller, the first in cycle {cycle}: {axis} gave "
    "{recorded}, here {computed}",
    "{count} Aufrufe ergaben etwas anderes als die Steuerung, der erste in Zyklus {cycle}: {axis} gab "
    "{recorded} aus, hier {computed}"};

}  // namespace axisc::says

namespace axisc {

namespace {

using image::RecordedKind;
using image::ReplayedEntry;
using namespace presentation;

/// Most rows that people see; a recording with many events has thousands.
constexpr std::size_t most_rows = 200;

std::string_view level_name(std::uint32_t level) {
  switch (level) {
    case AXISRT_LEVEL_X86_64_V2: return "x86-64-v2";
    case AXISRT_LEVEL_X86_64_V3: return "x86-64-v3";
    case AXISRT_LEVEL_X86_64_V4: return "x86-64-v4";
    case AXISRT_LEVEL_NEON: return "neon";
    default: return "portable";
  }
}

/// As an NC program would write it.
std::string command_text(axisrt_filter_command const& words) {
  if (words.action == AXISRT_ACTION_PROGRAM_END) return "M30";
  auto const has = [&words](std::uint32_t keyword) { return (words.keywords & keyword) != 0; };
  machine::FilterCommand command{.hsc = has(AXISRT_KEYWORD_HSC), .parameters = {}};
  if (words.action == AXISRT_ACTION_ON) command.filter_switch = machine::FilterSwitch::on;
  if (words.action == AXISRT_ACTION_OFF) command.filter_switch = machine::FilterSwitch::off;
  command.parameters.guard = has(AXISRT_KEYWORD_GUARD);
  if (has(AXISRT_KEYWORD_ORDER)) command.parameters.order = words.order;
  if (has(AXISRT_KEYWORD_SHARE)) command.parameters.share_percent = words.share;
  if (has(AXISRT_KEYWORD_FCUT)) command.parameters.frequency = design::Hertz{words.fcut};
  if (has(AXISRT_KEYWORD_QUALITY)) command.parameters.quality = words.quality;
  return to_text(command);
}

}  // namespace

std::string ReplayReport::name(ReplayedEntry const& entry, std::size_t axis) const {
  if (axis >= image_.axes.size()) return std::to_string(axis);
  std::string const label = axis_label(image_, axis);
  if (entry.kind == RecordedKind::step_interface) return label + ".interface";
  return entry.kind == RecordedKind::step_velocity ? label + ".v_add" : label;
}

/// The same status, or the same call with the same status, in consecutive cycles is one event.
void ReplayReport::add_event(ReplayEvent event) {
  for (auto before = events_.rbegin(); before != events_.rend() && before->last + 1 >= event.first;
       ++before) {
    // Another call in between, or the same one twice in a cycle, is no repetition.
    bool const both_call = before->subject == event.subject && !before->call.empty() && !event.call.empty();
    bool const is_other = before->call != event.call || before->status != event.status;
    if (both_call && (is_other || before->last == event.first)) break;
    bool const goes_on =
        before->subject == event.subject && before->status == event.status && before->call == event.call;
    if (!goes_on) continue;
    before->last = event.last;
    return;
  }
  events_.push_back(std::move(event));
}

void ReplayReport::add_call(ReplayedEntry const& entry) {
  ReplayEvent event{.first = entry.cycle,
                    .last = entry.cycle,
                    .subject = name(entry, entry.index),
                    .what = {},
                    .call = std::to_string(static_cast<unsigned>(entry.kind)),
                    .status = entry.recorded_status};
  for (double const value : entry.in) event.call += " " + std::to_string(std::bit_cast<std::uint64_t>(value));
  auto const at = [&entry](SentenceRef words) {
    return Words(words, {{"value", Quantity{.value = entry.in.at(0), .digits = Digits::exact()}}});
  };
  switch (entry.kind) {
    case RecordedKind::reset: event.what = at(says::reset); break;
    case RecordedKind::reset_interface: event.what = at(says::reset_interface); break;
    case RecordedKind::reset_velocity: event.what = Words(says::reset_velocity); break;
    case RecordedKind::rebase: event.what = at(says::rebase); break;
    default:
      event.call = command_text(entry.command);
      event.what = event.call;
      event.subject = entry.index < image_.groups.size() ? image_.groups[entry.index].name : std::string();
      if (event.subject.empty()) event.subject = std::to_string(entry.index);
      break;
  }
  add_event(std::move(event));
}

void ReplayReport::add_statuses(ReplayedEntry const& entry) {
  if (entry.recorded_status == AXISRT_OK) return;
  auto const add = [&](std::string subject, axisrt_status status) {
    add_event({.first = entry.cycle,
               .last = entry.cycle,
               .subject = std::move(subject),
               .what = {},
               .call = {},
               .status = status});
  };
  if (entry.status.empty()) add("-", entry.recorded_status);
  for (std::size_t axis = 0; axis < entry.status.size(); ++axis) {
    auto const status = static_cast<axisrt_status>(entry.status[axis]);
    if (status != AXISRT_OK) add(name(entry, axis), status);
  }
}

void ReplayReport::compare(ReplayedEntry const& entry) {
  if (entry.same()) return;
  differences_ += 1;
  if (first_difference_) return;
  first_difference_ = ReplayDifference{.cycle = entry.cycle, .subject = "-"};
  for (std::size_t i = 0; i < entry.recorded.size(); ++i) {
    auto const recorded = std::bit_cast<std::uint64_t>(entry.recorded[i]);
    if (recorded == std::bit_cast<std::uint64_t>(entry.computed[i])) continue;
    first_difference_->subject = name(entry, i % image_.axes.size());
    first_difference_->recorded = entry.recorded[i];
    first_difference_->computed = entry.computed[i];
    return;
  }
}

void ReplayReport::add(ReplayedEntry const& entry) {
  if (entry.kind == RecordedKind::step) cycles_ = entry.cycle + 1;
  if (entry.kind <= RecordedKind::step_velocity) {
    add_statuses(entry);
  } else {
    add_call(entry);
  }
  compare(entry);
}

Document ReplayReport::answer(std::uint32_t level) const {
  Table events{.key = "events",
               .columns = {{.key = "first_cycle", .label = says::cycle, .is_head = true},
                           {.key = "last_cycle", .label = says::last_cycle, .is_head = true},
                           {.key = "subject", .label = says::subject, .is_head = true},
                           {.key = "call", .label = says::call},
                           {.key = "status", .label = says::status, .audience = Audience::programs},
                           {.key = {}, .label = says::status, .audience = Audience::people}},
               .rows = {},
               .most_shown = most_rows};
  for (auto const& event : events_) {
    auto const* const status = axisrt_status_name(event.status);
    events.rows.push_back({event.first, event.last, event.subject, event.what, status,
                           event.status == AXISRT_OK ? Value() : Value(status)});
  }
  Document answer{
      .version = 2,
      .title = Words(says::title, {{"cycles", cycles_}}),
      .blocks = {Facts{{data("cycles", cycles_),
                        {.key = "cycle_time_us",
                         .label = labels::cycle_time,
                         .value = Quantity{.value = image_.cycle_time.microseconds(),
                                           .unit = Unit::microsecond,
                                           .digits = Digits::exact()}},
                        {.key = "axis_count", .label = labels::axes, .value = image_.axes.size()},
                        {.key = "level", .label = says::instruction_set, .value = level_name(level)},
                        data("differences", differences_)}},
                 std::move(events)},
      .csv_table = "events"};
  if (!first_difference_) {
    answer.blocks.emplace_back(Paragraph{says::same});
    return answer;
  }
  auto const number = [](double value) { return Quantity{.value = value, .digits = Digits::exact()}; };
  auto const& first = *first_difference_;
  answer.blocks.emplace_back(Section{
      .key = "first_difference",
      .title = {},
      .blocks = {Facts{{data("cycle", first.cycle), data("subject", first.subject),
                        data("recorded", number(first.recorded)), data("computed", number(first.computed))}},
                 Paragraph{Words(says::differs, {{"count", differences_},
                                                 {"cycle", first.cycle},
                                                 {"axis", first.subject},
                                                 {"recorded", number(first.recorded)},
                                                 {"computed", number(first.computed)}})}}});
  return answer;
}

}  // namespace axisc
