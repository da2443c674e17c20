// Recordings that tests/analysis/comparison/recordings.py stored, computed by another program.
#include "analysis/comparison/turns.hpp"
#include "analysis/comparison/verdict.hpp"
#include "axisc/environment/failure.hpp"
#include "axisc/files/recorded_columns.hpp"
#include "support/catch.hpp"

#include <cmath>

namespace axisc::comparison::recordings_test {
namespace {

constexpr design::CycleTime cycle_time{1'000'000};

Recording stored(std::string const& name) {
  auto const path = std::string(AXISC_SOURCE_DIR "/tests/analysis/comparison/data/") + name + ".csv";
  auto recorded = read_recorded_columns(open_recording(path), {}, {}, cycle_time);
  CHECK(recorded.input_name == "setpoint");
  CHECK(recorded.output_name == "filtered");
  CHECK(recorded.recording.input.size() == 900);
  return std::move(recorded.recording);
}

Configured lowpass(std::uint32_t order, double frequency) {
  return {.cycle_time = cycle_time,
          .filters = {{.type = design::FilterType::lowpass,
                       .prototype = design::Prototype::butterworth,
                       .order = order,
                       .frequency = {frequency}}},
          .kernel = {}};
}

Configured other(design::FilterType type, design::Prototype prototype, std::uint32_t order,
                 double quality = 1) {
  return {.cycle_time = cycle_time,
          .filters =
              {{.type = type, .prototype = prototype, .order = order, .frequency = {30}, .quality = quality}},
          .kernel = {}};
}

Configured novib(double frequency) {
  return {.cycle_time = cycle_time,
          .filters = {},
          .kernel = design::KernelSpecification{.type = design::KernelType::novib, .frequency = {frequency}}};
}

Configured kernel(design::KernelType type, std::uint32_t order, double share = 100) {
  return {.cycle_time = cycle_time,
          .filters = {},
          .kernel = design::KernelSpecification{
              .type = type, .order = order, .frequency = {30}, .share_percent = share}};
}

RecordedColumns read(std::string const& text, WantedColumns const& wanted = {}) {
  auto const file = read_recording_file("scope.csv", recordings::source_of(text));
  return read_recorded_columns(file, {}, wanted, cycle_time);
}

std::vector<double> inputs(std::string const& text, WantedColumns const& wanted = {}) {
  return read(text, wanted).recording.input.values();
}

std::vector<double> outputs(std::string const& text) {
  return read(text).recording.output.values();
}

using design::FilterType;
using design::KernelType;
using design::Prototype;

TEST_CASE("the control's reading of the parameters is named") {
  struct Row {
    std::string name;
    Configured configured;
  };
  for (auto const& row :
       {Row{"no-prewarping", lowpass(3, 60)}, Row{"backward-euler", lowpass(2, 20)},
        Row{"forward-euler", lowpass(2, 20)}, Row{"matched-poles", lowpass(4, 50)},
        Row{"taps-n-plus-1", kernel(KernelType::moving_average, 41)},
        Row{"order-is-half-width", kernel(KernelType::moving_average, 24)},
        Row{"gaussian-width-3", kernel(KernelType::gaussian, 40)},
        Row{"sinc-blackman", kernel(KernelType::windowed_sinc, 40)},
        Row{"share-undelayed", kernel(KernelType::moving_average, 40, 70)},
        Row{"quality-of-poles", other(FilterType::bandstop, Prototype::critical_damping, 2, 1.5)},
        Row{"analogue-quality", other(FilterType::bandstop, Prototype::butterworth, 2)},
        Row{"matched", other(FilterType::bandstop, Prototype::butterworth, 1)},
        Row{"bessel-delay", other(FilterType::lowpass, Prototype::bessel, 3)},
        Row{"allpass-phase", other(FilterType::allpass, Prototype::bessel, 3)},
        Row{"novib-one-box", novib(20)}}) {
    INFO(row.name);
    auto const comparison = compare(stored(row.name), readings(row.configured));
    CHECK(comparison.verdict == Verdict::different);
    REQUIRE(comparison.fitting.size() == 1);
    REQUIRE(comparison.fitting.front().reading.departures.size() == 1);
    CHECK(comparison.fitting.front().reading.departures.front().id == row.name);
    CHECK(comparison.fitting.front().residual.delay_cycles == 1);
  }
}

TEST_CASE("a control that computes what axisc does is the same but for the offset of the columns") {
  auto const comparison = compare(stored("listed"), readings(lowpass(3, 40)));
  CHECK(comparison.verdict == Verdict::delayed);
  CHECK(comparison.listed.delay_cycles == 1);
  CHECK(comparison.input_resolution == 1);
}

TEST_CASE("a filter that is nearly a delay does not hide that filters are off") {
  // The forward Euler method puts its three poles at 0.055: an answer that rises within two cycles, three
  // cycles late.
  auto configured = lowpass(3, 76.7);
  configured.filters.front().prototype = design::Prototype::critical_damping;
  auto const all = readings(configured);
  auto const has = [&](std::string_view id) {
    return std::any_of(all.begin(), all.end(), [id](Reading const& reading) {
      return reading.departures.size() == 1 && reading.departures.front().id == id;
    });
  };
  CHECK(has("forward-euler"));
  CHECK(has("filters-off"));
}

TEST_CASE("an axis at rest tells nothing") {
  Recording const rest{.input = Signal(std::vector<double>(500, 7.0)),
                       .output = Signal(std::vector<double>(500, 7.0)),
                       .gaps = {}};
  CHECK(compare(rest, readings(lowpass(3, 40))).verdict == Verdict::cannot_tell);
}

TEST_CASE("jumps by full turns are taken out") {
  std::vector<double> in, out, wrapped_in, wrapped_out;
  constexpr double turn = 3'600'000;
  auto const wrapped = [](double value) { return value - turn * std::floor(value / turn); };
  for (int n = 0; n < 900; ++n) {
    in.push_back(n < 50 ? 0.0 : n < 500 ? 30'000.0 * (n - 50) : 13'500'000.0 - 20'000.0 * (n - 500));
    double sum = 0;
    for (int k = 0; k < 9; ++k) sum += in[static_cast<std::size_t>(std::max(0, n - k))];
    out.push_back(std::round(sum / 9));
    wrapped_in.push_back(wrapped(in.back()));
    wrapped_out.push_back(wrapped(out.back()));
  }
  Recording recording{.input = Signal(wrapped_in), .output = Signal(wrapped_out), .gaps = {170, 171}};
  CHECK(unwind(recording, turn) == 10);
  auto expected = in;
  for (std::size_t const gap : recording.gaps) {
    expected[gap] = in[169] + (in[172] - in[169]) * static_cast<double>(gap - 169) / 3;
  }
  CHECK(recording.input.values() == expected);
  CHECK(compare(recording, readings(kernel(KernelType::moving_average, 8))).verdict == Verdict::same);
  CHECK(unwind(recording, turn) == 0);
}

TEST_CASE("a reading that is not known is not explained by another one") {
  auto const comparison = compare(stored("sinc-blackman"), readings(kernel(KernelType::moving_average, 40)));
  CHECK(comparison.verdict == Verdict::different);
  CHECK(comparison.fitting.empty());
}

TEST_CASE("columns are read with decimal commas and decimal points") {
  CHECK(inputs("a;b\n1,5;2\n2;3,25\n") == std::vector<double>{1.5, 2});
  CHECK(outputs("a,b\n1.5,2\n2,3.25\n") == std::vector<double>{2, 3.25});
  CHECK(outputs("1\t2\r\n3\t4\r\nEOF\r\n") == std::vector<double>{2, 4});
  CHECK_THROWS_AS(read("a;b\n1,5;2\n2.5;3\n"), Failure);
  CHECK_THROWS_AS(read("a;b\n1;2\n2\n"), Failure);
  CHECK_THROWS_AS(read("a;b\n"), Failure);
  CHECK_THROWS_AS(read(""), Failure);
}

TEST_CASE("columns are chosen by name or number") {
  CHECK(inputs("a;b;c\n1;2;3\n4;5;6\n", {"c", "1"}) == std::vector<double>{3, 6});
  CHECK_THROWS_AS(read("a;b;c\n1;2;3\n", {"a", "d"}), Failure);
  CHECK_THROWS_AS(read("a;b;c\n1;2;3\n"), Failure);
}

TEST_CASE("the time shows lost and repeated rows") {
  auto const recorded = read("time;a;b\n0;0;0\n1;1;2\n1;1;2\n3;3;6\n");
  CHECK(recorded.recording.input.values() == std::vector<double>{0, 1, 2, 3});
  CHECK(recorded.recording.output.values() == std::vector<double>{0, 2, 4, 6});
  CHECK(recorded.recording.gaps == std::vector<std::size_t>{2});
  CHECK(recorded.repeated == 1);
  CHECK_THROWS_AS(read("time;a;b\n0;0;0\n0.7;1;2\n"), Failure);
}

}  // namespace
}  // namespace axisc::comparison::recordings_test
