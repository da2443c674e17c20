#include "analysis/tuning/identification/ring_down.hpp"

#include "analysis/motion/statistics.hpp"
#include "analysis/tuning/identification/fourier.hpp"
#include "analysis/tuning/identification/simplex.hpp"
#include "analysis/tuning/identification/thresholds.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>
#include <numeric>

namespace axisc::tuning {
namespace {

constexpr std::size_t most_rests = 40;
constexpr double longest_window = 1;  ///< s
constexpr std::size_t most_starts = 3;
constexpr std::size_t groups = 6;  ///< of the jackknife

/// In logarithms, so that none becomes negative.
using Decays = std::array<double, 2>;  ///< τ1, τ2 in s
using Poles = std::array<double, 4>;   ///< f in Hz, D, τ1, τ2

/// What is looked at together: the beginnings of some rests.
struct Windows {
  std::vector<SteadySignal const*> rests;
  double seconds = 0;
};

class Basis {
 public:
  Basis(std::size_t count, double sampling_rate) : count_(count), rate_(sampling_rate) {
    add([](double) { return 1.0; });
  }

  template <class Function>
  void add(Function function) {
    std::vector<double> column(count_);
    double before = 0;
    for (std::size_t n = 0; n < count_; ++n) {
      column[n] = function(static_cast<double>(n) / rate_);
      before += column[n] * column[n];
    }
    for (auto const& one : columns_) {
      double const product = std::inner_product(one.begin(), one.end(), column.begin(), 0.0);
      for (std::size_t n = 0; n < count_; ++n) column[n] -= product * one[n];
    }
    double const square = std::inner_product(column.begin(), column.end(), column.begin(), 0.0);
    constexpr double independent = 1e-12;
    if (!(square > independent * before)) return;
    for (double& value : column) value /= std::sqrt(square);
    columns_.push_back(std::move(column));
  }

  void add_decay(double seconds) {
    add([seconds](double t) { return std::exp(-t / seconds); });
  }

  /// What the columns leave of a rest.
  [[nodiscard]] std::vector<double> left_of(SteadySignal const& rest) const {
    std::vector<double> left(rest.values.begin(), rest.values.begin() + static_cast<std::ptrdiff_t>(count_));
    for (auto const& one : columns_) {
      double const product = std::inner_product(one.begin(), one.end(), left.begin(), 0.0);
      for (std::size_t n = 0; n < count_; ++n) left[n] -= product * one[n];
    }
    return left;
  }

