#include "design/kernels/kernel_analysis.hpp"

#include "design/phasor_def.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <numbers>
#include <span>

#include <boost/math/tools/toms748_solve.hpp>

namespace axisc::design {
namespace {

constexpr double pi = std::numbers::pi;

double angle(Hertz frequency, CycleTime cycle_time) {
  return 2 * pi * cycle_time.periods_in<double>(frequency);
}

bool passes(KernelDesign const& kernel) {
  return kernel.tail_sums.empty();
}

/// The symmetry of the taps, as the tail sums show it.
enum class Shape : std::uint8_t {
  odd,      ///< symmetrical about a tap
  even,     ///< symmetrical about the middle between two
  delay,    ///< two taps, the first and the last
  blended,  ///< any others: an undelayed share, impulses of a guard
};

Shape shape_of(KernelDesign const& kernel) {
  auto const& tails = kernel.tail_sums;
  if (kernel.half_width > 0) return Shape::odd;
  if (tails.front() == tails.back()) return Shape::delay;
  bool const is_even = tails.size() % 2 == 1 && tails[tails.size() / 2] == 0.5 &&
                       std::abs(tails.front() + tails.back() - 1) < 0x1p-40;
  return is_even ? Shape::even : Shape::blended;
}

bool is_linear_phase(KernelDesign const& kernel) {
  Shape const shape = shape_of(kernel);
  return shape == Shape::odd || shape == Shape::even;
}

double middle(KernelDesign const& kernel) {
  return static_cast<double>(kernel.tail_sums.size()) / 2;
}

/// A(θ) and its derivative.
struct Amplitude {
  double value = 1;
  double slope = 0;
};

/// With an even number of taps:  A = cos(θ/2) - 4 sin(θ/2) Σ_{i=1..} S_(c+i) sin(iθ),  S_c in the middle.
Amplitude amplitude_at(KernelDesign const& kernel, double theta) {
  double const sine = std::sin(theta / 2), cosine = std::cos(theta / 2);
  std::size_t const count = kernel.tail_sums.size();
  bool const is_odd = count % 2 == 0;
  double sum = 0, sum_of_slopes = 0;
  double factor = is_odd ? 0.5 : 1;
  Phasor<double> phasor(factor * theta, theta);
  for (double const tail : std::span(kernel.tail_sums).subspan((count + 1) / 2)) {
    sum += tail * phasor.sine();
    sum_of_slopes += tail * factor * phasor.cosine();
    phasor.advance();
    factor += 1;
  }
  return {(is_odd ? 1 : cosine) - 4 * sine * sum,
          (is_odd ? 0 : -sine / 2) - 2 * cosine * sum - 4 * sine * sum_of_slopes};
}

/// Time delay:  1 - s (1 - e^(-jNθ)).
std::complex<double> blended_delay(KernelDesign const& kernel, double theta) {
  double const s = kernel.tail_sums.front();
  double const phi = kernel.delay_cycles * theta;
  double const half_sine = std::sin(phi / 2);
  return {1 - s * 2 * half_sine * half_sine, -s * std::sin(phi)};
}

/// H and j dH/dθ, from  H = 1 - Σ S_j (e^(-jjθ) - e^(-j(j+1)θ)).
struct Moments {
  std::complex<double> response = 1;
  std::complex<double> first = 0;
};

Moments moments(KernelDesign const& kernel, double theta) {
  Moments sums;
  double j = 0;
  std::complex<double> here = 1;
  for (double const tail : kernel.tail_sums) {
    std::complex<double> const next = std::polar(1.0, -(j + 1) * theta);
    sums.response -= tail * (here - next);
    sums.first -= tail * (j * here - (j + 1) * next);
    here = next;
    j += 1;
  }
  return sums;
}

std::complex<double> response_at(KernelDesign const& kernel, double theta) {
  if (passes(kernel)) return 1;
  Shape const shape = shape_of(kernel);
  if (shape == Shape::delay) return blended_delay(kernel, theta);
  if (shape == Shape::blended) return moments(kernel, theta).response;
  return amplitude_at(kernel, theta).value * std::polar(1.0, -(middle(kernel) * theta));
}

/// -dφ/dθ;  for the time delay  Re(N s e^(-jNθ)/H),  in general  Re(Σ n b_n e^(-jnθ)/H).
double group_delay_cycles(KernelDesign const& kernel, double theta, std::complex<double> const& h) {
  if (passes(kernel)) return 0;
  double const N = kernel.delay_cycles;
  double const s = kernel.tail_sums.front();
  if (is_linear_phase(kernel)) return middle(kernel);
  bool const is_delay = shape_of(kernel) == Shape::delay;
  if (is_delay && s == 1) return N;
  if (std::abs(h) <= 4 * std::numeric_limits<double>::epsilon() * (1 + N * theta)) {
    return std::numeric_limits<double>::quiet_NaN();
  }
  return ((is_delay ? N * s * std::polar(1.0, -N * theta) : moments(kernel, theta).first) / h).real();
}

/// The root of f in low..high, where f has the given values of opposite sign.
template <typename Function>
double root(Function const& f, double low, double high, double f_low, double f_high) {
  std::uintmax_t iterations = 100;
  boost::math::tools::eps_tolerance<double> const tolerance(std::numeric_limits<double>::digits - 1);
  auto const bracket = boost::math::tools::toms748_solve(f, low, high, f_low, f_high, tolerance, iterations);
  return bracket.first + (bracket.second - bracket.first) / 2;
}

/// Walks A(θ), a polynomial of degree h in cos θ (times cos(θ/2) with an even number of taps), in steps well
/// below the distance π/h of its zeros.
class ZeroSearch {
 public:
  explicit ZeroSearch(KernelDesign const& kernel) : kernel_(kernel), lobe_(pi / middle(kernel)) {}

