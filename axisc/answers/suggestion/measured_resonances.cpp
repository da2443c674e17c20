#include "axisc/answers/suggestion/measured_resonances.hpp"

#include "axisc/answers/suggestion/measured_refusal.hpp"
#include "axisc/environment/codes.hpp"
#include "axisc/environment/failure.hpp"
#include "axisc/files/byte_source.hpp"

#include <array>
#include <optional>
#include <utility>
#include <variant>

namespace axisc::says {

constexpr Sentence no_magnitude{
    "{file} is not a measurement: it needs columns time and two signals, or frequency_hz and magnitude_db, "
    "perhaps with phase_deg and coherence",
    "{file} ist keine Messung: nötig sind die Spalten time und zwei Signale oder frequency_hz und "
    "magnitude_db, vielleicht mit phase_deg und coherence"};
constexpr Sentence uneven_frequency{"{file}:{line}: frequencies do not rise",
                                    "{file}:{line}: die Frequenzen steigen nicht"};
constexpr Sentence not_a_number{"{file}:{line}: not a row of numbers",
                                "{file}:{line}: keine Zeile von Zahlen"};
constexpr Sentence one_row{"{file} has only one row of numbers: record for longer",
                           "{file} hat nur eine Zeile von Zahlen: länger aufzeichnen"};
constexpr Sentence too_large{"{file} is larger than {limit} MiB: record for a shorter time",
                             "{file} ist größer als {limit} MiB: kürzer aufzeichnen"};
constexpr Sentence other_setpoint{
    "{file}: its setpoint has another unit or name than that of {first}, so that their speeds cannot be "
    "compared; export both alike, or name the columns with --in and --out",
    "{file}: Der Sollwert hat eine andere Einheit oder einen anderen Namen als der von {first}, sodass die "
    "Geschwindigkeiten nicht vergleichbar sind; beide gleich exportieren oder die Spalten mit --in und --out "
    "nennen"};

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

/// By tuning::MeasurementProblem.
constexpr std::array<SentenceRef, 4> problems = {says::no_magnitude, says::one_row, says::not_a_number,
                                                 says::uneven_frequency};

tuning::Measurement response_of(RecordingFile const& file) {
  auto read = tuning::response_measurement(file.recording);
  if (auto const* const bad = std::get_if<tuning::BadMeasurement>(&read)) {
    throw Failure({problems.at(static_cast<std::size_t>(bad->problem)),
                   {{"file", file.name}, {"line", std::to_string(bad->line)}}},
                  csv_malformed);
  }
  return std::get<tuning::Measurement>(std::move(read));
}

/// The first setpoint, with which those of other files must be comparable.
struct Setpoint {
  std::string file, unit, name;
  tuning::InputKind kind;
};

}  // namespace

MeasuredResonances measured_resonances(std::vector<std::string> const& paths, MeasuredAxis const& axis,
                                       SignalColumns const& columns) {
  MeasuredResonances answer;
  std::vector<tuning::Measurement> measurements;
  std::optional<Setpoint> first;
  for (auto const& path : paths) {
    auto const file = read_recording_file(path, limited_source(path));
    if (tuning::is_response(file.recording)) {
      measurements.push_back(response_of(file));
      answer.has_spectrum |= measurements.back().kind == tuning::MeasurementKind::spectrum;
      continue;
    }
    auto signals = measured_signals(file, axis, columns);
    std::string const prefix = paths.size() > 1 ? path + ": " : "";
    answer.mapping.push_back({prefix + "in", signals.mapping[0]});
    answer.mapping.push_back({prefix + "out", signals.mapping[1]});
    auto const kind = signals.measurement.input;
    if (kind != tuning::InputKind::force) {
      bool const is_known = signals.unit == "mm" || signals.unit == "°";
      Setpoint const own{.file = path,
                         .unit = signals.unit,
                         .name = is_known ? std::string() : signals.mapping[0].name,
                         .kind = kind};
      bool const is_other =
          first && (own.unit != first->unit || own.name != first->name || own.kind != first->kind);
      if (is_other) {
        throw Failure({says::other_setpoint, {{"file", path}, {"first", first->file}}}, csv_malformed);
      }
      first = own;
      answer.unit = signals.unit;
    }
    measurements.push_back(std::move(signals.measurement));
  }
  answer.found = tuning::find_modes(measurements, axis.highest_hz);
  if (answer.found.modes.empty()) throw measured_refusal(paths, answer.found);
  return answer;
}

}  // namespace axisc
