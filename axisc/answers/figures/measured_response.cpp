#include "axisc/answers/figures/measured_response.hpp"

#include "analysis/recordings/decimal_number.hpp"
#include "axisc/environment/failure.hpp"
#include "axisc/files/recording_file.hpp"
#include "axisc/files/recording_problems.hpp"

#include <algorithm>
#include <cmath>
#include <string_view>

namespace axisc::says {

constexpr Sentence measured_columns{
    "{file} has no column {column}; a measured response has frequency_hz, magnitude_db and possibly "
    "phase_deg",
    "{file} hat keine Spalte {column}; ein gemessener Frequenzgang hat frequency_hz, magnitude_db und "
    "vielleicht phase_deg"};
constexpr Sentence measured_nothing{"{file} has no frequency above 0 with a finite magnitude",
                                    "{file} hat keine Frequenz über 0 mit einem endlichen Betrag"};

}  // namespace axisc::says

namespace axisc {

namespace {

using recordings::Channel;

/// Null where there is none.
Channel const* column(RecordingFile const& file, std::string_view name) {
  auto const& channels = file.recording.channels;
  auto const found = std::find_if(channels.begin(), channels.end(),
                                  [name](Channel const& channel) { return channel.name == name; });
  return found == channels.end() ? nullptr : &*found;
}

Channel const& required_column(RecordingFile const& file, std::string_view name) {
  if (auto const* const found = column(file, name)) return *found;
  throw Failure({says::measured_columns, {{"file", file.name}, {"column", std::string(name)}}});
}

/// Infinite values are left out where they are used; anything else that is not a number is refused.
void refuse_text(RecordingFile const& file, Channel const* channel) {
  if (channel == nullptr || !channel->bad || recordings::parse_number(channel->bad->text)) return;
  fail_value(file, static_cast<std::size_t>(channel - file.recording.channels.data()));
}

}  // namespace

std::vector<MeasuredPoint> read_measured_response(std::string const& path) {
  auto const file = open_recording(path);
  auto const& frequency = required_column(file, "frequency_hz");
  auto const& magnitude = required_column(file, "magnitude_db");
  auto const* const phase = column(file, "phase_deg");
  for (auto const* const channel : {&frequency, &magnitude, phase}) refuse_text(file, channel);
  std::vector<MeasuredPoint> points;
  auto const frequencies = frequency.values.values();
  auto const magnitudes = magnitude.values.values();
  auto const phases = phase != nullptr ? phase->values.values() : std::vector<double>();
  for (std::size_t row = 0; row < frequencies.size() && row < magnitudes.size(); ++row) {
    if (!(frequencies[row] > 0) || !std::isfinite(frequencies[row]) || !std::isfinite(magnitudes[row])) {
      continue;
    }
    bool const has_phase = row < phases.size() && std::isfinite(phases[row]);
    points.push_back({.frequency = frequencies[row],
                      .magnitude_db = magnitudes[row],
                      .phase_deg = has_phase ? std::optional(phases[row]) : std::nullopt});
  }
  if (points.empty()) throw Failure({says::measured_nothing, {{"file", path}}});
  std::stable_sort(points.begin(), points.end(),
                   [](MeasuredPoint const& a, MeasuredPoint const& b) { return a.frequency < b.frequency; });
  return points;
}

}  // namespace axisc
