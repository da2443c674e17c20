#include "axisc/files/recorded_choice.hpp"

#include "axisc/environment/codes.hpp"
#include "axisc/environment/failure.hpp"
#include "axisc/files/recording_problems.hpp"
#include "diagnostics/ascii.hpp"

#include <algorithm>
#include <utility>

namespace axisc::says {

constexpr Sentence not_found{
    "{file} has no column that is {signal} of axis {axis}; name it with {option} COLUMN; there are "
    "{known}",
    "{file} hat keine Spalte für {signal} der Achse {axis}; sie mit {option} SPALTE nennen; vorhanden sind "
    "{known}"};
constexpr Sentence several{
    "{file} has several columns that may be {signal} of axis {axis}: {known}; name one with "
    "{option} COLUMN",
    "{file} hat für {signal} der Achse {axis} mehrere mögliche Spalten: {known}; eine mit {option} SPALTE "
    "nennen"};
constexpr Sentence envelope{
    "{file}: \"{column}\" is half of an envelope (minimum and maximum); export the samples themselves",
    "{file}: \"{column}\" ist die Hälfte einer Hüllkurve (Minimum und Maximum); die Abtastwerte selbst "
    "exportieren"};

}  // namespace axisc::says

namespace axisc {

namespace {

using recordings::Object;
using recordings::RecognisedObject;

struct Candidate {
  std::size_t channel = 0;
  FoundBy by = FoundBy::object;
  std::optional<RecognisedObject> object;
};

bool is_of_axis(RecognisedObject const& found, AxisPlace const& axis) {
  if (axis.index == 0) return true;
  if (!recordings::row_of(found.object).is_of_channel) return axis.number == 0 || found.axis == axis.number;
  return found.axis == axis.index && (axis.channel == 0 || found.channel == axis.channel);
}

/// The best kind of what is found: by index, by a template's name, by the control's name.
std::vector<Candidate> candidates(RecordingFile const& file, AxisPlace const& axis, Object object) {
  std::vector<Candidate> by_index, by_name, by_symbol;
  auto const& channels = file.recording.channels;
  auto const wanted = recordings::template_name(axis.name, object);
  for (std::size_t i = 0; i < channels.size(); ++i) {
    auto const found = recordings::object_of(channels[i]);
    bool const is_it = found && found->object == object;
    if (is_it && found->is_by_index) {
      if (is_of_axis(*found, axis)) by_index.push_back({i, FoundBy::object, found});
      continue;
    }
    bool const is_named = ascii::equal_ignoring_case(recordings::plain_name(channels[i].name), wanted);
    bool const is_other = found && found->is_by_index;
    if (is_named && !is_other) {
      by_name.push_back({i, FoundBy::name, RecognisedObject{.object = object}});
    } else if (is_it) {
      by_symbol.push_back({i, FoundBy::name, found});
    }
  }
  if (!by_index.empty()) return by_index;
  return by_name.empty() ? by_symbol : by_name;
}

/// Without those that are copies of the one before: "x (1)" with the values of "x".
void leave_out_copies(RecordingFile const& file, std::vector<Candidate>& found) {
  auto const& channels = file.recording.channels;
  auto const base = [&](Candidate const& each) {
    return recordings::plain_name(channels[each.channel].name);
  };
  for (std::size_t i = 0; i < found.size(); ++i) {
    auto const is_copy = [&, i](Candidate const& other) {
      return base(other) == base(found[i]) && are_equal(file.recording, found[i].channel, other.channel);
    };
    auto const first = found.begin() + static_cast<std::ptrdiff_t>(i) + 1;
    found.erase(std::remove_if(first, found.end(), is_copy), found.end());
  }
}

Wording phrase_of(Object object) {
  switch (object) {
    case Object::position_unfiltered: return {"the unfiltered position", "die ungefilterte Position"};
    case Object::position_filtered: return {"the filtered position", "die gefilterte Position"};
    case Object::command_position: return {"the command position", "die Sollposition"};
    case Object::actual_position: return {"the actual position", "die Istposition"};
    case Object::velocity: return {"the velocity", "die Geschwindigkeit"};
    case Object::torque: return {"the torque", "das Moment"};
    default: return recordings::row_of(object).word;
  }
}

Failure refusal(SentenceRef sentence, RecordingFile const& file, AxisPlace const& axis, Object object,
                std::string_view option, std::vector<std::size_t> const& channels) {
  return Failure({sentence,
                  {{"file", file.name},
                   {"signal", phrase_of(object)},
                   {"axis", axis.name},
                   {"option", std::string(option)},
                   {"known", channels.empty() ? file.known() : file.known(channels)}}},
                 csv_malformed);
}

/// Names that differ only in "min" and "max" at their end.
bool is_envelope(RecordingFile const& file, std::size_t channel) {
  auto const name = ascii::lower_case(file.recording.channels[channel].name);
  constexpr std::size_t size = 3;
  bool const is_low = name.ends_with("min");
  if (!is_low && !name.ends_with("max")) return false;
  auto const other = name.substr(0, name.size() - size) + (is_low ? "max" : "min");
  return std::any_of(file.recording.channels.begin(), file.recording.channels.end(),
                     [&](recordings::Channel const& each) { return ascii::lower_case(each.name) == other; });
}

void refuse_envelope(RecordingFile const& file, std::size_t channel) {
  if (!is_envelope(file, channel)) return;
  throw Failure({says::envelope,
                 {{"file", file.name}, {"column", shown_column(file.recording.channels[channel].name)}}},
                csv_malformed);
}

/// Columns of a text without a scope's header in their order, as many as signals.
void choose_by_order(RecordingFile const& file, std::vector<std::optional<ChosenColumn>>& chosen) {
  bool const has_header = file.recording.form != recordings::Form::columns;
  if (has_header || file.recording.channels.size() != chosen.size()) return;
  std::vector<std::size_t> left;
  for (std::size_t i = 0; i < chosen.size(); ++i) {
    bool const is_taken =
        std::any_of(chosen.begin(), chosen.end(), [i](auto const& one) { return one && one->channel == i; });
    if (!is_taken) left.push_back(i);
  }
  auto next = left.begin();
  for (auto& one : chosen) {
    if (!one && next != left.end()) one = ChosenColumn{.channel = *next++, .by = FoundBy::order};
  }
}

}  // namespace

AxisPlace axis_place(machine::Machine const& machine, std::size_t axis, bool in_machine) {
  auto const& configured = machine.axes[axis];
  AxisPlace place{.name = configured.name};
  if (!in_machine) return place;
  place.number = configured.number;
  for (std::size_t i = 0; i < machine.groups.size(); ++i) {
    auto const& axes = machine.groups[i].axes;
    auto const found = std::find(axes.begin(), axes.end(), axis);
    if (found == axes.end()) continue;
    place.channel = static_cast<std::uint32_t>(i + 1);
    place.index = static_cast<std::uint32_t>(found - axes.begin() + 1);
    return place;
  }
  place.index = static_cast<std::uint32_t>(axis + 1);
  return place;
}

ChosenColumn named_column(RecordingFile const& file, std::string const& wanted) {
  auto const channel = file.channel_named(wanted);
  refuse_envelope(file, channel);
  return {.channel = channel,
          .by = FoundBy::option,
          .object = recordings::object_of(file.recording.channels[channel])};
}

std::optional<ChosenColumn> find_column(RecordingFile const& file, AxisPlace const& axis, Object object,
                                        std::string_view option) {
  auto found = candidates(file, axis, object);
  leave_out_copies(file, found);
  if (found.empty()) return std::nullopt;
  if (found.size() > 1) {
    std::vector<std::size_t> channels;
    channels.reserve(found.size());
    for (auto const& each : found) channels.push_back(each.channel);
    throw refusal(says::several, file, axis, object, option, channels);
  }
  refuse_envelope(file, found.front().channel);
  return ChosenColumn{
      .channel = found.front().channel, .by = found.front().by, .object = found.front().object};
}

std::vector<ChosenColumn> choose_columns(RecordingFile const& file, AxisPlace const& axis,
                                         std::vector<WantedSignal> const& wanted) {
  std::vector<std::optional<ChosenColumn>> chosen;
  chosen.reserve(wanted.size());
  for (auto const& signal : wanted) {
    chosen.push_back(signal.column ? named_column(file, *signal.column)
                                   : find_column(file, axis, signal.object, signal.option));
  }
  choose_by_order(file, chosen);
  std::vector<ChosenColumn> all;
  for (std::size_t i = 0; i < wanted.size(); ++i) {
    if (!chosen[i]) throw refusal(says::not_found, file, axis, wanted[i].object, wanted[i].option, {});
    all.push_back(*chosen[i]);
  }
  return all;
}

std::vector<std::size_t> recorded_axes(RecordingFile const& file, machine::Machine const& machine,
                                       std::vector<Object> const& objects) {
  std::vector<std::size_t> axes;
  for (std::size_t axis = 0; axis < machine.axes.size(); ++axis) {
    auto const place = axis_place(machine, axis, true);
    bool const has_all = std::all_of(objects.begin(), objects.end(), [&](Object object) {
      return !candidates(file, place, object).empty() &&
             candidates(file, place, object).front().by == FoundBy::object;
    });
    if (has_all) axes.push_back(axis);
  }
  return axes;
}

}  // namespace axisc
