// Evidence of a resonance in signals that are written down as formulas: what is true is known.
#include "analysis/tuning/identification/fourier.hpp"
#include "analysis/tuning/identification/local_polynomial.hpp"
#include "analysis/tuning/identification/modes.hpp"
#include "support/catch.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <functional>
#include <numbers>
#include <random>

namespace axisc::tuning::evidence_test {
namespace {

constexpr double pi = std::numbers::pi;
constexpr double rate = 1000;

using Random = std::mt19937;

double normal(Random& random, double size) {
  return std::normal_distribution<double>(0, size)(random);
}

/// What an axis adds to its setpoint while this one rests, for `t` seconds, or moves.
struct Error {
  std::function<double(double t)> at_rest = [](double) { return 0.0; };
  std::function<double(double t, double position)> moving = [](double, double) { return 0.0; };
};

/// There and back at `speed`, a second each way, with rests of so many milliseconds.
Measurement travel(double speed, Error const& error, std::uint32_t seed, double noise, int ways = 4,
                   int rest = 500) {
  Random random(seed);
  Measurement made{.kind = MeasurementKind::signals, .response = {}, .sampling_rate = rate};
  double position = 0;
  double rested = 10;
  for (int n = 0; n < 400 + (1000 + rest) * ways; ++n) {
    int const place = (n - 400) % (1000 + rest);
    bool const moves = n >= 400 && place < 1000;
    double const sign = (n - 400) / (1000 + rest) % 2 == 0 ? 1 : -1;
    if (moves) position += sign * speed / rate;
    rested = moves ? 0 : rested + 1 / rate;
    double const t = n / rate;
    made.in.push_back(position);
    made.out.push_back(position + normal(random, noise) +
                       (moves ? error.moving(t, position) : error.at_rest(rested)));
  }
  return made;
}

ModeSearch found(std::vector<Measurement> const& recordings) {
  return find_modes(recordings, 400);
}

double sine(double frequency, double t) {
  return std::sin(2 * pi * frequency * t);
}

/// A damped sine behind a decay, as after a move.
Error ringing(double frequency, double damping, double size = 0.02) {
  double const omega = 2 * pi * frequency;
  return {.at_rest = [=](double t) {
    return -0.03 * std::exp(-t / 0.06) +
           size * std::exp(-damping * omega * t) * std::cos(omega * std::sqrt(1 - damping * damping) * t);
  }};
}

}  // namespace

TEST_CASE("the Fourier transform is its sum, for any length") {
  Random random(1);
  for (std::size_t const count : {1U, 2U, 7U, 64U, 100U, 243U}) {
    std::vector<std::complex<double>> values;
    for (std::size_t n = 0; n < count; ++n) values.emplace_back(normal(random, 1), normal(random, 1));
    auto transformed = values;
    transform(transformed);
    for (std::size_t k = 0; k < count; ++k) {
      std::complex<double> sum = 0;
      for (std::size_t n = 0; n < count; ++n) {
        sum += values[n] *
               std::polar(1.0, -2 * pi * static_cast<double>(k * n % count) / static_cast<double>(count));
      }
      INFO(count << " " << k);
      CHECK(std::abs(transformed[k] - sum) < 1e-12 * static_cast<double>(count));
    }
  }
}

TEST_CASE("local polynomials give a response and the deviation that it has") {
  // y_n = x_n + 0.5 x_(n-1) + noise:  H = 1 + 0.5 e^(-jω).
  std::size_t within = 0, all = 0;
  for (std::uint32_t seed = 1; seed <= 10; ++seed) {
    Random random(seed);
    std::vector<double> in, out;
    for (int n = 0; n < 4000; ++n) {
      in.push_back(normal(random, 1));
      out.push_back(in.back() + (n > 0 ? 0.5 * in[in.size() - 2] : 0) + normal(random, 1));
    }
    auto const local = local_response(in, out, rate, 4);
    for (std::size_t i = 0; i < local.deviation.size(); i += 13) {
      auto const truth = 1.0 + 0.5 * std::polar(1.0, -2 * pi * local.response.frequency[i] / rate);
      double const apart = std::abs(local.response.response[i] - truth) / local.deviation[i];
      ++all;
      within += apart < 2 ? 1 : 0;
    }
  }
  // |Δ|² / sd² is exponentially distributed: 1 - e^(-4) of all lie within two deviations.
  CHECK(static_cast<double>(within) / static_cast<double>(all) == Approx(0.982).margin(0.03));
}

TEST_CASE("an oscillation that rings down in every rest is found, with its damping") {
  for (std::uint32_t seed = 1; seed <= 6; ++seed) {
    Random random(seed);
    double const frequency = std::uniform_real_distribution<double>(9, 60)(random);
    double const damping = std::uniform_real_distribution<double>(0.01, 0.1)(random);
    auto const search = found({travel(20, ringing(frequency, damping), seed, 3e-4, 6)});
    INFO(seed << ": " << frequency << " Hz, " << damping);
    REQUIRE(search.modes.size() == 1);
    auto const& mode = search.modes[0];
    CHECK(mode.evidence == std::vector{Evidence::ring_down});
    CHECK(std::abs(mode.frequency - frequency) < 3 * mode.frequency_uncertainty);
    CHECK(mode.frequency == Approx(frequency).epsilon(0.015));
    REQUIRE(mode.damping);
    CHECK(*mode.damping == Approx(damping).epsilon(0.2));
  }
}

TEST_CASE("ring-down is refused for what it cannot show") {
  SECTION("decays alone") {
    auto const search = found({travel(20, ringing(20, 0.03, 0), 1, 3e-4, 6)});
    CHECK(search.modes.empty());
    CHECK(search.ring_down->doubt == RingDownDoubt::no_oscillation);
  }
  SECTION("three rests") {
    auto const search = found({travel(20, ringing(20, 0.03), 1, 3e-4, 3)});
    CHECK(search.modes.empty());
    CHECK(search.ring_down->doubt == RingDownDoubt::few_rests);
    CHECK(search.rests == 3);
  }
  SECTION("what goes on at rest") {
    auto const search =
        found({travel(20, {.at_rest = [](double t) { return 0.02 * sine(23, t); }}, 1, 3e-4, 6)});
    CHECK(search.modes.empty());
    CHECK(search.ring_down->doubt == RingDownDoubt::keeps_on);
    CHECK(search.ring_down->frequency == Approx(23).epsilon(0.01));
  }
  SECTION("damped too well") {
    CHECK(found({travel(20, ringing(20, 0.4), 1, 3e-4, 6)}).modes.empty());
  }
}

TEST_CASE("a line that keeps its frequency is a resonance; what moves with the speed is named") {
  // Once every 2.5 mm, and a resonance at 59.3 Hz.
  Error const error{.moving = [](double t, double position) {
    return 0.004 * sine(59.3, t) + 0.003 * sine(1 / 2.5, position);
  }};
  auto const fast = travel(50, error, 1, 1e-3);
  auto const slow = travel(30, error, 2, 1e-3);
  auto const search = found({fast, slow});
  REQUIRE(search.modes.size() == 1);
  CHECK(search.modes[0].evidence == std::vector{Evidence::lines});
  CHECK(search.modes[0].frequency == Approx(59.3).epsilon(0.003));
  CHECK_FALSE(search.modes[0].damping);
  CHECK(search.modes[0].is_told_from_shaking);
  REQUIRE(search.others.size() == 1);
  CHECK(search.others[0].kind == LineKind::proportional);
  CHECK(search.others[0].distance == Approx(2.5).epsilon(0.005));

  auto const once = found({fast});
  CHECK(once.modes.empty());
  CHECK(once.lines == LinesDoubt::one_speed);
}

TEST_CASE("lines that are no resonance are not taken for one") {
  auto const at_speeds = [](Error const& error) {
    return found({travel(50, error, 1, 1e-3), travel(30, error, 2, 1e-3)});
  };
  SECTION("mains") {
    auto const search = at_speeds({.at_rest = [](double t) { return 0.004 * sine(100.2, t); },
                                   .moving = [](double t, double) { return 0.004 * sine(100.2, t); }});
    CHECK(search.modes.empty());
    REQUIRE(search.others.size() == 1);
    CHECK(search.others[0].kind == LineKind::mains);
  }
  SECTION("a fan, which runs at rest as well") {
    auto const search = at_speeds({.at_rest = [](double t) { return 0.004 * sine(73.1, t); },
                                   .moving = [](double t, double) { return 0.004 * sine(73.1, t); }});
    CHECK(search.modes.empty());
    REQUIRE(search.others.size() == 1);
    CHECK(search.others[0].kind == LineKind::at_rest);
  }
  SECTION("a fan, where the rests are too short to tell") {
    Error const fan{.at_rest = [](double t) { return 0.004 * sine(73.1, t); },
                    .moving = [](double t, double) { return 0.004 * sine(73.1, t); }};
    auto const search = found({travel(50, fan, 1, 1e-3, 4, 150), travel(30, fan, 2, 1e-3, 4, 150)});
    REQUIRE(search.modes.size() == 1);
    CHECK_FALSE(search.modes[0].is_told_from_shaking);
  }
  SECTION("harmonics that coincide: three times 50/2.5 Hz is five times 30/2.5 Hz") {
    auto const search = at_speeds({.moving = [](double, double position) {
      return 0.003 * (sine(1 / 2.5, position) + sine(3 / 2.5, position) + sine(5 / 2.5, position));
    }});
    CHECK(search.modes.empty());
    // 60 Hz is a multiple of mains as well; which of both is said does not matter.
    CHECK(std::count_if(search.others.begin(), search.others.end(),
                        [](SpectralLine const& line) { return line.kind == LineKind::proportional; }) >= 1);
  }
  SECTION("noise") {
    for (std::uint32_t seed = 1; seed <= 10; ++seed) {
      CHECK(found({travel(50, {}, seed, 1e-3), travel(30, {}, seed + 20, 1e-3)}).modes.empty());
    }
  }
}

TEST_CASE("kinds of evidence that agree are one resonance, others are refused") {
  auto both = ringing(48, 0.02);
  both.moving = [](double t, double) { return 0.004 * sine(48.4, t); };
  auto search = found({travel(50, both, 1, 3e-4), travel(30, both, 2, 3e-4)});
  REQUIRE(search.modes.size() == 1);
  CHECK(search.modes[0].evidence == std::vector{Evidence::ring_down, Evidence::lines});
  CHECK(search.modes[0].frequency == Approx(48.2).margin(0.5));
  CHECK(search.modes[0].damping);

  both.moving = [](double t, double) { return 0.004 * sine(71, t); };
  search = found({travel(50, both, 1, 3e-4), travel(30, both, 2, 3e-4)});
  CHECK(search.modes.empty());
  REQUIRE(search.disagreement);
  CHECK(search.disagreement->evidence == std::array{Evidence::ring_down, Evidence::lines});
}

TEST_CASE("a force says nothing about rest and speed") {
  Measurement pulses{
      .kind = MeasurementKind::signals, .response = {}, .sampling_rate = rate, .input = InputKind::force};
  Random random(3);
  for (int n = 0; n < 6000; ++n) {
    pulses.in.push_back(n % 1500 < 400 ? 100 : 0);
    pulses.out.push_back(normal(random, 1));
  }
  auto const search = found({pulses});
  CHECK(search.modes.empty());
  CHECK(search.rests == 0);
  CHECK(search.pieces == 0);
}

TEST_CASE("recordings whose responses show different peaks are refused") {
  auto const response = [](double frequency) {
    Measurement made{.kind = MeasurementKind::response, .response = {}};
    made.response.has_phase = true;
    for (double f = 5; f < 200; f += 0.5) {
      std::complex<double> const jw(0, f / frequency);
      made.response.frequency.push_back(f);
      made.response.response.push_back(jw / (1.0 + 2 * 0.03 * jw + jw * jw));
    }
    return made;
  };
  auto const same = found({response(48), response(48.5)});
  REQUIRE(same.modes.size() == 1);
  CHECK(same.modes[0].frequency == Approx(48.25).margin(0.1));
  auto const different = found({response(48), response(60)});
  CHECK(different.modes.empty());
  REQUIRE(different.disagreement);
  CHECK(different.disagreement->recordings == std::array<std::size_t, 2>{0, 1});
}

}  // namespace axisc::tuning::evidence_test
