#include "analysis/recordings/svdx_recording.hpp"

#include "analysis/recordings/recording_reader.hpp"
#include "support/catch.hpp"
#include "svdx_writer.hpp"

#include <cmath>
#include <random>

namespace axisc::recordings::svdx_recording_test {
namespace {

using test::svdx_file;
using test::SvdxChannel;
using test::SvdxOptions;

Recording read(std::string const& bytes) {
  auto found = read_svdx_recording(bytes);
  if (auto const* const bad = std::get_if<BadRecording>(&found)) {
    FAIL(static_cast<int>(bad->problem) << " byte " << bad->byte << " " << bad->text);
  }
  return std::get<Recording>(std::move(found));
}

RecordingProblem refused(std::string const& bytes) {
  auto const found = read_svdx_recording(bytes);
  REQUIRE(std::holds_alternative<BadRecording>(found));
  return std::get<BadRecording>(found).problem;
}

std::vector<double> wave(std::size_t count, double size) {
  std::vector<double> values(count);
  for (std::size_t i = 0; i < count; ++i) values[i] = std::round(size * std::sin(static_cast<double>(i) / 9));
  return values;
}

bool are_same(Recording const& a, Recording const& b) {
  if (a.channels.size() != b.channels.size()) return false;
  for (std::size_t i = 0; i < a.channels.size(); ++i) {
    auto const& one = a.channels[i];
    auto const& other = b.channels[i];
    bool const same = one.values.values() == other.values.values() &&
                      a.clocks[one.clock].times.values() == b.clocks[other.clock].times.values();
    if (!same) return false;
  }
  return true;
}

TEST_CASE("every type is read with its scale, its unit and its object") {
  std::vector<SvdxChannel> channels;
  for (std::string const type : {"BIT", "INT8", "INT16", "INT32", "INT64", "UINT8", "UINT16", "UINT32",
                                 "UINT64", "REAL32", "REAL64"}) {
    auto values = wave(700, type == "BIT" ? 0.0 : 100.0);
    bool const has_sign = type[0] == 'I' || type[0] == 'R';
    for (double& value : values) value = has_sign ? value : std::abs(value);
    if (type[0] == 'R') values[3] = 0.1F;
    channels.push_back({.name = type, .type = type, .values = values});
  }
  channels[3].factor = -1;
  channels[3].add = 1;
  channels[3].unit = "mm (Length)";
  channels[4].unit_factor = 0.5;
  channels[4].unit_add = 2;
  for (std::string const mark : {"", "\xEF\xBB\xBF"}) {
    auto const recording = read(svdx_file(channels, {.mark = mark}));
    REQUIRE(recording.channels.size() == channels.size());
    for (std::size_t i = 0; i < channels.size(); ++i) {
      INFO(channels[i].name);
      auto const& channel = recording.channels[i];
      CHECK(channel.name == channels[i].name);
      CHECK(channel.data_type == channels[i].type);
      CHECK(channel.values.values() == channels[i].values);
      CHECK(recording.clocks[channel.clock].times.at(699) == 699.0);
      CHECK(recording.clocks[channel.clock].sample_time == 1.0);
      CHECK((channel.port == 551U && channel.index_group == 0x121301U && channel.index_offset == 0x10061U));
      CHECK(channel.is_raw);
    }
    CHECK(recording.channels[3].unit == "mm (Length)");
    CHECK(recording.channels[3].scale.shown(5) == -4);
    CHECK(recording.channels[4].scale.shown(5) == 4.5);
    CHECK(recording.channels[4].scale.raw(4.5) == 5);
  }
}

TEST_CASE("the window is from the last sample at or before the earliest begin to the end") {
  SvdxChannel quick{.name = "quick", .values = wave(40, 9), .first = 30'000, .last = 200'000};
  SvdxChannel slow{.name = "slow", .values = wave(20, 9), .times = {}, .first = 30'000, .last = 170'000};
  for (std::uint64_t i = 0; i < 20; ++i) slow.times.push_back(10'000 + 50'000 * i);
  auto const recording = read(svdx_file({quick, slow}));
  auto const quick_times = recording.clocks[recording.channels[0].clock].times.values();
  CHECK((quick_times.front() == 0 && quick_times.back() == 17 && quick_times.size() == 18));
  CHECK(recording.channels[0].values.front() == quick.values[3]);
  auto const slow_times = recording.clocks[recording.channels[1].clock].times.values();
  CHECK(slow_times == std::vector<double>{-2, 3, 8, 13});
  CHECK(recording.channels[1].values.front() == slow.values[0]);
}

TEST_CASE("a channel without a block was not recorded") {
  auto const recording = read(svdx_file({{.name = "a", .values = wave(30, 5)}, {.name = "b"}}));
  CHECK(recording.channels.size() == 1);
  CHECK(recording.not_recorded == std::vector<std::string>{"b"});
}

TEST_CASE("what breaks a rule is refused") {
  using enum RecordingProblem;
  std::vector<SvdxChannel> const channels{{.values = wave(100, 50)}};
  auto const file = svdx_file(channels);
  CHECK(refused(file.substr(0, 15)) == too_short);
  CHECK(refused(file + "x") == too_short);
  CHECK(refused(file.substr(0, file.size() - 1)) == too_short);
  CHECK(refused(svdx_file(channels, {.version = "01.00.00.41"})) == unknown_version);
  CHECK(refused(svdx_file(channels, {.compression = "Compressed"})) == compressed);
  CHECK(refused(svdx_file(channels, {.spoils_extremes = true})) == bad_extremes);
  CHECK(refused(svdx_file({{.type = "STRING", .values = wave(100, 50)}})) == unknown_type);
  CHECK(refused(svdx_file({{.name = "a</Name>", .values = wave(100, 50)}})) == bad_xml);
  auto broken = file;
  broken.replace(broken.find("FileHandle>1<"), 13, "FileHandle>2<");
  CHECK(refused(broken) == bad_project);
  broken = file;
  broken.replace(broken.find("AcquisitionGUID>guid"), 20, "AcquisitionGUID>gu1d");
  CHECK(refused(broken) == bad_project);
  broken = file;
  broken[20] = static_cast<char>(broken[20] + 1);
  CHECK(refused(broken) == bad_container);
  SvdxChannel backward{.values = wave(20, 5)};
  for (std::uint64_t i = 0; i < 20; ++i) backward.times.push_back(10'000 * (i == 7 ? 6 : i));
  CHECK(refused(svdx_file({backward})) == bad_time);
}

TEST_CASE("300 damaged files are refused or read as they were") {
  // Values that a changed bit leaves within the extremes cannot be told from others: every sample here is
  // one.
  auto const values = [](double low, double high) {
    std::vector<double> both;
    for (int i = 0; i < 640; ++i) both.push_back(i % 2 == 0 ? low : high);
    return both;
  };
  auto const file = svdx_file({{.name = "a", .type = "BIT", .values = values(0, 1)},
                               {.name = "b", .type = "INT16", .values = values(-5, 1000)},
                               {.name = "c", .type = "REAL64", .values = values(-0.5, 1e9)}});
  auto const whole = read(file);
  auto const xml = file.find("<?xml");
  std::mt19937_64 random(38);
  int told = 0;
  for (int i = 0; i < 300; ++i) {
    auto damaged = file;
    if (i % 3 == 0) {
      damaged.resize(random() % file.size());
    } else if (i % 3 == 1) {
      auto const at = random() % xml;
      damaged[at] = static_cast<char>(damaged[at] ^ static_cast<char>(1U << (random() % 8)));
    } else {
      // Numbers of the container and of the blocks, written anew.
      auto const at = random() % (xml - 8);
      std::uint64_t const value = random() % 2 == 0 ? random() : random() % 1000;
      for (std::size_t k = 0; k < 8; ++k) damaged[at + k] = static_cast<char>(value >> (8 * k) & 0xFFU);
    }
    auto const found = read_svdx_recording(damaged);
    auto const* const recording = std::get_if<Recording>(&found);
    if (recording == nullptr) ++told;
    INFO(i);
    if (recording != nullptr && !are_same(*recording, whole)) {
      // A value within the extremes, or a time that still rises: nothing in the file says what it was.
      std::size_t differing = 0;
      for (std::size_t n = 0; n < whole.channels.size(); ++n) {
        auto const a = whole.channels[n].values.values();
        auto const b = recording->channels[n].values.values();
        auto const [low, high] = std::minmax_element(a.begin(), a.end());
        for (std::size_t k = 0; k < std::min(a.size(), b.size()); ++k) {
          if (a[k] == b[k]) continue;
          ++differing;
          CHECK((b[k] >= *low && b[k] <= *high));
        }
      }
      CHECK(differing <= 3);
    }
  }
  CHECK(told >= 200);
}

TEST_CASE("the bytes decide about the form") {
  auto const file = svdx_file({{.values = wave(100, 50)}});
  auto const binary = read_recording(source_of(file));
  REQUIRE(std::holds_alternative<Recording>(binary));
  CHECK(std::get<Recording>(binary).form == Form::scope_binary);
  auto const text = read_recording(source_of("1\t2\n3\t4\n"));
  REQUIRE(std::holds_alternative<Recording>(text));
  CHECK(std::get<Recording>(text).form == Form::columns);
}

}  // namespace
}  // namespace axisc::recordings::svdx_recording_test
