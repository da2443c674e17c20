// Vibration Guard beside an oscillator that is simulated with what its taps make of a motion, the figures of
// an independent program, and the guide values of the vendor.
#include "design/kernels/vibration_guard.hpp"

#include "design/kernels/kernel_analysis.hpp"
#include "support/catch.hpp"

#include <cmath>
#include <complex>
#include <fstream>
#include <numbers>
#include <numeric>
#include <random>

#include <nlohmann/json.hpp>

namespace axisc::design::vibration_guard_test {
namespace {

using nlohmann::json;

constexpr CycleTime one_millisecond{1'000'000};

KernelSpecification guard_of(std::uint32_t mode, double frequency, double damping,
                             KernelReading reading = KernelReading::documented) {
  return {.type = KernelType::vibration_guard,
          .order = mode,
          .frequency = {frequency},
          .quality = damping,
          .reading = reading};
}

/// x'' + 2 D ω x' + ω² x = ω² u, with a setpoint u that jumps at every cycle: solved in closed form.
class Oscillator {
 public:
  Oscillator(Hertz frequency, double damping, CycleTime cycle_time)
      : omega_(2 * std::numbers::pi * frequency.value),
        sigma_(omega_ * damping),
        damped_(omega_ * std::sqrt(1 - damping * damping)),
        T_(cycle_time.seconds()) {}

  void step(double setpoint) {
    lag_ += setpoint_ - setpoint;  // x - u
    setpoint_ = setpoint;
    double const decay = std::exp(-sigma_ * T_);
    double const c = std::cos(damped_ * T_), s = std::sin(damped_ * T_) / damped_;
    double const lag = decay * (lag_ * (c + sigma_ * s) + velocity_ * s);
    velocity_ = decay * (velocity_ * (c - sigma_ * s) - lag_ * omega_ * omega_ * s);
    lag_ = lag;
  }

  /// Of the decaying oscillation about the setpoint.
  [[nodiscard]] double amplitude() const { return std::hypot(lag_, (velocity_ + sigma_ * lag_) / damped_); }

