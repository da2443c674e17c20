#include "analysis/tuning/identification/measurement.hpp"

#include "analysis/recordings/recording_reader.hpp"
#include "support/catch.hpp"

#include <cmath>
#include <numbers>
#include <random>

#include <fmt/format.h>

namespace axisc::tuning::measurement_test {
namespace {

recordings::Recording recording(std::string const& bytes) {
  auto read = recordings::read_recording(recordings::source_of(bytes));
  REQUIRE(std::holds_alternative<recordings::Recording>(read));
  return std::get<recordings::Recording>(std::move(read));
}

Measurement read(std::string const& bytes) {
  auto const columns = recording(bytes);
  REQUIRE(is_response(columns));
  auto const found = response_measurement(columns);
  if (auto const* const bad = std::get_if<BadMeasurement>(&found)) {
    FAIL(static_cast<int>(bad->problem) << " line " << bad->line);
  }
  return std::get<Measurement>(found);
}

BadMeasurement refused(std::string const& bytes) {
  auto const found = response_measurement(recording(bytes));
  REQUIRE(std::holds_alternative<BadMeasurement>(found));
  return std::get<BadMeasurement>(found);
}

}  // namespace

TEST_CASE("responses and spectra") {
  auto const found = read("frequency_hz;magnitude_db;phase_deg;coherence\n1;20;90;1\n2;0;-90;0,5\n");
  CHECK(found.kind == MeasurementKind::response);
  CHECK(found.response.response[0].imag() == Approx(10));
  CHECK(found.response.response[1].imag() == Approx(-1));
  CHECK(found.response.coherence == std::vector<double>{1, 0.5});
  auto const spectrum = read("freq,psd_x,psd_y\n0,9,9\n1,4,9\n2,16,9\n");
  CHECK(spectrum.kind == MeasurementKind::spectrum);
  CHECK(spectrum.response.frequency == std::vector<double>{1, 2});
  CHECK(spectrum.response.response[1].real() == Approx(4));
  CHECK_FALSE(spectrum.response.has_phase);
}

TEST_CASE("what is no response is refused with its place") {
  using enum MeasurementProblem;
  CHECK_FALSE(is_response(recording("x,y\n0,1\n1,2\n")));
  CHECK_FALSE(is_response(recording("time,freq\n0,1\n1,2\n")));
  CHECK(refused("freq,y\n0,1\n1,2\n").problem == no_columns);
  CHECK(refused("freq,magnitude\n1,1\n").problem == too_short);
  auto bad = refused("freq,magnitude\n1,1\n2,x\n");
  CHECK((bad.problem == not_a_number && bad.line == 3));
  bad = refused("freq,magnitude,phase_deg\n1,1,0\n2,2,\n");
  CHECK((bad.problem == not_a_number && bad.line == 3));
  bad = refused("freq,magnitude\n1,1\n2,2\n2,3\n");
  CHECK((bad.problem == uneven_frequency && bad.line == 4));
}

TEST_CASE("a resonance of 48 Hz is found in a response and in signals") {
  std::string response = "frequency_hz,magnitude_db,phase_deg\n";
  for (double f = 5; f < 150; f += 0.25) {
    std::complex<double> const s(0, f / 48);
    auto const h = 1.0 / (1.0 + 0.06 * s + s * s);
    response +=
        fmt::format("{},{},{}\n", f, 20 * std::log10(std::abs(h)), std::arg(h) * 180 / std::numbers::pi);
  }
  auto found = identify(read(response), 400);
  REQUIRE(found.peaks.size() == 1);
  CHECK(found.peaks[0].frequency == Approx(48).epsilon(1e-3));
  CHECK(found.peaks[0].damping == Approx(0.03).epsilon(0.01));

  Measurement signals{.kind = MeasurementKind::signals, .sampling_rate = 1000};
  std::mt19937 random(7);
  std::normal_distribution<double> normal(0, 1);
  double x = 0, v = 0;
  for (int n = 0; n < 16384; ++n) {
    double const u = normal(random);
    for (int step = 0; step < 20; ++step) {
      double const omega = 2 * std::numbers::pi * 48;
      v += 5e-5 * (omega * omega * (u - x) - 0.06 * omega * v);
      x += 5e-5 * v;
    }
    signals.in.push_back(u);
    signals.out.push_back(x);
  }
  found = identify(signals, 400);
  REQUIRE(found.peaks.size() == 1);
  CHECK(found.peaks[0].frequency == Approx(48).epsilon(0.01));
  CHECK(found.peaks[0].damping == Approx(0.03).epsilon(0.25));
}

}  // namespace axisc::tuning::measurement_test
