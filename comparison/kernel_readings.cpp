#include "comparison/kernel_readings.hpp"

#include <array>
#include <cmath>
#include <numbers>

namespace axisc::comparison::says {

constexpr Sentence taps_n{"order N means N taps", "Ordnung N heißt N Koeffizienten"};
constexpr Sentence taps_n_1{"order N means N + 1 taps", "Ordnung N heißt N + 1 Koeffizienten"};
constexpr Sentence half_width_down{"half the width is N/2, rounded down",
                                   "die halbe Breite ist N/2, abgerundet"};
constexpr Sentence half_width_n{"order N is half the width, 2N + 1 taps",
                                "Ordnung N ist die halbe Breite, 2N + 1 Koeffizienten"};
constexpr Sentence gauss_1{"Gaussian of standard deviation quality × half width",
                           "Gauß mit Standardabweichung Güte × halbe Breite"};
constexpr Sentence gauss_2{"Gaussian of standard deviation quality × half width / 2",
                           "Gauß mit Standardabweichung Güte × halbe Breite / 2"};
constexpr Sentence gauss_3{"Gaussian of standard deviation quality × half width / 3",
                           "Gauß mit Standardabweichung Güte × halbe Breite / 3"};
constexpr Sentence hann{"sinc in Hann's window", "Sinc im Hann-Fenster"};
constexpr Sentence blackman{"sinc in Blackman's window", "Sinc im Blackman-Fenster"};
constexpr Sentence no_window{"sinc without a window", "Sinc ohne Fenster"};
constexpr Sentence novib_box{"NoVib is one box of a period of fg_f0, not two",
                             "NoVib ist ein Rechteck einer Periode von fg_f0, nicht zwei"};
constexpr Sentence undelayed_share{"the unfiltered share passes undelayed",
                                   "der ungefilterte Anteil läuft unverzögert"};
constexpr Sentence no_share{"the share is ignored", "der Anteil wird nicht beachtet"};

}  // namespace axisc::comparison::says

