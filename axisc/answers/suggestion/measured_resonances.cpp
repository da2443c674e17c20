#include "axisc/answers/suggestion/measured_resonances.hpp"

#include "axisc/environment/codes.hpp"
#include "axisc/environment/failure.hpp"
#include "axisc/files/byte_source.hpp"
#include "diagnostics/format_number.hpp"

#include <array>
#include <vector>

namespace axisc::says {

constexpr Sentence no_rows{"{file} has no table of numbers", "{file} hat keine Tabelle von Zahlen"};
constexpr Sentence not_a_number{"{file}:{line}: not a row of numbers",
                                "{file}:{line}: keine Zeile von Zahlen"};
constexpr Sentence field_count{"{file}:{line}: another number of columns than before",
                               "{file}:{line}: eine andere Zahl von Spalten als zuvor"};
constexpr Sentence mixed_numbers{"{file}: column {column} has decimal points and decimal commas",
                                 "{file}: Spalte {column} hat Dezimalpunkte und Dezimalkommas"};
constexpr Sentence no_columns{
    "{file} is not a measurement: it needs columns time and two signals, or frequency_hz and magnitude_db, "
    "perhaps with phase_deg and coherence",
    "{file} ist keine Messung: nötig sind die Spalten time und zwei Signale oder frequency_hz und "
    "magnitude_db, vielleicht mit phase_deg und coherence"};
constexpr Sentence choose_columns{
    "{file}: name the input with --in and the output with --out; there are {column}",
    "{file}: mit --in den Eingang und mit --out den Ausgang nennen; es gibt {column}"};
constexpr Sentence unknown_column{"{file} has no column {column}", "{file} hat keine Spalte {column}"};
constexpr Sentence uneven_time{"{file}:{line}: samples are missing; record again without gaps",
                               "{file}:{line}: Abtastwerte fehlen; noch einmal ohne Lücken aufzeichnen"};
constexpr Sentence uneven_frequency{"{file}:{line}: frequencies do not rise",
                                    "{file}:{line}: die Frequenzen steigen nicht"};
constexpr Sentence long_measured_row{"{file}:{line}: the line is longer than 1 MiB",
                                     "{file}:{line}: die Zeile ist länger als 1 MiB"};
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
constexpr std::array<SentenceRef, 10> problems = {
    says::no_rows,          says::not_a_number,     says::field_count,    says::mixed_numbers,
    says::no_columns,       says::choose_columns,   says::unknown_column, says::uneven_time,
    says::uneven_frequency, says::long_measured_row};
constexpr std::array<SentenceRef, 5> doubts = {says::too_short, says::no_peak, says::no_excitation,
                                               says::incoherent, says::moving};

}  // namespace

MeasuredResonances measured_resonances(std::string const& path, tuning::SignalColumns const& columns,
                                       double highest) {
  auto const read = tuning::read_measurement(limited_source(path), columns);
  if (auto const* const bad = std::get_if<tuning::BadMeasurement>(&read)) {
    throw Failure({problems[static_cast<std::size_t>(bad->problem)],
                   {{"file", path}, {"line", std::to_string(bad->line)}, {"column", bad->column}}},
                  csv_malformed);
  }
  auto const& measurement = std::get<tuning::Measurement>(read);
  auto found = tuning::identify(measurement, highest);
  MeasuredResonances answer{
      .kind = measurement.kind, .peaks = std::move(found.peaks), .refusal = std::nullopt};
  if (!found.doubt) return answer;
  Wording const place =
      found.doubtful_frequency > 0 ? " (" + format_rounded(found.doubtful_frequency, 3) + " Hz)" : "";
  answer.refusal = Message{
      .sentence = doubts[static_cast<std::size_t>(*found.doubt)],
      .arguments = {{"file", path}, {"samples", std::to_string(tuning::fewest_samples)}, {"place", place}}};
  return answer;
}

}  // namespace axisc
