#include "analysis/tuning/suggestion/candidates.hpp"

#include "analysis/tuning/suggestion/guard_candidates.hpp"
#include "design/filter_kinds.hpp"
#include "design/kernels/kernel_kinds.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <utility>

namespace axisc::tuning {
namespace {

using design::FilterSpecification;
using design::FilterType;
using design::KernelSpecification;
using design::KernelType;
using design::Prototype;

constexpr std::array gaussian_qualities = {1.0, 0.8, 0.6};
constexpr std::array sinc_cut_offs = {1.0 / 3, 0.5, 0.75, 1.0};  ///< as shares of a resonance
constexpr std::array novib_shifts = {0.9, 0.95, 1.0, 1.05, 1.1};
constexpr std::array band_qualities = {1.0, 1.5, 2.0, 3.0, 5.0, 10.0};
constexpr std::array prototypes = {Prototype::critical_damping, Prototype::butterworth, Prototype::bessel};
constexpr std::uint32_t low_pass_orders = 6;
constexpr std::uint32_t band_stop_orders = 3;
constexpr int cut_offs = 16;
constexpr double lowest_cut_off = 0.15;  ///< as shares of the lowest resonance
constexpr double highest_cut_off = 2;
/// As a share of half the sampling rate: above it the bilinear transform makes critically damped filters
/// overshoot.
constexpr double highest_low_pass = 0.2;

/// Lists show a tenth of a hertz.
design::Hertz rounded(double frequency) {
  return {std::round(frequency * 10) / 10};
}

/// A chain whose response is known.
struct ChainPart {
  Chain chain;
  std::shared_ptr<ImpulseResponse const> response;
  std::complex<double> gain = 1;  ///< on the circle
  ChainSummary summary = {};
};

std::vector<Chain> kernels(Task const& task) {
  std::vector<Chain> found;
  auto const add = [&](KernelSpecification const& kernel) {
    found.push_back({.filters = {}, .kernel = kernel});
  };
  for (std::uint32_t order = 2; order <= design::longest_kernel_order; order += 2) {
    add({.type = KernelType::moving_average, .order = order});
    for (double const quality : gaussian_qualities) {
      add({.type = KernelType::gaussian, .order = order, .quality = quality});
    }
    for (auto const& resonance : task.resonances) {
      for (double const share : sinc_cut_offs) {
        add({.type = KernelType::windowed_sinc,
             .order = order,
             .frequency = rounded(share * resonance.frequency)});
      }
    }
  }
  for (auto const& resonance : task.resonances) {
    for (double const shift : novib_shifts) {
      auto const frequency = rounded(shift * resonance.frequency);
      if (frequency < design::lowest_novib_frequency(task.cycle_time) ||
          !(frequency < task.cycle_time.nyquist())) {
        continue;
      }
      add({.type = KernelType::novib, .order = 1, .frequency = frequency});
    }
  }
  return found;
}

std::vector<Chain> low_passes(Task const& task) {
  double lowest = task.resonances.front().frequency;
  for (auto const& resonance : task.resonances) lowest = std::min(lowest, resonance.frequency);
  std::vector<Chain> found;
  for (std::uint32_t order = 1; order <= low_pass_orders; ++order) {
    for (int i = 0; i < cut_offs; ++i) {
      double const share = lowest_cut_off * std::pow(highest_cut_off / lowest_cut_off, i / (cut_offs - 1.0));
      auto const frequency = rounded(share * lowest);
      if (frequency.value <= 0 || frequency.value > highest_low_pass * task.cycle_time.nyquist().value) {
        continue;
      }
      found.push_back(
          {.filters = {{.type = FilterType::lowpass, .order = order, .frequency = frequency}}, .kernel = {}});
    }
  }
  return found;
}

std::vector<Chain> band_stops(Task const& task, Resonance const& resonance) {
  std::vector<Chain> found;
  auto const frequency = rounded(resonance.frequency);
  if (frequency.value <= 0 || !(frequency < task.cycle_time.nyquist())) return found;
  for (std::uint32_t order = 1; order <= band_stop_orders; ++order) {
    for (auto const prototype : prototypes) {
      // The prototypes of order 1 are the same.
      if (order == 1 && prototype != prototypes.front()) continue;
      for (double const quality : band_qualities) {
        found.push_back({.filters = {{.type = FilterType::bandstop,
                                      .prototype = prototype,
                                      .order = order,
                                      .frequency = frequency,
                                      .quality = quality}},
                         .kernel = {}});
      }
    }
  }
  return found;
}

class Enumerator {
 public:
  Enumerator(Task const& task, Judge const& judge)
      : task_(task),
        judge_(judge),
        theta_(task.velocity / task.radius),
        longest_(longest_delay / task.cycle_time.seconds()) {}

