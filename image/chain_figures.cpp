#include "image/chain_figures.hpp"

#include "design/filter_analysis.hpp"
#include "design/filter_kinds.hpp"
#include "design/kernels/kernel_analysis.hpp"
#include "design/kernels/kernel_kinds.hpp"
#include "image/runtime_host.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <variant>

namespace axisc::image {
namespace {

constexpr double settled_within = 1e-4;

std::vector<design::FilterDesign> designs(ImageAxis const& axis) {
  std::vector<design::FilterDesign> chain;
  for (ImageFilter const& filter : axis.filters) chain.push_back(filter.design);
  return chain;
}

ImageKernel const* kernel_at_start(ImageContents const& contents, std::size_t axis) {
  auto const& slot = contents.axes[axis].slot;
  if (!slot || !slot->on_at_start || !slot->kernel) return nullptr;
  return &contents.kernels[*slot->kernel];
}

double summed_gain(std::span<design::FilterDesign const> chain) {
  return design::step_figures(chain, design::longest_summation, settled_within).peak_gain;
}

bool is_about(double stated, double gain) {
  constexpr double noticeable = 1e-6;
  return stated <= gain * (1 + noticeable);
}

/// Distance of the origin from the line between two points.
double distance_to_origin(double x0, double y0, double x1, double y1) {
  double const dx = x1 - x0;
  double const dy = y1 - y0;
  double const length = dx * dx + dy * dy;
  double const t = length > 0 ? std::clamp(-(x0 * dx + y0 * dy) / length, 0.0, 1.0) : 0.0;
  return std::hypot(x0 + t * dx, y0 + t * dy);
}

/// One axis ends a ramp in the corner while the other begins one. By superposition the ending ramp's answer
/// is the endless ramp's, n - delay, less the beginning one's, r[n].
class Corner {
 public:
  explicit Corner(double delay) : delay_(delay), nearest_(delay), x_before_(-delay) {}

  void take(std::uint64_t n, double ramp) {
    double const y = ramp;
    double const x = static_cast<double>(n) - delay_ - y;
    nearest_ = std::min(nearest_, distance_to_origin(x_before_, y_before_, x, y));
    x_before_ = x;
    y_before_ = y;
  }
  [[nodiscard]] double deviation() const { return nearest_; }