 private:
  double omega_, sigma_, damped_, T_;
  double setpoint_ = 0, lag_ = 0, velocity_ = 0;
};

/// A motion of some cycles that comes to rest.
std::vector<double> random_motion(std::mt19937& random) {
  std::vector<double> setpoints;
  double position = 0;
  for (int cycle = 0; cycle < 37; ++cycle) {
    position += static_cast<double>(random() % 1000) / 1000;
    setpoints.push_back(position);
  }
  return setpoints;
}

double simulated_residual(KernelDesign const& kernel, Hertz actual, double damping, CycleTime cycle_time,
                          std::vector<double> const& motion) {
  Oscillator plain(actual, damping, cycle_time), shaped(actual, damping, cycle_time);
  for (double const setpoint : motion) plain.step(setpoint);
  for (std::size_t n = 0; n < motion.size() + kernel.taps.size() - 1; ++n) {
    double setpoint = 0;
    for (std::size_t k = 0; k < kernel.taps.size() && k <= n; ++k) {
      setpoint += kernel.taps[k] * motion[std::min(n - k, motion.size() - 1)];
    }
    shaped.step(setpoint);
  }
  return shaped.amplitude() / plain.amplitude();
}

}  // namespace

TEST_CASE("residual vibration is what a simulated oscillator keeps") {
  std::mt19937 random(20261126);
  for (std::uint32_t mode = 1; mode <= guard_modes; ++mode) {
    for (double const damping : {0.0, 0.02, 0.1, 0.4}) {
      auto const kernel = design_kernel(guard_of(mode, 30, damping), one_millisecond);
      for (double const actual : {22.0, 28.5, 30.0, 37.0}) {
        INFO("mode " << mode << " damping " << damping << " actual " << actual);
        double const simulated =
            simulated_residual(kernel, {actual}, damping, one_millisecond, random_motion(random));
        CHECK(std::abs(residual_vibration(kernel, {actual}, damping, one_millisecond) - simulated) < 1e-9);
      }
    }
  }
}

TEST_CASE("without damping the residual vibration is the magnitude of the response") {
  auto const kernel = design_kernel(guard_of(2, 30, 0.1), one_millisecond);
  for (double const f : {5.0, 30.0, 44.0, 321.0}) {
    double const magnitude = std::abs(response(kernel, {f}, one_millisecond));
    CHECK(residual_vibration(kernel, {f}, 0, one_millisecond) == Approx(magnitude).margin(1e-13));
  }
}

TEST_CASE("the bands contain the vendor's guide values") {
  for (std::uint32_t mode = 1; mode <= guard_modes; ++mode) {
    for (std::uint32_t const nanoseconds : {250'000U, 1'000'000U, 2'000'000U}) {
      INFO("mode " << mode << " T " << nanoseconds);
      CycleTime const T{nanoseconds};
      auto const guard = guard_of(mode, 30, 0.1);
      auto const found = robustness(design_kernel(guard, T), guard, T);
      REQUIRE(found);
      auto const [lowest, highest] = guide_values(mode);
      CHECK(found->lowest <= lowest);
      CHECK(found->highest >= highest);
      CHECK(found->from.value == Approx(30 / (1 + found->highest)));
      CHECK(found->to.value == Approx(30 / (1 + found->lowest)));
    }
  }
}

TEST_CASE("every guard has positive taps that are one together, and none overshoots") {
  for (std::uint32_t mode = 1; mode <= guard_modes; ++mode) {
    for (double const frequency : {1.9, 7.3, 30.0, 211.0, 499.0}) {
      for (double const damping : {0.0, 0.1, 0.7}) {
        INFO("mode " << mode << " f " << frequency << " D " << damping);
        auto const guard = guard_of(mode, frequency, damping);
        auto const kernel = design_kernel(guard, one_millisecond);
        CHECK(kernel.taps.size() == tap_count(guard, one_millisecond));
        CHECK(kernel.tail_sums.size() == kernel.taps.size() - 1);
        CHECK(*std::min_element(kernel.taps.begin(), kernel.taps.end()) >= 0);
        CHECK(std::accumulate(kernel.taps.begin(), kernel.taps.end(), 0.0) == Approx(1).epsilon(1e-14));
        double const delay = std::accumulate(kernel.tail_sums.begin(), kernel.tail_sums.end(), 0.0);
        CHECK(kernel.group_delay_cycles == Approx(delay).epsilon(1e-12));
        CHECK(kernel_delay_cycles(guard, one_millisecond) == kernel.group_delay_cycles);
        CHECK(step_figures(kernel, 1e-6).peak_gain_bound == 1);
        CHECK(guard_length(guard, one_millisecond) <= static_cast<double>(kernel.tail_sums.size()) + 1e-9);
        if (mode != symmetrical_guard) continue;
        CHECK(kernel.half_width * 2 == kernel.tail_sums.size());
        CHECK(kernel.taps == std::vector<double>(kernel.taps.rbegin(), kernel.taps.rend()));
      }
    }
  }
}

TEST_CASE("the response of a guard is the discrete Fourier transform of its taps") {
  // With these some tail in the middle is exactly one half, without any symmetry.
  for (auto const& guard :
       {guard_of(1, 30, 0), guard_of(1, 29.4, 0), guard_of(2, 30, 0), guard_of(3, 77, 0.3)}) {
    auto const kernel = design_kernel(guard, one_millisecond);
    for (double const f : {1.0, 30.0, 100.0, 400.0}) {
      std::complex<double> sum = 0;
      for (std::size_t k = 0; k < kernel.taps.size(); ++k) {
        sum += kernel.taps[k] * std::polar(1.0, -2 * std::numbers::pi * f * 1e-3 * static_cast<double>(k));
      }
      CHECK(std::abs(response(kernel, {f}, one_millisecond) - sum) < 1e-12);
    }
  }
}

TEST_CASE("a placed zero leaves nothing at the configured frequency") {
  for (std::uint32_t mode = 1; mode <= guard_modes; ++mode) {
    auto const guard = guard_of(mode, 37, 0.12, KernelReading::guard_zero_placed);
    auto const kernel = design_kernel(guard, one_millisecond);
    CHECK(residual_at_design(kernel, guard, one_millisecond) < 1e-14);
  }
}

TEST_CASE("the lowest frequency of a guard is the one whose last impulse is there") {
  auto guard = guard_of(3, 30, 0.1);
  guard.frequency = lowest_guard_frequency(guard, one_millisecond, 200);
  CHECK(guard_length(guard, one_millisecond) == Approx(200));
}

TEST_CASE("guards of an independent program") {
  auto const path = std::filesystem::path(AXISC_SOURCE_DIR) / "../shared/reference/vibration_guard.json";
  std::ifstream file(path);
  if (!file) {
    WARN(path.string() << " is not here");
    return;
  }
  auto const document = json::parse(file);
  for (auto const& one : document.at("cases")) {
    INFO(one.at("id"));
    KernelSpecification guard = guard_of(1, 30, 0.1);
    auto const words = one.contains("command") ? json::array({one.at("command")}) : one.at("list");
    for (std::string text : words) {
      auto const number = [&](std::string_view word, double otherwise) {
        auto const at = text.find(word);
        return at == std::string::npos ? otherwise : std::stod(text.substr(at + word.size() + 1));
      };
      guard.order = static_cast<std::uint32_t>(number("mode", number("MODE", guard.order)));
      guard.frequency = {number("freq", number("FREQ", guard.frequency.value))};
      guard.quality = number("damping", number("DAMPING", guard.quality));
    }
    if (one.contains("design")) {
      std::string const word = one.at("design").at("vibration_guard");
      guard.reading = *reading_of<KernelReading>(kernel_reading_words, word);
    }
    CycleTime const T{one.at("cycle_time_us").get<std::uint32_t>() * 1000};
    auto const kernel = design_kernel(guard, T);
    CHECK(kernel.tail_sums.size() == one.at("tail_sums"));
    CHECK(std::abs(kernel.group_delay_cycles - one.at("group_delay_cycles").get<double>()) < 1e-9);
    std::vector<double> taps(kernel.taps.size(), 0.0);
    for (auto const& tap : one.at("taps")) taps.at(tap.at(0)) = tap.at(1);
    for (std::size_t k = 0; k < taps.size(); ++k) CHECK(std::abs(taps[k] - kernel.taps[k]) < 1e-12);
    auto const impulses = guard_impulses(guard);
    REQUIRE(impulses.size() == one.at("impulses").size());
    for (std::size_t i = 0; i < impulses.size(); ++i) {
      CHECK(impulses[i].time.value == Approx(one.at("impulses").at(i).at(0).get<double>()));
      CHECK(impulses[i].amplitude == Approx(one.at("impulses").at(i).at(1).get<double>()));
    }
    for (auto const& residual : one.at("residual")) {
      double const V = residual_vibration(kernel, {residual.at(0).get<double>()}, residual.at(1), T);
      CHECK(std::abs(V - residual.at(2).get<double>()) < 1e-9);
    }
    auto const found = robustness(kernel, guard, T);
    bool const has_interval = one.contains("interval_percent") && !one.at("interval_percent").is_null();
    REQUIRE(found.has_value() == has_interval);
    if (!found) continue;
    CHECK(std::abs(100 * found->lowest - one.at("interval_percent").at(0).get<double>()) < 0.01);
    CHECK(std::abs(100 * found->highest - one.at("interval_percent").at(1).get<double>()) < 0.01);
  }
}

}  // namespace axisc::design::vibration_guard_test