  Enumeration run() && {
    auto const whole_kernels = parts(kernels(task_));
    auto const lows = parts(low_passes(task_));
    std::vector<ChainPart> cascades = lows;
    for (auto const& kernel : whole_kernels) take(kernel);
    for (auto const& low : lows) take(low);
    for (auto first = lows.begin(); first != lows.end(); ++first) {
      for (auto second = first; second != lows.end(); ++second) take_series(*first, *second);
    }
    for (auto const& band : bands()) {
      take(band);
      if (band.chain.filters.size() + 1 <= most_filters && is_simple(band)) cascades.push_back(band);
    }
    auto const shapers = guards();
    for (auto const& guard : shapers) {
      take(guard);
      for (auto const& first : cascades) take_series(first, guard);
    }
    for (auto const& kernel : whole_kernels) {
      auto const type = kernel.chain.kernel->type;
      bool const is_slim = type == KernelType::moving_average ||
                           (type == KernelType::gaussian && kernel.chain.kernel->quality == 1);
      if (!is_slim || !is_cascaded(kernel.chain.kernel->order / 2)) continue;
      for (auto const& first : cascades) take_series(first, kernel);
    }
    return std::move(found_);
  }

 private:
  static constexpr std::size_t most_filters = 3;

  /// Chains as the control computes them, without those that it cannot.
  [[nodiscard]] std::vector<ChainPart> parts(std::vector<Chain> chains) const {
    if (task_.readings != design::Readings{}) {
      std::erase_if(chains, [this](Chain& chain) { return !read(chain); });
    }
    auto responses = impulse_responses(chains, task_.cycle_time);
    std::vector<ChainPart> found;
    for (std::size_t i = 0; i < chains.size(); ++i) {
      auto const on_circle = gain(responses[i], theta_);
      auto summary = judge_.summary(responses[i]);
      found.push_back({.chain = std::move(chains[i]),
                       .response = std::make_shared<ImpulseResponse const>(std::move(responses[i])),
                       .gain = on_circle,
                       .summary = std::move(summary)});
    }
    return found;
  }

  /// Of controls that have Vibration Guard.
  [[nodiscard]] std::vector<ChainPart> guards() const {
    if (task_.guards == Standing::unknown) return {};
    auto found = parts(guard_candidates(task_));
    std::erase_if(found, [this](ChainPart const& part) {
      return is_coarse(*part.chain.kernel, *part.response, task_.cycle_time);
    });
    return found;
  }

  /// False where no filter can be computed in the control's reading.
  [[nodiscard]] bool read(Chain& chain) const {
    if (has_guard(chain)) return true;
    auto const& readings = task_.readings;
    for (auto& filter : chain.filters) {
      filter.reading = readings.filters;
      filter.reading = design::applied_reading(filter);
      filter.cycle_time = readings.cycle_time;
      if (!design::is_in_range(filter, task_.cycle_time)) return false;
      auto const made = design::design_filter(filter, task_.cycle_time, design::Precision::quick);
      if (!std::all_of(made.sections.begin(), made.sections.end(), design::is_loadable)) return false;
    }
    if (!chain.kernel) return true;
    auto& kernel = *chain.kernel;
    kernel.reading = readings.kernels;
    kernel.cycle_time = readings.cycle_time;
    auto const computed_for = design::as_read(task_.cycle_time, readings.cycle_time);
    auto const& kind = design::kind_of(kernel.type);
    return kernel.order <= design::longest_order(kernel.type, kernel.reading) &&
           (!kind.uses_frequency || kernel.frequency < computed_for.nyquist()) &&
           (!kind.computes_order || kernel.frequency >= design::lowest_novib_frequency(computed_for));
  }

  /// Some of the wide kernels are as good as all: a step changes the width by 3 % or less.
  static bool is_cascaded(std::uint32_t half_width) {
    constexpr std::uint32_t all_below = 32;
    return half_width % (1 + half_width / all_below) == 0;
  }

