#include "axisc/answers/suggestion/measured_resonances.hpp"

#include "axisc/environment/codes.hpp"
#include "axisc/environment/failure.hpp"
#include "axisc/files/byte_source.hpp"
#include "axisc/files/recording_problems.hpp"
#include "diagnostics/format_number.hpp"

#include <array>
#include <cmath>
#include <tuple>
#include <utility>
#include <variant>

namespace axisc::says {

constexpr Sentence no_columns{
    "{file} is not a measurement: it needs columns time and two signals, or frequency_hz and magnitude_db, "
    "perhaps with phase_deg and coherence",
    "{file} ist keine Messung: nötig sind die Spalten time und zwei Signale oder frequency_hz und "
    "magnitude_db, vielleicht mit phase_deg und coherence"};
constexpr Sentence choose_columns{
    "{file}: name the input with --in and the output with --out; there are {column}",
    "{file}: mit --in den Eingang und mit --out den Ausgang nennen; es gibt {column}"};
constexpr Sentence uneven_time{"{place}: samples are missing; record again without gaps",
                               "{place}: Abtastwerte fehlen; noch einmal ohne Lücken aufzeichnen"};
constexpr Sentence other_sample_time{
    "{file}: column {in} has a sample every {first} ms, column {out} every {second} ms; record both with one "
    "sample time",
    "{file}: Spalte {in} hat alle {first} ms einen Abtastwert, Spalte {out} alle {second} ms; beide mit "
    "einer Abtastzeit aufzeichnen"};
constexpr Sentence uneven_frequency{"{file}:{line}: frequencies do not rise",
                                    "{file}:{line}: die Frequenzen steigen nicht"};
constexpr Sentence not_a_number{"{file}:{line}: not a row of numbers",
                                "{file}:{line}: keine Zeile von Zahlen"};
constexpr Sentence one_row{"{file} has only one row of numbers: record for longer",
                           "{file} hat nur eine Zeile von Zahlen: länger aufzeichnen"};
constexpr Sentence too_large{"{file} is larger than {limit} MiB: record for a shorter time",
                             "{file} ist größer als {limit} MiB: kürzer aufzeichnen"};

constexpr Sentence too_short{
    "{file} is too short to show a resonance: record at least {samples} samples, better 30 s, while noise or "
    "many starts and stops move the axis",
    "{file} ist zu kurz, um eine Resonanz zu zeigen: mindestens {samples} Abtastwerte aufzeichnen, besser 30 "
    "s, während Rauschen oder viele Anfahr- und Bremsvorgänge die Achse bewegen"};
constexpr Sentence no_peak{
    "{file} shows no resonance: nothing rises by 6 dB; if the machine vibrates, record another signal "
    "(torque and velocity, or setpoint and position of the direct measuring system)",
    "{file} zeigt keine Resonanz: nichts ragt um 6 dB heraus; wenn die Maschine schwingt, ein anderes Signal "
    "aufzeichnen (Drehmoment und Geschwindigkeit, oder Sollwert und Position des direkten Messsystems)"};
constexpr Sentence no_excitation{
    "{file} does not show the resonances: the input has no energy there{place}; record while the input "
    "contains these frequencies: noise or a sine sweep on the torque, or short moves with full acceleration",
    "{file} zeigt die Resonanzen nicht: der Eingang hat dort keine Energie{place}; aufzeichnen, während der "
    "Eingang diese Frequenzen enthält: Rauschen oder Gleitsinus auf dem Drehmoment, oder kurze Wege mit "
    "voller Beschleunigung"};
constexpr Sentence incoherent{
    "{file} does not show the resonances: the output follows something else than the input{place} (coherence "
    "below 0.8); record longer, with a stronger excitation, and with no other axis or spindle running",
    "{file} zeigt die Resonanzen nicht: der Ausgang folgt etwas anderem als dem Eingang{place} (Kohärenz "
    "unter 0,8); länger aufzeichnen, stärker anregen, ohne dass eine andere Achse oder Spindel läuft"};
constexpr Sentence moving{
    "{file} does not show one resonance: the peak{place} is elsewhere in each quarter of the recording; "
    "record at one position of the axes, with one load",
    "{file} zeigt nicht eine Resonanz: die Spitze{place} liegt in jedem Viertel der Aufzeichnung woanders; "
    "in einer Stellung der Achsen und mit einer Last aufzeichnen"};

}  // namespace axisc::says

