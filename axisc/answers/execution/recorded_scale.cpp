#include "axisc/answers/execution/recorded_scale.hpp"

#include "axisc/environment/codes.hpp"
#include "axisc/environment/failure.hpp"
#include "axisc/files/recording_problems.hpp"
#include "diagnostics/ascii.hpp"
#include "diagnostics/format_number.hpp"

#include <cmath>
#include <utility>

namespace axisc::says {

constexpr Sentence raw_or_scaled{
    "{file}: the header scales column \"{column}\" (factor {factor}, offset {offset}), but does not say "
    "whether its numbers are scaled; say --scaled or --raw",
    "{file}: der Kopf skaliert die Spalte \"{column}\" (Faktor {factor}, Offset {offset}), sagt aber nicht, "
    "ob ihre Zahlen skaliert sind; --scaled oder --raw angeben"};
constexpr Sentence neither_fits{
    "{file}: no {type} gives the numbers of column \"{column}\", raw or scaled (factor {factor}, offset "
    "{offset}); export again",
    "{file}: kein {type} ergibt die Zahlen der Spalte \"{column}\", roh oder skaliert (Faktor {factor}, "
    "Offset {offset}); neu exportieren"};
constexpr Sentence unknown_unit{
    "{file}: the unit of column \"{column}\" ({unit}) is not that of a position; say what its numbers are "
    "with --unit",
    "{file}: die Einheit der Spalte \"{column}\" ({unit}) ist nicht die einer Position; mit --unit angeben, "
    "was ihre Zahlen sind"};

}  // namespace axisc::says

namespace axisc {

namespace {

using recordings::Scaling;

Failure refusal(SentenceRef sentence, RecordingFile const& file, recordings::Channel const& channel) {
  auto const& scale = channel.scale;
  return Failure({sentence,
                  {{"file", file.name},
                   {"column", shown_column(channel.name)},
                   {"type", channel.data_type},
                   {"unit", channel.unit.empty() ? std::string("(None)") : channel.unit},
                   {"factor", exact_number(scale.unit_factor * scale.factor)},
                   {"offset", exact_number(scale.shown(0))}}},
                 csv_malformed);
}

/// What the numbers of the file are, as they will be read.
Scaling decided(RecordingFile const& file, recordings::Channel const& channel, ScaledNumbers wanted) {
  if (channel.scale.is_identity()) return Scaling::none;
  if (channel.is_raw) return Scaling::raw;
  if (wanted != ScaledNumbers::recognised) {
    return wanted == ScaledNumbers::raw ? Scaling::raw : Scaling::shown;
  }
  auto const found = recordings::scaling_of(channel);
  if (found == Scaling::open) throw refusal(says::raw_or_scaled, file, channel);
  if (found == Scaling::neither) throw refusal(says::neither_fits, file, channel);
  return found;
}

/// In the unit of the object, whose values are whole: a name alone does not say so of others.
bool is_position(ChosenColumn const& column, recordings::Signal const& signal,
                 std::vector<std::size_t> const& gaps) {
  return column.object &&
         recordings::row_of(column.object->object).unit == recordings::ObjectUnit::position &&
         (column.by != FoundBy::name || is_whole(signal, gaps));
}

ColumnScale to_raw(recordings::Channel const& channel) {
  auto const& scale = channel.scale;
  return {.factor = 1 / (scale.unit_factor * scale.factor),
          .offset = scale.raw(0),
          .is_whole = !channel.data_type.starts_with("REAL")};
}

ColumnScale to_shown(recordings::Channel const& channel) {
  auto const& scale = channel.scale;
  return {.factor = scale.unit_factor * scale.factor, .offset = scale.shown(0)};
}

}  // namespace

ColumnScale column_scale(RecordingFile const& file, ChosenColumn const& column, PositionUnits const& units,
                         image::ImageAxis const& axis, recordings::Signal const& signal,
                         std::vector<std::size_t> const& gaps) {
  auto const& channel = file.recording.channels[column.channel];
  auto const scaling = decided(file, channel, units.numbers);
  bool const is_object = is_position(column, signal, gaps);
  bool const shows = scaling == Scaling::raw && units.numbers == ScaledNumbers::shown;
  ColumnScale scale;
  if (units.unit != RecordedUnit::recognised) {
    if (shows) scale = to_shown(channel);
    scale.thousandths = thousandths_of(units.unit, axis, false);
  } else if (is_object && scaling != Scaling::shown && !shows) {
    scale.thousandths = thousandths_per_tenth;
  } else if (recordings::names_unit(channel.unit)) {
    auto const named = recordings::thousandths_in(channel.unit);
    if (!named) throw refusal(says::unknown_unit, file, channel);
    if (scaling == Scaling::raw) scale = to_shown(channel);
    scale.thousandths = *named;
  } else if (is_object) {
    if (scaling == Scaling::shown) scale = to_raw(channel);
    scale.thousandths = thousandths_per_tenth;
  } else if (scaling != Scaling::none) {
    throw refusal(says::unknown_unit, file, channel);
  } else {
    scale.thousandths = thousandths_of(RecordedUnit::recognised, axis, is_whole(signal, gaps));
    scale.is_guessed = true;
  }
  scale.scaling = scaling;
  return scale;
}

ColumnScale shown_scale(RecordingFile const& file, ChosenColumn const& column, ScaledNumbers numbers) {
  auto const& channel = file.recording.channels[column.channel];
  auto const scaling = decided(file, channel, numbers);
  auto scale = scaling == Scaling::raw ? to_shown(channel) : ColumnScale();
  scale.scaling = scaling;
  return scale;
}

recordings::Signal positions(recordings::Signal signal, ColumnScale const& scale, double thousandths) {
  bool const is_same_unit = scale.thousandths == thousandths;
  if (!scale.changes() && is_same_unit) return signal;
  double const ratio = is_same_unit ? 1 : scale.thousandths / thousandths;
  recordings::Signal made;
  for_each_part(signal, [&](std::size_t, std::span<double const> values) {
    for (double const value : values) {
      double const position = scale.factor * value + scale.offset;
      made.push((scale.is_whole ? std::nearbyint(position) : position) * ratio);
    }
  });
  return made;
}

MappedColumn mapped_column(RecordingFile const& file, ChosenColumn const& column) {
  auto const& channel = file.recording.channels[column.channel];
  return {.name = shown_column(channel.name),
          .number = channel.column,
          .by = column.by,
          .sample_time_ms = recordings::sample_time(file.recording.clocks[channel.clock]),
          .unit = {}};
}

MappedColumn mapped_column(RecordingFile const& file, ChosenColumn const& column, ColumnScale const& scale,
                           bool is_rotary) {
  auto mapped = mapped_column(file, column);
  constexpr double per_mm = 1000;
  bool const is_large = scale.thousandths >= per_mm;
  double const count = is_large || is_rotary ? scale.thousandths / per_mm : scale.thousandths;
  std::string const unit = is_rotary ? "°" : is_large ? "mm" : "µm";
  std::string const number = count == 1 ? "" : format_exact(count) + (is_rotary ? "" : " ");
  mapped.unit = Wording::number(number + unit);
  mapped.scaling = scale.scaling;
  return mapped;
}

bool names_machine(std::string_view input) {
  return !ascii::has_extension(input, ".lis");
}

}  // namespace axisc
