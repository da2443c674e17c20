#include "cli/formats/replay_report.hpp"

#include "cli/files/image_file.hpp"
#include "cli/report/json_text.hpp"
#include "cli/report/text_table.hpp"
#include "diagnostics/format_number.hpp"

#include <bit>

#include <nlohmann/json.hpp>

namespace axisc::cli::says {

constexpr Sentence head{"{cycles} cycles of {cycle_time} µs, {axes} axes, instruction set {level}",
                        "{cycles} Zyklen zu {cycle_time} µs, {axes} Achsen, Befehlssatz {level}"};
constexpr Sentence cycle{"cycle", "Zyklus"};
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
constexpr Sentence more{"and {count} more", "und {count} weitere"};

}  // namespace axisc::cli::says

namespace axisc::cli {

namespace {

using image::RecordedKind;
using image::ReplayedEntry;
using nlohmann::ordered_json;

/// Most rows of the text; a recording with many events has thousands.
constexpr std::size_t most_rows = 200;

std::string_view level_name(std::uint32_t level) {
  switch (level) {
    case AXISRT_LEVEL_X86_64_V2:
      return "x86-64-v2";
    case AXISRT_LEVEL_X86_64_V3:
      return "x86-64-v3";
    case AXISRT_LEVEL_X86_64_V4:
      return "x86-64-v4";
    case AXISRT_LEVEL_NEON:
      return "neon";
    default:
      return "portable";
  }
}

/// As an NC program would write it.
std::string command_text(axisrt_filter_command const& command) {
  std::string words;
  auto const add = [&](std::uint32_t keyword, std::string const& word) {
    if ((command.keywords & keyword) == 0) return;
    words += words.empty() ? word : " " + word;
  };
  add(AXISRT_KEYWORD_ORDER, "ORDER=" + std::to_string(command.order));
  add(AXISRT_KEYWORD_SHARE, "SHARE=" + format_exact(command.share));
  add(AXISRT_KEYWORD_FCUT, "FCUT=" + format_exact(command.fcut));
  add(AXISRT_KEYWORD_QUALITY, "QUALITY=" + format_exact(command.quality));
  add(AXISRT_KEYWORD_HSC, "HSC");
  std::string const bracket = words.empty() ? "" : " [" + words + "]";
  switch (command.action) {
    case AXISRT_ACTION_ON:
      return "#FILTER ON" + bracket;
    case AXISRT_ACTION_OFF:
      return "#FILTER OFF";
    case AXISRT_ACTION_PROGRAM_END:
      return "M30";
    default:
      return "#FILTER" + bracket;
  }
}

}  // namespace

std::string ReplayReport::say(SentenceRef text, std::vector<Argument> arguments) const {
  return render({.sentence = text, .arguments = std::move(arguments)}, language_);
}

std::string ReplayReport::name(ReplayedEntry const& entry, std::size_t axis) const {
  if (axis >= image_.axes.size()) return std::to_string(axis);
  std::string const label = axis_label(image_, axis);
  if (entry.kind == RecordedKind::step_interface) return label + ".interface";
  return entry.kind == RecordedKind::step_velocity ? label + ".v_add" : label;
}

/// The same status in consecutive cycles is one event.
void ReplayReport::add_event(ReplayEvent event) {
  for (auto before = events_.rbegin(); before != events_.rend() && before->last + 1 >= event.first;
       ++before) {
    bool const goes_on = before->subject == event.subject && before->status == event.status &&
                         before->what.empty() && event.what.empty();
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
                    .status = entry.recorded_status};
  auto const value = [&] { return std::vector<Argument>{{"value", exact_number(entry.in.at(0))}}; };
  switch (entry.kind) {
    case RecordedKind::reset:
      event.what = say(says::reset, value());
      break;
    case RecordedKind::reset_interface:
      event.what = say(says::reset_interface, value());
      break;
    case RecordedKind::reset_velocity:
      event.what = say(says::reset_velocity);
      break;
    case RecordedKind::rebase:
      event.what = say(says::rebase, value());
      break;
    default:
      event.what = command_text(entry.command);
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

std::string ReplayReport::text(std::uint32_t level) const {
  std::string text = say(says::head, {{"cycles", std::to_string(cycles_)},
                                      {"cycle_time", exact_number(image_.cycle_time.microseconds())},
                                      {"axes", std::to_string(image_.axes.size())},
                                      {"level", std::string(level_name(level))}}) +
                     "\n";
  std::vector<std::vector<std::string>> rows;
  for (auto const& event : events_) {
    if (rows.size() == most_rows) break;
    std::string const until = event.last > event.first ? "-" + std::to_string(event.last) : "";
    rows.push_back({say(says::cycle) + " " + std::to_string(event.first) + until, event.subject, event.what,
                    event.status == AXISRT_OK ? "" : axisrt_status_name(event.status)});
  }
  text += text_table(rows, 2);
  if (events_.size() > rows.size()) {
    text += "  " + say(says::more, {{"count", std::to_string(events_.size() - rows.size())}}) + "\n";
  }
  if (!first_difference_) return text + say(says::same) + "\n";
  return text +
         say(says::differs, {{"count", std::to_string(differences_)},
                             {"cycle", std::to_string(first_difference_->cycle)},
                             {"axis", first_difference_->subject},
                             {"recorded", json_number(first_difference_->recorded)},
                             {"computed", json_number(first_difference_->computed)}}) +
         "\n";
}

std::string ReplayReport::json(std::uint32_t level) const {
  ordered_json events = ordered_json::array();
  for (auto const& event : events_) {
    ordered_json row = {{"first_cycle", event.first}, {"last_cycle", event.last}, {"subject", event.subject}};
    if (!event.what.empty()) row["call"] = event.what;
    row["status"] = axisrt_status_name(event.status);
    events.push_back(std::move(row));
  }
  ordered_json document = {{"version", 1},
                           {"cycles", cycles_},
                           {"cycle_time_us", image_.cycle_time.microseconds()},
                           {"level", level_name(level)},
                           {"events", std::move(events)},
                           {"differences", differences_}};
  if (first_difference_) {
    document["first_difference"] = {{"cycle", first_difference_->cycle},
                                    {"subject", first_difference_->subject},
                                    {"recorded", first_difference_->recorded},
                                    {"computed", first_difference_->computed}};
  }
  return json_document(document);
}

}  // namespace axisc::cli
