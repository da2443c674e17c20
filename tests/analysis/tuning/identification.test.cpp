#include "analysis/tuning/identification/resonances.hpp"
#include "support/catch.hpp"

#include <cmath>
#include <functional>
#include <numbers>
#include <random>

namespace axisc::tuning::identification_test {
namespace {

constexpr double pi = std::numbers::pi;
constexpr double sampling_rate = 1000;

struct Oscillator {
  double frequency = 48, damping = 0.03;
};

/// A rigid mass and masses on springs under a torque; the velocity of all together, integrated in hundredths
/// of a sample.
std::vector<double> velocities(std::vector<double> const& torque, std::vector<Oscillator> const& modes,
                               std::function<double(std::size_t)> const& drift = {}) {
  constexpr int steps = 100;
  constexpr double h = 1 / sampling_rate / steps;
  std::vector<double> x(modes.size()), v(modes.size()), out;
  double rigid = 0;
  for (std::size_t n = 0; n < torque.size(); ++n) {
    double const shift = drift ? drift(n) : 1;
    for (int step = 0; step < steps; ++step) {
      rigid += h * torque[n];
      for (std::size_t i = 0; i < modes.size(); ++i) {
        double const omega = 2 * pi * modes[i].frequency * shift;
        // Semi-implicit: the energy of an undamped spring neither grows nor falls.
        v[i] += h * (torque[n] - 2 * modes[i].damping * omega * v[i] - omega * omega * x[i]);
        x[i] += h * v[i];
      }
    }
    double sum = 0.2 * rigid;
    for (double const one : v) sum += one;
    out.push_back(sum);
  }
  return out;
}

std::vector<double> noise(std::size_t count, double amplitude, std::uint32_t seed) {
  std::mt19937 random(seed);
  std::normal_distribution<double> normal(0, amplitude);
  std::vector<double> values(count);
  for (auto& value : values) value = normal(random);
  return values;
}

std::vector<double> plus(std::vector<double> a, std::vector<double> const& b) {
  for (std::size_t i = 0; i < a.size(); ++i) a[i] += b[i];
  return a;
}

Identification from(std::vector<double> const& in, std::vector<double> const& out) {
  return identify(in, out, sampling_rate, 4, 400);
}

}  // namespace

TEST_CASE("resonances are found by frequency and damping, with an uncertainty that holds") {
  std::size_t outside = 0;
  for (std::uint32_t seed = 1; seed <= 20; ++seed) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> frequency(15, 150), damping(0.01, 0.05);
    std::vector<Oscillator> modes{{frequency(random), damping(random)}};
    if (seed % 3 == 0) modes.push_back({modes[0].frequency * 2.2, damping(random)});
    auto const torque = noise(32768, 1, seed);
    auto const velocity = plus(velocities(torque, modes), noise(32768, 1e-4, seed + 100));
    auto const found = from(torque, velocity);
    INFO("seed " << seed << ": " << modes[0].frequency << " Hz, " << modes[0].damping);
    REQUIRE(found.peaks.size() == modes.size());
    CHECK_FALSE(found.doubt);
    for (std::size_t i = 0; i < modes.size(); ++i) {
      auto const& peak = found.peaks[i];
      CHECK(peak.frequency == Approx(modes[i].frequency).epsilon(0.015));
      CHECK(peak.damping == Approx(modes[i].damping).epsilon(0.25).margin(0.002));
      CHECK(*peak.ratio >= lowest_ratio);
      if (std::abs(peak.frequency - modes[i].frequency) > 3 * peak.frequency_uncertainty) ++outside;
    }
  }
  CHECK(outside <= 1);
}

TEST_CASE("an output that the input does not move shows no resonance") {
  for (std::uint32_t seed = 1; seed <= 20; ++seed) {
    auto const torque = noise(16384, 1, seed);
    auto const found = from(torque, velocities(noise(16384, 1, seed + 50), {{48, 0.03}}));
    INFO(seed);
    CHECK(found.peaks.empty());
    CHECK((found.doubt == Doubt::uncertain || found.doubt == Doubt::no_excitation));
  }
}

TEST_CASE("an input without energy at the resonance shows none") {
  std::vector<double> torque;
  for (std::size_t n = 0; n < 16384; ++n) {
    double const t = static_cast<double>(n) / sampling_rate;
    torque.push_back(std::sin(2 * pi * 3 * t) + 0.5 * std::sin(2 * pi * 6.1 * t));
  }
  auto const velocity = plus(velocities(torque, {{48, 0.03}}), noise(16384, 1e-3, 5));
  auto const found = from(torque, velocity);
  CHECK(found.peaks.empty());
  CHECK((found.doubt == Doubt::no_excitation || found.doubt == Doubt::incoherent));
}

TEST_CASE("a resonance that moves is refused") {
  for (std::uint32_t seed = 1; seed <= 10; ++seed) {
    auto const torque = noise(32768, 1, seed);
    auto const velocity = velocities(
        torque, {{48, 0.02}}, [](std::size_t n) { return 0.85 + 0.3 * static_cast<double>(n / 8192) / 3; });
    auto const found = from(torque, velocity);
    INFO(seed);
    CHECK(found.peaks.empty());
    CHECK((found.doubt == Doubt::moving || found.doubt == Doubt::uncertain));
  }
}

TEST_CASE("a rigid axis has no resonance, and a short recording shows none") {
  auto const torque = noise(16384, 1, 3);
  CHECK(from(torque, velocities(torque, {})).doubt == Doubt::no_peak);
  std::vector<double> const few(100, 1.0);
  CHECK(from(few, few).doubt == Doubt::too_short);
  std::vector<double> const silent(16384, 0.0);
  CHECK(from(silent, silent).doubt == Doubt::no_excitation);
}

TEST_CASE("a frequency response and a spectrum carry frequency and damping") {
  MeasuredResponse measured;
  for (double f = 5; f < 200; f += 0.5) {
    std::complex<double> const jw(0, f / 48);
    measured.frequency.push_back(f);
    measured.response.push_back(jw / (1.0 + 2 * 0.03 * jw + jw * jw));
  }
  measured.has_phase = true;
  auto found = identify(measured, 4, 400);
  REQUIRE(found.peaks.size() == 1);
  CHECK(found.peaks[0].frequency == Approx(48).epsilon(1e-6));
  CHECK(found.peaks[0].damping == Approx(0.03).epsilon(1e-6));

  for (auto& value : measured.response) value = std::abs(value);
  measured.has_phase = false;
  found = identify(measured, 4, 400);
  REQUIRE(found.peaks.size() == 1);
  CHECK(found.peaks[0].frequency == Approx(48).epsilon(0.01));
  CHECK(found.peaks[0].damping == Approx(0.03).epsilon(0.2));
  CHECK_FALSE(found.peaks[0].coherence);

  measured.coherence.assign(measured.frequency.size(), 0.5);
  found = identify(measured, 4, 400);
  CHECK(found.doubt == Doubt::incoherent);
  CHECK(found.doubtful_frequency == Approx(48).epsilon(0.02));
}

}  // namespace axisc::tuning::identification_test