  /// Band-stops of order 1: what cascades are made of.
  static bool is_simple(ChainPart const& part) {
    return std::all_of(part.chain.filters.begin(), part.chain.filters.end(),
                       [](FilterSpecification const& filter) { return filter.order == 1; });
  }

  /// Band-stops on one resonance, on two and on three.
  [[nodiscard]] std::vector<ChainPart> bands() const {
    std::vector<ChainPart> found;
    for (auto const& resonance : task_.resonances) {
      auto const here = parts(band_stops(task_, resonance));
      auto const before = found;
      for (auto const& band : here) {
        for (auto const& other : before) {
          if (!is_simple(band) || !is_simple(other) || other.chain.filters.size() >= most_filters) continue;
          // Cascades have one quality, so that there is one for each.
          if (other.chain.filters.front().quality != band.chain.filters.front().quality) continue;
          found.push_back(series(other, band));
        }
      }
      found.insert(found.end(), here.begin(), here.end());
    }
    return found;
  }

  static Chain joined(ChainPart const& first, ChainPart const& second) {
    Chain chain = first.chain;
    chain.filters.insert(chain.filters.end(), second.chain.filters.begin(), second.chain.filters.end());
    chain.kernel = second.chain.kernel;
    return chain;
  }
  [[nodiscard]] ChainPart series(ChainPart const& first, ChainPart const& second) const {
    auto response = std::make_shared<ImpulseResponse const>(in_series(*first.response, *second.response));
    auto summary = judge_.summary(*response);
    return {.chain = joined(first, second),
            .response = std::move(response),
            .gain = first.gain * second.gain,
            .summary = std::move(summary)};
  }

  /// Most chains deviate too much, which shows without their response.
  bool is_possible(std::complex<double> on_circle, double delay) {
    ++found_.looked_at;
    return task_.radius * std::abs(1 - std::abs(on_circle)) <= task_.tolerance && delay <= longest_;
  }

  [[nodiscard]] bool is_allowed(KernelType type) const {
    if (type == KernelType::vibration_guard) return task_.guards == Standing::allowed;
    bool const has_family = task_.family == machine::KernelFamily::fir
                                ? type != KernelType::novib
                                : type == KernelType::novib || type == KernelType::moving_average;
    return has_family && task_.kernels == Standing::allowed;
  }

  void add(Candidate candidate) {
    auto const& chain = candidate.chain;
    bool const has_band_stop =
        std::any_of(chain.filters.begin(), chain.filters.end(),
                    [](FilterSpecification const& filter) { return filter.type == FilterType::bandstop; });
    bool const has_kernel = !chain.kernel || is_allowed(chain.kernel->type);
    candidate.is_clean = !has_band_stop && has_kernel && candidate.figures.overshoot <= largest_overshoot;
    found_.candidates.push_back(std::move(candidate));
  }

  void take(ChainPart const& part) {
    if (!is_possible(part.gain, part.response->delay)) return;
    add({.chain = part.chain, .figures = judge_.estimate(*part.response), .first = part.response});
  }
  void take_series(ChainPart const& first, ChainPart const& second) {
    if (!is_possible(first.gain * second.gain, first.response->delay + second.response->delay)) return;
    bool const is_bounded = first.summary.is_positive && second.summary.is_positive;
    add({.chain = joined(first, second),
         .figures = is_bounded ? judge_.bound(first.summary, second.summary)
                               : judge_.estimate(in_series(*first.response, *second.response)),
         .is_estimated = !is_bounded,
         .first = first.response,
         .second = second.response});
  }

  Task const& task_;
  Judge const& judge_;
  double theta_;    ///< rad per cycle on the circle
  double longest_;  ///< delay in cycles
  Enumeration found_;
};

}  // namespace

namespace {

ImpulseResponse response_of(Candidate const& candidate) {
  return candidate.second ? in_series(*candidate.first, *candidate.second) : *candidate.first;
}

}  // namespace

void settle(Candidate& candidate, Judge const& judge) {
  if (candidate.is_settled) return;
  candidate.figures = judge.figures(response_of(candidate));
  candidate.is_estimated = candidate.is_settled = true;
}

void refine(Candidate& candidate, Judge const& judge) {
  if (candidate.is_estimated) return settle(candidate, judge);
  candidate.figures = judge.estimate(response_of(candidate));
  candidate.is_estimated = true;
}

Enumeration enumerate(Task const& task, Judge const& judge) {
  return Enumerator(task, judge).run();
}

}  // namespace axisc::tuning
