#include "axisc/files/recording_file.hpp"

#include "analysis/recordings/objects.hpp"
#include "analysis/recordings/recording_reader.hpp"
#include "axisc/asked/quantities.hpp"
#include "axisc/environment/codes.hpp"
#include "axisc/environment/failure.hpp"
#include "axisc/files/byte_source.hpp"
#include "axisc/files/recording_problems.hpp"

#include <algorithm>
#include <numeric>
#include <utility>

namespace axisc::says {

constexpr Sentence no_column{"{file} has no column \"{column}\"; it has {known}",
                             "{file} hat keine Spalte \"{column}\"; vorhanden sind {known}"};
constexpr Sentence same_names{
    "{file} has several columns \"{column}\" with different values; name one by its number: {known}",
    "{file} hat mehrere Spalten \"{column}\" mit verschiedenen Werten; eine mit ihrer Nummer nennen: "
    "{known}"};

}  // namespace axisc::says

namespace axisc {

bool are_equal(recordings::Recording const& recording, std::size_t a, std::size_t b) {
  auto const equal = [](recordings::Signal const& one, recordings::Signal const& other) {
    bool same = one.size() == other.size();
    std::vector<double> part;
    for_each_part(one, [&](std::size_t first, std::span<double const> values) {
      if (!same) return;
      part.resize(values.size());
      other.read(first, part);
      same = std::equal(values.begin(), values.end(), part.begin(),
                        [](double x, double y) { return x == y || (x != x && y != y); });
    });
    return same;
  };
  auto const& one = recording.channels[a];
  auto const& other = recording.channels[b];
  auto const& clocks = recording.clocks;
  return equal(one.values, other.values) &&
         (one.clock == other.clock || equal(clocks[one.clock].times, clocks[other.clock].times));
}

std::string RecordingFile::known(std::span<std::size_t const> channels) const {
  std::string text;
  for (auto const channel : channels) {
    text += (text.empty() ? "\"" : ", \"") + shown_column(recording.channels[channel].name) + "\"";
  }
  return text;
}

std::string RecordingFile::known() const {
  std::vector<std::size_t> all(recording.channels.size());
  std::iota(all.begin(), all.end(), std::size_t{0});
  return known(all);
}

std::size_t RecordingFile::channel_named(std::string const& wanted) const {
  auto const& channels = recording.channels;
  std::vector<std::size_t> found;
  for (std::size_t i = 0; i < channels.size(); ++i) {
    if (channels[i].name == wanted) found.push_back(i);
  }
  for (std::size_t i = 0; found.empty() && i < channels.size(); ++i) {
    if (channels[i].symbol == wanted) found.push_back(i);
  }
  for (std::size_t i = 0; found.empty() && i < channels.size(); ++i) {
    if (recordings::plain_name(channels[i].name) == wanted) found.push_back(i);
  }
  auto const number = parse_count(wanted);
  for (std::size_t i = 0; found.empty() && number && i < channels.size(); ++i) {
    if (channels[i].column == *number) found.push_back(i);
  }
  if (found.empty()) {
    throw Failure({says::no_column, {{"file", name}, {"column", wanted}, {"known", known()}}}, csv_malformed);
  }
  bool const are_one = std::all_of(found.begin(), found.end(),
                                   [&](std::size_t i) { return are_equal(recording, found.front(), i); });
  if (are_one) return found.front();
  std::string numbers;
  for (auto const i : found) numbers += (numbers.empty() ? "" : ", ") + std::to_string(channels[i].column);
  throw Failure({says::same_names, {{"file", name}, {"column", wanted}, {"known", numbers}}}, csv_malformed);
}

std::string RecordingFile::place(std::size_t channel, std::optional<std::size_t> sample) const {
  auto const& clock = recording.clocks[recording.channels[channel].clock];
  if (!sample || *sample >= clock.lines.size()) return name;
  return place_at(name, static_cast<std::uint64_t>(clock.lines.at(*sample)));
}

RecordingFile read_recording_file(std::string name, recordings::ByteSource source) {
  auto read = recordings::read_recording(std::move(source));
  if (auto const* const bad = std::get_if<recordings::BadRecording>(&read)) fail_reading(name, *bad);
  return {.name = std::move(name), .recording = std::get<recordings::Recording>(std::move(read))};
}

RecordingFile open_recording(std::string const& path) {
  return read_recording_file(path, open_source(path));
}

recordings::CycleSignals cycles_of(RecordingFile const& file, std::span<std::size_t const> channels,
                                   double cycle_ms) {
  auto joined = recordings::by_cycles(file.recording, channels, cycle_ms);
  if (auto const* const bad = std::get_if<recordings::BadCycles>(&joined)) fail_cycles(file, *bad, cycle_ms);
  return std::get<recordings::CycleSignals>(std::move(joined));
}

}  // namespace axisc