namespace axisc::comparison {

namespace {

using design::CycleTime;
using design::KernelSpecification;
using design::KernelType;
using Taps = std::vector<double>;

constexpr double pi = std::numbers::pi;
constexpr double listed_width = 2.5;
enum class Window : std::uint8_t { hamming, hann, blackman, none };

double window_at(Window window, double x) {  // x from -1 to 1
  switch (window) {
    case Window::hamming:
      return 0.54 + 0.46 * std::cos(pi * x);
    case Window::hann:
      return 0.5 + 0.5 * std::cos(pi * x);
    case Window::blackman:
      return 0.42 + 0.5 * std::cos(pi * x) + 0.08 * std::cos(2 * pi * x);
    case Window::none:
      break;
  }
  return 1;
}

struct Shape {
  std::size_t taps;
  double gaussian_width = listed_width;
  Window window = Window::hamming;
};

double weight(KernelSpecification const& wanted, CycleTime cycle_time, Shape const& shape, double k,
              double half) {
  if (wanted.type == KernelType::gaussian) {
    double const sigma = wanted.quality * half / shape.gaussian_width;
    return std::exp(-0.5 * (k / sigma) * (k / sigma));
  }
  if (wanted.type != KernelType::windowed_sinc) return 1;
  double const angle = 2 * pi * wanted.frequency.value * cycle_time.seconds() * k;
  return (k == 0 ? 1 : std::sin(angle) / angle) * window_at(shape.window, k / half);
}

bool has_order(KernelSpecification const& wanted) {
  return wanted.type == KernelType::moving_average || wanted.type == KernelType::gaussian ||
         wanted.type == KernelType::windowed_sinc;
}

/// Symmetrical taps, also an even number of them; the direct part passes through the middle.
Taps shaped(KernelSpecification const& wanted, CycleTime cycle_time, Shape const& shape) {
  if (shape.taps < 2) return {};
  double const half = static_cast<double>(shape.taps - 1) / 2;
  Taps taps;
  double sum = 0;
  for (std::size_t i = 0; i < shape.taps; ++i) {
    taps.push_back(weight(wanted, cycle_time, shape, static_cast<double>(i) - half, half));
    sum += taps.back();
  }
  double const share = wanted.share_percent / 100;
  for (double& tap : taps) tap *= share / sum;
  taps[(shape.taps - 1) / 2] += (1 - share) / 2;
  taps[shape.taps / 2] += (1 - share) / 2;
  return taps;
}

std::size_t listed_taps(KernelSpecification const& wanted) {
  return 2 * std::size_t{(wanted.order + 1) / 2} + 1;
}

template <std::size_t more>
Taps order_and(KernelSpecification const& wanted, CycleTime cycle_time) {
  return has_order(wanted) ? shaped(wanted, cycle_time, {.taps = wanted.order + more}) : Taps{};
}

Taps rounded_down(KernelSpecification const& wanted, CycleTime cycle_time) {
  return has_order(wanted) ? shaped(wanted, cycle_time, {.taps = 2 * std::size_t{wanted.order / 2} + 1})
                           : Taps{};
}

Taps order_is_half(KernelSpecification const& wanted, CycleTime cycle_time) {
  return has_order(wanted) ? shaped(wanted, cycle_time, {.taps = 2 * std::size_t{wanted.order} + 1}) : Taps{};
}

template <int width>
Taps gaussian_of(KernelSpecification const& wanted, CycleTime cycle_time) {
  if (wanted.type != KernelType::gaussian) return {};
  return shaped(wanted, cycle_time, {.taps = listed_taps(wanted), .gaussian_width = width});
}

template <Window window>
Taps in_window(KernelSpecification const& wanted, CycleTime cycle_time) {
  if (wanted.type != KernelType::windowed_sinc) return {};
  return shaped(wanted, cycle_time, {.taps = listed_taps(wanted), .window = window});
}

/// A box with edges that make the gain at fg_f0 zero; convolved with itself it is the listed kernel.
Taps one_box(KernelSpecification const& wanted, CycleTime cycle_time) {
  if (wanted.type != KernelType::novib) return {};
  std::size_t const n = design::half_width(wanted, cycle_time) / 2;
  double const theta = 2 * pi * wanted.frequency.value * cycle_time.seconds();
  double sum = 1;
  for (std::size_t k = 1; k < n; ++k) sum += 2 * std::cos(static_cast<double>(k) * theta);
  double const edge = -sum / (2 * std::cos(static_cast<double>(n) * theta));
  double const total = static_cast<double>(2 * n - 1) + 2 * edge;
  double const share = wanted.share_percent / 100;
  Taps taps(2 * n + 1, share / total);
  taps.front() = taps.back() = edge * share / total;
  taps[n] += 1 - share;
  return taps;
}

Taps without_share(KernelSpecification const& listed, CycleTime cycle_time) {
  KernelSpecification wanted = listed;
  if (wanted.share_percent == 100) return {};
  wanted.share_percent = 100;
  return design::design_kernel(wanted, cycle_time).taps;
}

Taps share_undelayed(KernelSpecification const& wanted, CycleTime cycle_time) {
  if (wanted.type == KernelType::time_delay) return {};
  Taps taps = without_share(wanted, cycle_time);
  if (taps.empty()) return taps;
  for (double& tap : taps) tap *= wanted.share_percent / 100;
  taps.front() += 1 - wanted.share_percent / 100;
  return taps;
}

constexpr std::array<KernelReading, 13> rows{
    {{{"taps-n", says::taps_n}, order_and<0>},
     {{"taps-n-plus-1", says::taps_n_1}, order_and<1>},
     {{"half-width-rounded-down", says::half_width_down}, rounded_down},
     {{"order-is-half-width", says::half_width_n}, order_is_half},
     {{"gaussian-width-1", says::gauss_1}, gaussian_of<1>},
     {{"gaussian-width-2", says::gauss_2}, gaussian_of<2>},
     {{"gaussian-width-3", says::gauss_3}, gaussian_of<3>},
     {{"sinc-hann", says::hann}, in_window<Window::hann>},
     {{"sinc-blackman", says::blackman}, in_window<Window::blackman>},
     {{"sinc-no-window", says::no_window}, in_window<Window::none>},
     {{"novib-one-box", says::novib_box}, one_box},
     {{"share-undelayed", says::undelayed_share}, share_undelayed},
     {{"share-ignored", says::no_share}, without_share}}};

}  // namespace

std::span<KernelReading const> kernel_readings() {
  return rows;
}

}  // namespace axisc::comparison
