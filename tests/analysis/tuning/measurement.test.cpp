#include "analysis/tuning/identification/measurement.hpp"

#include "support/catch.hpp"

#include <cmath>
#include <numbers>
#include <random>

#include <fmt/format.h>

namespace axisc::tuning {
namespace {

Measurement read(std::string const& bytes, SignalColumns const& columns = {}) {
  auto const found = read_measurement(recordings::source_of(bytes), columns);
  if (auto const* const bad = std::get_if<BadMeasurement>(&found)) {
    FAIL(static_cast<int>(bad->problem) << " line " << bad->line << " " << bad->column);
  }
  return std::get<Measurement>(found);
}

BadMeasurement refused(std::string const& bytes, SignalColumns const& columns = {}) {
  auto const found = read_measurement(recordings::source_of(bytes), columns);
  REQUIRE(std::holds_alternative<BadMeasurement>(found));
  return std::get<BadMeasurement>(found);
}

}  // namespace

TEST_CASE("two signals are read with their names and rate") {
  auto const found = read("time_ms,torque,velocity\n0,1,2\n2,3,4\n4,5,6\n");
  CHECK(found.kind == MeasurementKind::signals);
  CHECK(found.sampling_rate == Approx(500));
  CHECK(found.in == std::vector<double>{1, 3, 5});
  CHECK(found.out == std::vector<double>{2, 4, 6});
  CHECK(found.in_name == "torque");
  auto const other = read("time,a,b,c\n0,1,2,7\n1,3,4,8\n", {.in = "c", .out = "a"});
  CHECK(other.in == std::vector<double>{7, 8});
  CHECK(other.out == std::vector<double>{1, 3});
}

TEST_CASE("a Scope export with decimal commas, header lines and a column of times for each signal") {
  auto const found = read(
      "\xEF\xBB\xBFName\tDrive\r\nFile\tScope\r\n\r\nTime [ms]\tTorque\tTime [ms]\tVelocity\r\n"
      "0,0\t1,5\t0,0\t-2\r\n0,5\t1,25\t0,5\t+3\r\n1\t0\t1\t4e-1\r\nEOF\r\nrest\r\n");
  CHECK(found.sampling_rate == Approx(2000));
  CHECK(found.in == std::vector<double>{1.5, 1.25, 0});
  CHECK(found.out == std::vector<double>{-2, 3, 0.4});
}

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

TEST_CASE("what is no measurement is refused with its place") {
  using enum MeasurementProblem;
  CHECK(refused("").problem == no_rows);
  CHECK(refused("a,b\nc,d\n").problem == no_rows);
  CHECK(refused("time,a,b\n0,1,2\n").problem == no_rows);
  CHECK(refused("x,y\n0,1\n1,2\n").problem == no_columns);
  CHECK(refused("freq,y\n0,1\n1,2\n").problem == no_columns);
  auto bad = refused("time,a,b\n0,1,2\n1,x,2\n");
  CHECK((bad.problem == not_a_number && bad.line == 3));
  bad = refused("time,a,b\n0,1,2\n1,2\n");
  CHECK((bad.problem == field_count && bad.line == 3));
  CHECK(refused("time,a,b\n0,1,inf\n1,2,3\n2,3,4\n").problem == no_columns);
  bad = refused("time;a;b\n0;1,5;2\n1;1.5;2\n");
  CHECK((bad.problem == mixed_numbers && bad.column == "a"));
  bad = refused("time,a,b,c\n0,1,2,3\n1,2,3,4\n");
  CHECK((bad.problem == choose_columns && bad.column == "a, b, c"));
  bad = refused("time,a,b\n0,1,2\n1,2,3\n", {.in = "a", .out = "q"});
  CHECK((bad.problem == unknown_column && bad.column == "q"));
  bad = refused("time,a,b\n0,1,2\n1,2,3\n3,2,3\n4,2,3\n");
  CHECK((bad.problem == uneven_time && bad.line >= 3));
  CHECK(refused("time,a,b\n0,1,2\n0,2,3\n").problem == uneven_time);
  bad = refused("freq,magnitude\n1,1\n2,2\n2,3\n");
  CHECK((bad.problem == uneven_frequency && bad.line == 4));
}

TEST_CASE("a resonance of 48 Hz is found in a file of any kind") {
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

  std::string signals = "time_s;setpoint;actual\n";
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
    signals += fmt::format("{:.3f};{:.6f};{:.6f}\n", n * 1e-3, u, x);
  }
  found = identify(read(signals), 400);
  REQUIRE(found.peaks.size() == 1);
  CHECK(found.peaks[0].frequency == Approx(48).epsilon(0.01));
  CHECK(found.peaks[0].damping == Approx(0.03).epsilon(0.25));
}

}  // namespace axisc::tuning