 private:
  double delay_;
  double nearest_;  ///< long before the corner the path lies on the first line
  double x_before_;
  double y_before_ = 0;
};

/// One axis while the runtime executes.
struct Followed {
  std::size_t axis = 0;
  std::optional<std::uint64_t> bound;  ///< of its settling; none beyond longest_settling
  std::uint64_t cycles = 0;            ///< after which its answer is known
  double dc_gain = 1;
  std::uint64_t settled = 0;
  double highest = 0;
  Corner corner;
};

Followed followed(ImageContents const& contents, std::size_t axis) {
  auto const chain = designs(contents.axes[axis]);
  ImageKernel const* const kernel = kernel_at_start(contents, axis);
  Followed each{.axis = axis,
                .bound = design::step_figures(chain, longest_settling, settled_within / 10).settling_cycles,
                .corner = Corner(contents.axes[axis].delay_cycles)};
  each.cycles =
      each.bound.value_or(longest_settling) + (kernel != nullptr ? kernel->design.tail_sums.size() : 0) + 1;
  for (design::FilterDesign const& filter : chain) each.dc_gain *= filter.dc_gain;
  return each;
}

/// Executes the chains of the axes at once, from rest at 0; `setpoint(n)` from cycle 0 on, `take(axis, n,
/// answer)` for as many cycles as the axis wants. The axes come by falling numbers of cycles.
template <class Setpoint, class Take>
void execute(RuntimeHost& host, std::vector<Followed*> const& axes, Setpoint setpoint, Take take) {
  std::vector<double> in(host.axis_count(), 0);
  std::vector<double> out(host.axis_count(), 0);
  static_cast<void>(host.reset_all(0));
  std::size_t left = axes.size();
  for (std::uint64_t n = 0;; ++n) {
    while (left > 0 && axes[left - 1]->cycles <= n) --left;
    if (left == 0) return;
    for (std::size_t i = 0; i < left; ++i) in[axes[i]->axis] = setpoint(n);
    static_cast<void>(host.step(in, out));
    for (std::size_t i = 0; i < left; ++i) take(*axes[i], n, out[axes[i]->axis]);
  }
}

ChainFigures figures_of(Followed const& each, double delay) {
  ChainFigures figures{.delay_cycles = delay,
                       .settling_cycles = std::nullopt,
                       .overshoot = 0,
                       .corner_deviation = std::nullopt};
  if (each.bound) figures.settling_cycles = each.settled;
  if (each.dc_gain > 0) figures.overshoot = std::max(0.0, (each.highest - each.dc_gain) / each.dc_gain);
  if (each.dc_gain == 1) figures.corner_deviation = each.corner.deviation();
  return figures;
}

}  // namespace

std::vector<ChainFigures> chain_figures(std::span<std::byte const> image, ImageContents const& contents,
                                        std::span<std::size_t const> axes) {
  std::vector<ChainFigures> figures;
  auto host = RuntimeHost::create(image);
  auto* const runtime = std::get_if<RuntimeHost>(&host);
  if (runtime == nullptr) {
    for (std::size_t const axis : axes) {
      figures.push_back({.delay_cycles = contents.axes[axis].delay_cycles,
                         .settling_cycles = std::nullopt,
                         .overshoot = 0,
                         .corner_deviation = std::nullopt});
    }
    return figures;
  }
  std::vector<Followed> all;
  all.reserve(axes.size());
  for (std::size_t const axis : axes) all.push_back(followed(contents, axis));
  std::vector<Followed*> by_cycles;
  for (Followed& each : all) by_cycles.push_back(&each);
  std::stable_sort(by_cycles.begin(), by_cycles.end(),
                   [](Followed const* a, Followed const* b) { return a->cycles > b->cycles; });

  execute(
      *runtime, by_cycles, [](std::uint64_t) { return 1.0; },
      [](Followed& each, std::uint64_t n, double answer) {
        if (!(std::abs(answer - each.dc_gain) <= settled_within)) each.settled = n + 1;
        each.highest = n == 0 ? answer : std::max(each.highest, answer);
      });
  std::erase_if(by_cycles, [](Followed const* each) { return each->dc_gain != 1; });
  execute(
      *runtime, by_cycles, [](std::uint64_t n) { return static_cast<double>(n); },
      [](Followed& each, std::uint64_t n, double answer) { each.corner.take(n, answer); });
  for (Followed const& each : all) {
    figures.push_back(figures_of(each, contents.axes[each.axis].delay_cycles));
  }
  return figures;
}

ChainFigures chain_figures(std::span<std::byte const> image, ImageContents const& contents,
                           std::size_t axis) {
  return chain_figures(image, contents, std::span(&axis, 1)).front();
}

bool reaches_peak_gain(ImageContents const& contents, std::size_t axis) {
  double const stated = contents.axes[axis].peak_gain;
  if (is_about(stated, 1)) return true;  // reached by a constant setpoint
  auto const chain = designs(contents.axes[axis]);
  if (chain.empty()) return true;
  return kernel_at_start(contents, axis) == nullptr && is_about(stated, summed_gain(chain));
}

bool reaches_peak_gain(ImageFilter const& filter) {
  return is_about(filter.peak_gain, summed_gain(std::span(&filter.design, 1)));
}

double chain_magnitude(ImageContents const& contents, std::size_t axis, design::Hertz frequency) {
  auto const chain = designs(contents.axes[axis]);
  double magnitude = design::chain_response(chain, frequency, contents.cycle_time).magnitude;
  if (ImageKernel const* const kernel = kernel_at_start(contents, axis)) {
    magnitude *= design::kernel_response(kernel->design, frequency, contents.cycle_time).magnitude;
  }
  return magnitude;
}

std::vector<design::Hertz> characteristic_frequencies(ImageContents const& contents, std::size_t axis) {
  std::vector<design::Hertz> frequencies;
  for (ImageFilter const& filter : contents.axes[axis].filters) {
    auto const& wanted = filter.specification;
    auto const& kind = design::kind_of(wanted.type);
    if (kind.uses_frequency) frequencies.push_back(wanted.frequency);
    if (kind.time_constant && kind.time_constant->meaning == design::TimeMeaning::lag) {
      frequencies.push_back({1e6 / (2 * std::numbers::pi * wanted.time_constant.value)});
    }
  }
  if (ImageKernel const* const kernel = kernel_at_start(contents, axis)) {
    auto const& wanted = kernel->specification;
    if (design::kind_of(wanted.type).uses_frequency) frequencies.push_back(wanted.frequency);
  }
  sort_frequencies(frequencies);
  return frequencies;
}

std::optional<double> decibels(double magnitude) {
  constexpr double nothing = 1e-15;
  if (magnitude < nothing) return std::nullopt;
  return 20 * std::log10(magnitude);
}

std::optional<design::Hertz> corner_frequency(ImageContents const& contents, std::size_t axis) {
  double const half_power = 1 / std::numbers::sqrt2;
  auto const passes = [&](double frequency) {
    return chain_magnitude(contents, axis, {frequency}) > half_power;
  };
  if (!passes(0)) return std::nullopt;
  // Notches are as narrow as they like, so their frequencies are looked at, too.
  constexpr int steps = 1000;
  constexpr double decades = 5;
  double const nyquist = 0.5 / contents.cycle_time.seconds();
  std::vector<design::Hertz> frequencies = characteristic_frequencies(contents, axis);
  for (int i = 0; i <= steps; ++i) {
    frequencies.push_back({nyquist * std::pow(10.0, decades * (static_cast<double>(i) / steps - 1))});
  }
  sort_frequencies(frequencies);
  double low = 0;
  for (design::Hertz const frequency : frequencies) {
    if (frequency.value > nyquist) break;
    if (passes(frequency.value)) {
      low = frequency.value;
      continue;
    }
    double high = frequency.value;
    constexpr double exact = 1e-12;
    while (high - low > exact * high) {
      double const middle = (low + high) / 2;
      (passes(middle) ? low : high) = middle;
    }
    return design::Hertz{high};
  }
  return std::nullopt;
}

void sort_frequencies(std::vector<design::Hertz>& frequencies) {
  auto const below = [](design::Hertz a, design::Hertz b) { return a.value < b.value; };
  auto const same = [](design::Hertz a, design::Hertz b) { return a.value == b.value; };
  std::sort(frequencies.begin(), frequencies.end(), below);
  frequencies.erase(std::unique(frequencies.begin(), frequencies.end(), same), frequencies.end());
}

}  // namespace axisc::image