 private:
  std::size_t count_;
  double rate_;
  std::vector<std::vector<double>> columns_;
};

double energy(std::vector<double> const& values) {
  return std::inner_product(values.begin(), values.end(), values.begin(), 0.0);
}

/// `extend` adds columns to the basis of each sampling rate; the energy that is left of all rests.
template <class Extend>
double left_energy(Windows const& windows, Extend extend) {
  std::map<double, Basis> bases;
  double sum = 0;
  for (auto const* const rest : windows.rests) {
    auto found = bases.find(rest->sampling_rate);
    if (found == bases.end()) {
      auto const count = static_cast<std::size_t>(windows.seconds * rest->sampling_rate);
      found = bases.emplace(rest->sampling_rate, Basis(count, rest->sampling_rate)).first;
      extend(found->second);
    }
    sum += energy(found->second.left_of(*rest));
  }
  return sum;
}

void add_decays(Basis& basis, double tau1, double tau2) {
  basis.add_decay(tau1);
  basis.add_decay(tau2);
}

void add_sine(Basis& basis, double frequency, double damping) {
  double const omega = 2 * std::numbers::pi * frequency;
  double const damped = omega * std::sqrt(1 - damping * damping);
  basis.add([=](double t) { return std::exp(-damping * omega * t) * std::cos(damped * t); });
  basis.add([=](double t) { return std::exp(-damping * omega * t) * std::sin(damped * t); });
}

bool is_decay(double seconds, Windows const& windows) {
  constexpr double fastest = 200;
  constexpr double slowest = 5;
  return seconds > windows.seconds / fastest && seconds < slowest * windows.seconds;
}

double left_by_decays(Windows const& windows, Decays const& decays) {
  double const tau1 = std::exp(decays[0]), tau2 = std::exp(decays[1]);
  if (!is_decay(tau1, windows) || !is_decay(tau2, windows)) return std::numeric_limits<double>::max();
  return left_energy(windows, [&](Basis& basis) { add_decays(basis, tau1, tau2); });
}

Minimum<2> best_decays(Windows const& windows) {
  constexpr std::array shares{0.01, 0.03, 0.1, 0.3, 1.0, 3.0};
  auto const function = [&](Decays const& decays) { return left_by_decays(windows, decays); };
  Minimum<2> best{.place = {}, .value = std::numeric_limits<double>::max()};
  for (std::size_t i = 0; i < shares.size(); ++i) {
    for (std::size_t k = i + 1; k < shares.size(); ++k) {
      Decays const place{std::log(shares.at(i) * windows.seconds), std::log(shares.at(k) * windows.seconds)};
      double const value = function(place);
      if (value < best.value) best = {.place = place, .value = value};
    }
  }
  constexpr std::size_t evaluations = 80;
  return smallest<2>(function, best.place, {0.4, 0.4}, evaluations);
}

double left_by_all(Windows const& windows, Poles const& poles, double highest) {
  double const frequency = std::exp(poles[0]), damping = std::exp(poles[1]);
  double const tau1 = std::exp(poles[2]), tau2 = std::exp(poles[3]);
  constexpr double strongest = 0.7;
  bool const is_allowed = frequency < highest && frequency * windows.seconds > 1 && damping < strongest &&
                          is_decay(tau1, windows) && is_decay(tau2, windows);
  if (!is_allowed) return std::numeric_limits<double>::max();
  return left_energy(windows, [&](Basis& basis) {
    add_decays(basis, tau1, tau2);
    add_sine(basis, frequency, damping);
  });
}

/// The strongest frequencies in what decays leave.
std::vector<double> starts(Windows const& windows, Decays const& decays, double highest) {
  double const step = 0.25 / windows.seconds;
  auto const count = static_cast<std::size_t>(highest / step);
  std::vector<double> power(count);
  for (auto const* const rest : windows.rests) {
    double const rate = rest->sampling_rate;
    Basis basis(static_cast<std::size_t>(windows.seconds * rate), rate);
    add_decays(basis, std::exp(decays[0]), std::exp(decays[1]));
    auto const left = basis.left_of(*rest);
    std::size_t const size = std::bit_ceil(4 * left.size());
    std::vector<std::complex<double>> values(left.begin(), left.end());
    values.resize(size);
    transform(values);
    for (std::size_t i = 0; i < count; ++i) {
      double const bin = static_cast<double>(i) * step / rate * static_cast<double>(size);
      power[i] += std::norm(values[std::min(size / 2, static_cast<std::size_t>(std::lround(bin)))]);
    }
  }
  std::vector<std::size_t> tops;
  auto const lowest = static_cast<std::size_t>(fewest_periods / windows.seconds / step) / 2;
  for (std::size_t i = std::max<std::size_t>(1, lowest); i + 1 < count; ++i) {
    if (power[i] >= power[i - 1] && power[i] > power[i + 1]) tops.push_back(i);
  }
  std::sort(tops.begin(), tops.end(), [&](std::size_t a, std::size_t b) { return power[a] > power[b]; });
  if (tops.size() > most_starts) tops.resize(most_starts);
  std::vector<double> frequencies;
  frequencies.reserve(tops.size());
  for (auto const top : tops) frequencies.push_back(static_cast<double>(top) * step);
  return frequencies;
}

constexpr Poles steps{0.02, 0.4, 0.3, 0.3};

Minimum<4> refined(Windows const& windows, Poles const& start, double highest, std::size_t evaluations) {
  return smallest<4>([&](Poles const& poles) { return left_by_all(windows, poles, highest); }, start, steps,
                     evaluations);
}

std::optional<Minimum<4>> best_poles(Windows const& windows, Decays const& decays, double highest) {
  constexpr std::array dampings{0.02, 0.1};
  constexpr std::size_t few = 60;
  constexpr std::size_t many = 300;
  std::optional<Minimum<4>> best;
  for (double const frequency : starts(windows, decays, highest)) {
    for (double const damping : dampings) {
      Poles const start{std::log(frequency), std::log(damping), decays[0], decays[1]};
      auto const found = refined(windows, start, highest, few);
      if (!best || found.value < best->value) best = found;
    }
  }
  return best ? std::optional(refined(windows, best->place, highest, many)) : std::nullopt;
}

/// Every `count`-th rest from `first` on, or all but these.
Windows part_of(Windows const& windows, std::size_t first, std::size_t count, bool is_left_out) {
  Windows part{.rests = {}, .seconds = windows.seconds};
  for (std::size_t i = 0; i < windows.rests.size(); ++i) {
    if ((i % count == first) != is_left_out) part.rests.push_back(windows.rests[i]);
  }
  return part;
}

/// Standard errors by leaving out a group of rests after the other (jackknife).
void add_uncertainty(RingDown& found, Windows const& windows, Poles const& poles, double highest) {
  constexpr std::size_t evaluations = 120;
  std::size_t const count = std::min(groups, windows.rests.size());
  std::vector<double> frequencies, dampings;
  for (std::size_t i = 0; i < count; ++i) {
    auto const without = refined(part_of(windows, i, count, true), poles, highest, evaluations);
    frequencies.push_back(std::exp(without.place[0]));
    dampings.push_back(std::exp(without.place[1]));
  }
  auto const error = [count](std::vector<double> const& values) {
    auto const n = static_cast<double>(count);
    double const mean = motion::mean(values);
    double sum = 0;
    for (double const value : values) sum += (value - mean) * (value - mean);
    return std::sqrt(sum * (n - 1) / n);
  };
  // A few rests that happen to agree say little, and a strongly damped sine can hardly be told from decays.
  constexpr double smallest_share = 0.005;
  constexpr double smallest_damping_share = 0.05;
  double const share = std::max(smallest_share, found.damping * found.damping);
  found.frequency_uncertainty = std::max(error(frequencies), share * found.frequency);
  found.damping_uncertainty = std::max(error(dampings), smallest_damping_share * found.damping);
}

std::variant<RingDown, BadRingDown> search(Windows const& windows, double highest) {
  double rate = windows.rests.front()->sampling_rate;
  for (auto const* const rest : windows.rests) rate = std::min(rate, rest->sampling_rate);
  highest = std::min(highest, highest_share * rate);
  double const settling = left_energy(windows, [](Basis&) {});
  if (!(settling > 0)) return BadRingDown{.doubt = RingDownDoubt::no_oscillation};
  auto const decays = best_decays(windows);
  auto const best = best_poles(windows, decays.place, highest);
  if (!best) return BadRingDown{.doubt = RingDownDoubt::no_oscillation};
  RingDown found{.frequency = std::exp(best->place[0]), .damping = std::exp(best->place[1])};
  auto const bad = [&](RingDownDoubt doubt) {
    bool const is_named = doubt != RingDownDoubt::no_oscillation;
    return BadRingDown{.doubt = doubt, .frequency = is_named ? found.frequency : 0};
  };
  double const explained = decays.value - best->value;
  bool const oscillates = explained >= least_explained * decays.value &&
                          explained >= least_of_settling * settling && found.damping <= largest_damping;
  if (!oscillates) return bad(RingDownDoubt::no_oscillation);
  double const decay = found.damping * 2 * std::numbers::pi * found.frequency * windows.seconds;
  if (std::exp(-decay) > largest_remainder) return bad(RingDownDoubt::keeps_on);
  if (found.frequency * windows.seconds < fewest_periods) return bad(RingDownDoubt::few_periods);
  constexpr std::size_t evaluations = 200;
  std::array<double, 2> halves{};
  for (std::size_t i = 0; i < halves.size(); ++i) {
    halves.at(i) = std::exp(
        refined(part_of(windows, i, halves.size(), false), best->place, highest, evaluations).place[0]);
  }
  if (std::abs(halves[0] - halves[1]) > largest_half_difference * found.frequency) {
    return bad(RingDownDoubt::halves_disagree);
  }
  add_uncertainty(found, windows, best->place, highest);
  return found;
}

}  // namespace

std::variant<RingDown, BadRingDown> ring_down(std::span<SteadySignal const> rests, double highest) {
  std::vector<double> lengths;
  auto const seconds_of = [](SteadySignal const& rest) {
    return static_cast<double>(rest.values.size()) / rest.sampling_rate;
  };
  for (auto const& rest : rests) lengths.push_back(seconds_of(rest));
  if (lengths.size() < fewest_rests) return BadRingDown{};
  std::sort(lengths.begin(), lengths.end());
  // Three quarters of the rests are at least so long.
  double const common = lengths[std::min(lengths.size() / 4, lengths.size() - fewest_rests)];
  std::optional<BadRingDown> bad;
  // A short window has less of the noise that is left when the oscillation has died away.
  double seconds = std::min(common, longest_window);
  constexpr std::size_t windows_tried = 3;
  auto const is_enough = [&] {
    return seconds >= shortest_rest && std::all_of(rests.begin(), rests.end(), [&](SteadySignal const& rest) {
             return seconds * rest.sampling_rate >= static_cast<double>(fewest_rest_samples);
           });
  };
  for (std::size_t i = 0; i < windows_tried && is_enough(); ++i, seconds /= 2) {
    Windows windows{.rests = {}, .seconds = seconds};
    for (auto const& rest : rests) {
      if (seconds_of(rest) >= seconds && windows.rests.size() < most_rests) windows.rests.push_back(&rest);
    }
    auto found = search(windows, highest);
    if (std::holds_alternative<RingDown>(found)) return found;
    auto const& why = std::get<BadRingDown>(found);
    // In a shorter window what keeps on would look like something else.
    if (why.doubt == RingDownDoubt::keeps_on) return why;
    if (!bad || bad->doubt == RingDownDoubt::no_oscillation) bad = why;
  }
  return bad.value_or(BadRingDown{});
}

}  // namespace axisc::tuning
