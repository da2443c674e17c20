#include "analysis/recordings/cycles.hpp"

#include "analysis/recordings/recording_reader.hpp"
#include "support/catch.hpp"

#include <string>

namespace axisc::recordings::cycles_test {
namespace {

using Values = std::vector<double>;

Recording read(std::string const& text) {
  auto found = read_recording(source_of(text));
  REQUIRE(std::holds_alternative<Recording>(found));
  return std::get<Recording>(std::move(found));
}

CycleSignals joined(std::string const& text, std::vector<std::size_t> const& channels = {0, 1},
                    double cycle_ms = 1) {
  auto found = by_cycles(read(text), channels, cycle_ms);
  if (auto const* const bad = std::get_if<BadCycles>(&found)) FAIL(static_cast<int>(bad->problem));
  return std::get<CycleSignals>(std::move(found));
}

BadCycles refused(std::string const& text, std::vector<std::size_t> const& channels = {0, 1},
                  double cycle_ms = 1) {
  auto const found = by_cycles(read(text), channels, cycle_ms);
  REQUIRE(std::holds_alternative<BadCycles>(found));
  return std::get<BadCycles>(found);
}

/// Pairs: columns of time and value each.
std::string pairs(Values const& first_times, Values const& second_times,
                  std::string const& header = "Name\ta\tName\tb\nPort\t551\tPort\t551\n") {
  std::string text = header;
  for (std::size_t i = 0; i < std::max(first_times.size(), second_times.size()); ++i) {
    auto const pair = [&](Values const& times, int hundreds) {
      if (i >= times.size()) return std::string("\t");
      return std::to_string(times[i]) + "\t" + std::to_string(hundreds + static_cast<int>(i));
    };
    text += pair(first_times, 100) + "\t" + pair(second_times, 200) + "\n";
  }
  return text;
}

TEST_CASE("channels with clocks of their own are joined by time, never by row") {
  // The second one begins two cycles later, and its last sample has no partner.
  auto const found = joined(pairs({0, 1, 2, 3, 4, 5}, {2, 3, 4, 5, 6}));
  CHECK(found.signals[0].values() == Values{102, 103, 104, 105});
  CHECK(found.signals[1].values() == Values{200, 201, 202, 203});
  CHECK(found.gaps.empty());
}

TEST_CASE("lost cycles are interpolated, in both") {
  auto const found = joined(pairs({0, 1, 2, 3, 5, 6}, {0, 2, 3, 4, 5, 6}));
  CHECK(found.signals[0].values() == Values{100, 101, 102, 103, 103.5, 104, 105});
  CHECK(found.signals[1].values() == Values{200, 200.5, 201, 202, 203, 204, 205});
  CHECK(found.gaps == std::vector<std::size_t>{1, 4});
  auto const missing = joined("time;a;b\n0;1;5\n1;2;\n2;;7\n3;4;8\n");
  CHECK(missing.signals[0].values() == Values{1, 2, 3, 4});
  CHECK(missing.signals[1].values() == Values{5, 6, 7, 8});
  CHECK(missing.gaps == std::vector<std::size_t>{1, 2});
}

TEST_CASE("of k samples a cycle every k-th is taken, at the begin of the other channel") {
  Values quick, slow{2.5, 3.5, 4.5, 5.5};
  for (int i = 0; i < 40; ++i) quick.push_back(0.25 * i);
  auto const found = joined(pairs(quick, slow));
  CHECK(found.signals[0].values() == Values{110, 114, 118, 122});
  CHECK(found.signals[1].values() == Values{200, 201, 202, 203});
}

TEST_CASE("a recording that leaves cycles out, or has another sample time, is refused") {
  auto bad = refused("time_ms;a;b\n0;1;1\n4;1;1\n8;1;1\n12;1;1\n");
  CHECK((bad.problem == CycleProblem::decimated && bad.step == 4));
  bad = refused("time_ms;a;b\n0;1;1\n0.7;1;1\n1.4;1;1\n2.1;1;1\n");
  CHECK((bad.problem == CycleProblem::other_step && bad.step == Approx(0.7)));
  std::string text = "time;a;b\n";
  for (int i = 0; i < 40; ++i) text += std::to_string(i < 30 ? i : i + 0.5) + ";1;1\n";
  bad = refused(text);
  CHECK((bad.problem == CycleProblem::other_distance && bad.sample == 30U));
  std::string const header = "Name\ta\tName\tb\nSampleTime[ms]\t2\tSampleTime[ms]\t1\nPort\t1\tPort\t1\n";
  bad = refused(pairs({0, 1, 2, 3}, {0, 1, 2, 3}, header));
  CHECK((bad.problem == CycleProblem::header_disagrees && bad.channel == 0));
  CHECK(refused(pairs({0, 1, 2, 3}, {100, 101, 102, 103, 104})).problem == CycleProblem::no_samples);
  CHECK(refused("a;time;b\n1;0;1\n1;1;1\n1;2;1\n").problem == CycleProblem::uncommon_clocks);
  CHECK(refused("time;a;b\n0;1;1\n1;x;1\n2;2;2\n").problem == CycleProblem::bad_value);
  CHECK(refused("time;a;b\n0;1;1\n2;1;1\n1;2;2\n").problem == CycleProblem::bad_clock);
  bad = refused("time;a;b\n0;1;1\n1;1;1e305\n2;2;2\n");
  CHECK((bad.problem == CycleProblem::too_large && bad.channel == 1 && bad.sample == 1U));
}

TEST_CASE("most cycles have to be there") {
  std::string text = "time;a;b\n";
  for (int i = 0; i < 3000; ++i) text += std::to_string(i < 1600 ? i : 2000 + 900 * (i - 1600)) + ";1;1\n";
  CHECK(refused(text).problem == CycleProblem::many_lost);
}

TEST_CASE("times that are rounded when they are written keep their cycles") {
  // 0.25 ms in tenths: steps of 0.2 and 0.3.
  std::string text = "time_ms;a;b\n";
  char const* const tenths[] = {"0.0", "0.3", "0.5", "0.8"};
  for (int i = 0; i < 400; ++i) {
    auto const whole = std::to_string(i / 4);
    text += whole + std::string(tenths[i % 4]).substr(1) + ";" + std::to_string(i) + ";0\n";
  }
  auto const found = joined(text, {0, 1}, 0.25);
  CHECK(found.signals[0].size() == 400);
  CHECK(found.gaps.empty());
  CHECK(sample_time(read(text).clocks.front()) == Approx(0.25).epsilon(0.002));
}

TEST_CASE("rows without times are cycles") {
  auto const found = joined("a;b\n1;4\n2;5\n3;6\n");
  CHECK(found.signals[1].values() == Values{4, 5, 6});
}

TEST_CASE("clocks that run apart are refused") {
  Values first, second;
  for (int i = 0; i < 500; ++i) {
    first.push_back(i);
    if (i < 490) second.push_back(1.01 * i);
  }
  CHECK(refused(pairs(first, second)).problem == CycleProblem::drift);
}

}  // namespace
}  // namespace axisc::recordings::cycles_test
