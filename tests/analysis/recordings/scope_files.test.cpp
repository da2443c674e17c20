// Exports and the binary file of one genuine recording (pytcs, BSD-3-Clause): all forms have the same
// channels.
#include "analysis/recordings/recording_reader.hpp"
#include "support/catch.hpp"
#include "support/file_contents.hpp"

#include <cmath>
#include <filesystem>
#include <map>

namespace axisc::recordings::scope_files_test {
namespace {

using Samples = std::vector<std::pair<double, double>>;

std::filesystem::path const folder = std::filesystem::path(AXISC_SOURCE_DIR) / "../shared/data/scope";

Recording read(std::string const& name) {
  auto const text = test::file_contents(folder / name);
  auto found = read_recording(source_of(text));
  REQUIRE(std::holds_alternative<Recording>(found));
  return std::get<Recording>(std::move(found));
}

/// By name; as the scope shows them.
std::map<std::string, Samples> samples(Recording const& recording, bool are_raw) {
  std::map<std::string, Samples> found;
  for (auto const& channel : recording.channels) {
    auto const& clock = recording.clocks[channel.clock];
    CHECK_FALSE(clock.problem.has_value());
    CHECK_FALSE(channel.bad.has_value());
    auto& own = found[channel.name];
    for (std::size_t i = 0; i < clock.samples; ++i) {
      double const value = channel.values.at(i);
      double const shown = are_raw ? channel.scale.shown(value) : value;
      own.emplace_back(clock.times.at(i),
                       channel.data_type == "REAL32" ? double{static_cast<float>(shown)} : shown);
    }
  }
  return found;
}

TEST_CASE("all forms of a genuine recording are the same") {
  std::string const stem = "tc3_scope_3_4_3145_3";
  if (!std::filesystem::exists(folder / (stem + ".svdx"))) {
    WARN("genuine exports are not here");
    return;
  }
  auto const binary = samples(read(stem + ".svdx"), true);
  CHECK(binary.size() == 21);
  struct Row {
    std::string name;
    bool is_raw = false;
    std::size_t channels = 21;
  };
  for (auto const& row :
       {Row{"-default.csv", true}, Row{"-ContainEOF_true.csv"},
        Row{"-ExcludeDoubleTimestamp_true-SortChannels_false.csv"}, Row{"_noOS.csv", false, 19}}) {
    INFO(row.name);
    auto const text = samples(read(stem + row.name), row.is_raw);
    CHECK(text.size() == row.channels);
    for (auto const& [name, own] : text) {
      INFO(name);
      REQUIRE(binary.contains(name));
      auto const& other = binary.at(name);
      REQUIRE(own.size() == other.size());
      bool same = true;
      for (std::size_t i = 0; i < own.size(); ++i) {
        same = same && std::abs(own[i].first - other[i].first) <= 1e-9 && own[i].second == other[i].second;
      }
      CHECK(same);
    }
  }
}

}  // namespace
}  // namespace axisc::recordings::scope_files_test