namespace axisc {

namespace {

constexpr std::size_t largest_file = std::size_t{256} << 20U;

/// Identification needs all rows at once.
recordings::ByteSource limited_source(std::string const& path) {
  return [source = open_source(path), path, total = std::size_t{0}](std::span<char> buffer) mutable {
    auto const got = source(buffer);
    total += got;
    if (total > largest_file) {
      throw Failure({says::too_large, {{"file", path}, {"limit", std::to_string(largest_file >> 20U)}}},
                    csv_malformed);
    }
    return got;
  };
}

/// By tuning::MeasurementProblem, by tuning::Doubt.
constexpr std::array<SentenceRef, 4> problems = {says::no_columns, says::one_row, says::not_a_number,
                                                 says::uneven_frequency};
constexpr std::array<SentenceRef, 5> doubts = {says::too_short, says::no_peak, says::no_excitation,
                                               says::incoherent, says::moving};

using recordings::Object;

/// What excites the axis, and its answer.
struct Pair {
  Object in, out;
};
constexpr std::array pairs{Pair{.in = Object::torque, .out = Object::velocity},
                           Pair{.in = Object::command_position, .out = Object::actual_position}};

/// Input and output. Failure where they have to be named.
std::array<ChosenColumn, 2> chosen_columns(RecordingFile const& file, AxisPlace const& axis,
                                           SignalColumns const& wanted) {
  std::array<std::optional<ChosenColumn>, 2> chosen;
  if (wanted.in) chosen[0] = named_column(file, *wanted.in);
  if (wanted.out) chosen[1] = named_column(file, *wanted.out);
  for (auto const& pair : pairs) {
    if (chosen[0] || chosen[1]) break;
    auto const in = find_column(file, axis, pair.in, "--in");
    auto const out = find_column(file, axis, pair.out, "--out");
    if (in && out) chosen = {in, out};
  }
  bool const is_plain = file.recording.form == recordings::Form::columns;
  if (is_plain && file.recording.channels.size() == 2) {
    for (std::size_t i = 0; i < 2; ++i) {
      if (chosen.at(i)) continue;
      auto const& other = chosen.at(1 - i);
      chosen.at(i) = ChosenColumn{.channel = other ? 1 - other->channel : i, .by = FoundBy::order};
    }
  }
  if (chosen[0] && chosen[1]) return {*chosen[0], *chosen[1]};
  throw Failure({says::choose_columns, {{"file", file.name}, {"column", file.known()}}}, csv_malformed);
}

tuning::Measurement signals_of(RecordingFile const& file, std::array<ChosenColumn, 2> const& columns) {
  auto const& [channels, clocks] = std::tie(file.recording.channels, file.recording.clocks);
  std::array const chosen{columns[0].channel, columns[1].channel};
  std::array<double, 2> sample_times{};
  for (std::size_t i = 0; i < 2; ++i) {
    auto const& clock = clocks[channels[chosen.at(i)].clock];
    if (clock.is_counted) throw Failure({says::no_columns, {{"file", file.name}}}, csv_malformed);
    if (clock.problem) fail_clock(file, chosen.at(i));
    if (clock.samples < 2) throw Failure({says::one_row, {{"file", file.name}}}, csv_malformed);
    sample_times.at(i) = recordings::sample_time(clock);
  }
  constexpr double alike = 0.01;
  if (std::abs(sample_times[0] - sample_times[1]) > alike * sample_times[0]) {
    throw Failure({says::other_sample_time,
                   {{"file", file.name},
                    {"in", shown_column(channels[chosen[0]].name)},
                    {"out", shown_column(channels[chosen[1]].name)},
                    {"first", format_rounded(sample_times[0], 6)},
                    {"second", format_rounded(sample_times[1], 6)}}},
                  csv_malformed);
  }
  auto const joined = cycles_of(file, chosen, sample_times[0]);
  if (!joined.gaps.empty()) {
    throw Failure({says::uneven_time, {{"place", file.place(chosen[0], joined.gaps.front())}}},
                  csv_malformed);
  }
  constexpr double per_second = 1000;
  return {.kind = tuning::MeasurementKind::signals,
          .response = {},
          .in = joined.signals[0].values(),
          .out = joined.signals[1].values(),
          .sampling_rate = per_second / sample_times[0],
          .in_name = channels[chosen[0]].name,
          .out_name = channels[chosen[1]].name};
}

tuning::Measurement response_of(RecordingFile const& file) {
  auto read = tuning::response_measurement(file.recording);
  if (auto const* const bad = std::get_if<tuning::BadMeasurement>(&read)) {
    throw Failure({problems.at(static_cast<std::size_t>(bad->problem)),
                   {{"file", file.name}, {"line", std::to_string(bad->line)}}},
                  csv_malformed);
  }
  return std::get<tuning::Measurement>(std::move(read));
}

}  // namespace

MeasuredResonances measured_resonances(std::string const& path, AxisPlace const& axis,
                                       SignalColumns const& columns, double highest) {
  auto const file = read_recording_file(path, limited_source(path));
  MeasuredResonances answer;
  tuning::Measurement measurement;
  if (tuning::is_response(file.recording)) {
    measurement = response_of(file);
  } else {
    auto const chosen = chosen_columns(file, axis, columns);
    measurement = signals_of(file, chosen);
    for (auto const& column : chosen) answer.mapping.push_back(mapped_column(file, column));
  }
  auto found = tuning::identify(measurement, highest);
  answer.kind = measurement.kind;
  answer.peaks = std::move(found.peaks);
  if (!found.doubt) return answer;
  Wording const place =
      found.doubtful_frequency > 0 ? " (" + format_rounded(found.doubtful_frequency, 3) + " Hz)" : "";
  answer.refusal = Message{
      .sentence = doubts[static_cast<std::size_t>(*found.doubt)],
      .arguments = {{"file", path}, {"samples", std::to_string(tuning::fewest_samples)}, {"place", place}}};
  return answer;
}

}  // namespace axisc