  std::vector<double> run() {
    // A fraction no frequency hits by being a round number. The last step goes beyond π, where A is
    // symmetrical.
    constexpr double offset = 0.38196601125;
    double const step = lobe_ / steps_per_lobe;
    Place low = place(offset * step);
    for (std::uint32_t i = 1; low.theta < pi; ++i) {
      Place const high = place((i + offset) * step);
      search(low, high);
      low = high;
    }
    return zeros_;
  }

 private:
  static constexpr int steps_per_lobe = 16;
  /// |A| at a double zero; a minimum that is not a zero is larger.
  static constexpr double touches = 1e-12;
  static constexpr double smallest_side_lobe = 1e-6;

  struct Place {
    double theta;
    Amplitude amplitude;
  };

  [[nodiscard]] Place place(double theta) const { return {theta, amplitude_at(kernel_, theta)}; }
  [[nodiscard]] double value(double theta) const { return amplitude_at(kernel_, theta).value; }

  void search(Place const& low, Place const& high) {
    bool const is_positive = low.amplitude.value > 0;
    if (is_positive != (high.amplitude.value > 0)) {
      add_crossing(low, high);
      return;
    }
    // Between equal signs A touches or crosses zero only where |A| has a minimum.
    bool const has_minimum =
        (low.amplitude.slope > 0) != is_positive && (high.amplitude.slope > 0) == is_positive;
    if (!has_minimum) return;
    Place const minimum = place(root([this](double theta) { return amplitude_at(kernel_, theta).slope; },
                                     low.theta, high.theta, low.amplitude.slope, high.amplitude.slope));
    if (std::abs(minimum.amplitude.value) <= touches) {
      add(minimum.theta);
    } else if ((minimum.amplitude.value > 0) != is_positive) {
      add_crossing(low, minimum);
      add_crossing(minimum, high);
    }
  }

  void add_crossing(Place const& low, Place const& high) {
    add(root([this](double theta) { return value(theta); }, low.theta, high.theta, low.amplitude.value,
             high.amplitude.value));
  }

  void add(double theta) {
    double const quarter = lobe_ / 4;
    double const nearby = std::max(std::abs(value(theta - quarter)), std::abs(value(theta + quarter)));
    bool const is_new = zeros_.empty() || theta - zeros_.back() > 1e-3 * lobe_;
    if (nearby >= smallest_side_lobe && is_new && theta <= pi * (1 + 1e-12)) {
      zeros_.push_back(std::min(theta, pi));
    }
  }

  KernelDesign const& kernel_;
  double lobe_;
  std::vector<double> zeros_{};
};

/// Halves of equal weight cancel where they are in opposite phase: θ = (2i + 1) π/N.
std::vector<double> zeros_of_delay(KernelDesign const& kernel) {
  std::vector<double> zeros;
  if (shape_of(kernel) != Shape::delay || kernel.tail_sums.front() != 0.5) return zeros;
  for (std::uint32_t odd = 1; odd <= kernel.delay_cycles; odd += 2) {
    zeros.push_back(pi * odd / kernel.delay_cycles);
  }
  return zeros;
}

}  // namespace

std::complex<double> response(KernelDesign const& kernel, Hertz frequency, CycleTime cycle_time) {
  return response_at(kernel, angle(frequency, cycle_time));
}

ResponsePoint kernel_response(KernelDesign const& kernel, Hertz frequency, CycleTime cycle_time) {
  double const theta = angle(frequency, cycle_time);
  std::complex<double> const h = response_at(kernel, theta);
  return {.magnitude = std::abs(h),
          .phase_rad = std::arg(h),
          .group_delay_s = group_delay_cycles(kernel, theta, h) * cycle_time.seconds()};
}

ResponsePoint in_series(ResponsePoint const& first, ResponsePoint const& second) {
  return {.magnitude = first.magnitude * second.magnitude,
          .phase_rad = std::remainder(first.phase_rad + second.phase_rad, 2 * pi),
          .group_delay_s = first.group_delay_s + second.group_delay_s};
}

std::vector<Hertz> zero_frequencies(KernelDesign const& kernel, CycleTime cycle_time) {
  if (passes(kernel)) return {};
  std::vector<Hertz> frequencies;
  for (double const theta : is_linear_phase(kernel) ? ZeroSearch(kernel).run() : zeros_of_delay(kernel)) {
    frequencies.push_back({theta / pi * cycle_time.nyquist().value});
  }
  return frequencies;
}

StepFigures step_figures(KernelDesign const& kernel, double tolerance) {
  StepFigures figures{.settling_cycles = 0};
  double negative = 0;  // taps; Σ b = 1, hence Σ|b| = 1 + 2 Σ of the negative ones
  double previous = 1;
  for (std::size_t n = 0; n <= kernel.tail_sums.size(); ++n) {
    double const tail = n < kernel.tail_sums.size() ? kernel.tail_sums[n] : 0;
    figures.overshoot = std::max(figures.overshoot, -tail);
    negative += std::max(0.0, tail - previous);
    if (!(std::abs(tail) <= tolerance)) figures.settling_cycles = n + 1;
    previous = tail;
  }
  // Of up to 201, in a guard of 961 differences, and as many sums.
  double const rounding = kernel.tail_sums.size() <= longest_kernel_order ? 0x1p-44 : 0x1p-42;
  figures.peak_gain = 1 + 2 * negative;
  figures.peak_gain_bound = negative == 0 ? 1 : std::nextafter(1 + 2 * negative * (1 + rounding), HUGE_VAL);
  return figures;
}

}  // namespace axisc::design
