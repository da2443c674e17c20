#include "design/filter_analysis.hpp"
#include "design/gain_bound.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

namespace axisc::design {
namespace {

constexpr std::uint64_t cycles_between_checks = 32;

/// The output of a filter in a cycle, and the output's increment.
struct Signal {
  double value = 0;
  double increment = 0;
};

/// Effects that the states will still have without input.
struct Rest {
  double value = 0;  ///< to the output, about
  double path = 0;   ///< to the sum of the output's |increments|, at most
};

/// Adds numbers of one sign with an error of two roundings, however many they are.
class CarefulSum {
 public:
  void add(double x) {
    double const sum = high_ + x;
    double const added = sum - high_;
    low_ += (high_ - (sum - added)) + (x - added);
    high_ = sum;
  }
  [[nodiscard]] double value() const { return high_ + low_; }

 private:
  double high_ = 0, low_ = 0;
};

/// The recursion of the increment form:
///     de = p d + r;  e += de;  r = de + q d - k e - b de
class SectionState {
 public:
  explicit SectionState(IncrementSection const& section) : section_(section) {}

  double step(double d) {
    auto const [p, q, k, b] = section_;
    double const de = p * d + r_;
    e_ += de;
    r_ = de + q * d - k * e_ - b * de;
    return de;
  }
  [[nodiscard]] double excess() const { return e_; }

  /// Left alone it is an oscillator, e' = v, v' = -b v - k (e + v), with the energy v² + k e².
  [[nodiscard]] double rest() const { return std::sqrt((r_ * r_ + section_.k * e_ * e_) / section_.k); }
  [[nodiscard]] double path(SectionGain const& gain) const {
    return std::abs(e_) * gain.per_e + std::abs(r_) * gain.per_r;
  }

 private:
  IncrementSection section_;
  double e_ = 0;
  double r_ = 0;
};

class FilterState {
 public:
  explicit FilterState(FilterDesign const& filter)
      : realisation_(filter.realisation),
        blocks_constant_(filter.blocks_constant),
        share_(filter.share),
        sections_(filter.sections.begin(), filter.sections.end()),
        line_(filter.delay_cycles) {}

  [[gnu::always_inline]] Signal step(Signal x) {
    switch (realisation_) {
      case Realisation::pass_through: return x;
      case Realisation::delay: return step_delay(x);
      case Realisation::sections: break;
    }
    return blocks_constant_ ? step_blocking(x) : step_unit(x);
  }

  [[nodiscard]] double rest() const {
    double rest = delayed_path();
    for (SectionState const& section : sections_) rest += section.rest();
    return rest;
  }

  /// Σ|increments| that are still to come after the filter, where `before` are still to come before it.
  [[nodiscard]] double path_behind(double before, FilterGain const& gain) const {
    if (realisation_ == Realisation::pass_through) return before;
    double within = before + delayed_path();
    for (std::size_t i = 0; i < sections_.size(); ++i) {
      within = within * gain.sections[i].passed + sections_[i].path(gain.sections[i]);
    }
    return share_.filtered * within + share_.direct * before;
  }

 private:
  [[nodiscard]] double delayed_path() const {
    double path = 0;
    for (Signal const& delayed : line_) path += std::abs(delayed.increment);
    return path;
  }

  Signal step_unit(Signal x) {
    double sum = 0, d = x.increment;
    for (SectionState& section : sections_) {
      d += section.step(d);
      sum += section.excess();
    }
    return {x.value + share_.filtered * sum, x.increment + share_.filtered * (d - x.increment)};
  }

  Signal step_blocking(Signal x) {
    double d = x.increment;
    for (SectionState& section : sections_) d = section.step(d);
    return {share_.direct * x.value + share_.filtered * sections_.back().excess(),
            share_.direct * x.increment + share_.filtered * d};
  }

  Signal step_delay(Signal x) {
    Signal const delayed = std::exchange(line_[next_], x);
    next_ = (next_ + 1) % line_.size();
    return {share_.direct * x.value + share_.filtered * delayed.value,
            share_.direct * x.increment + share_.filtered * delayed.increment};
  }

  Realisation realisation_;
  bool blocks_constant_;
  Share share_;
  std::vector<SectionState> sections_;
  std::vector<Signal> line_;  ///< ring of the last delay_cycles inputs
  std::size_t next_ = 0;
};

/// Bounds of Σ|h|, from a run in double that ends before the states are at rest.
class PathBound {
 public:
  explicit PathBound(std::span<FilterDesign const> chain) {
    for (FilterDesign const& filter : chain) {
      FilterGain const& gain = gains_.emplace_back(filter_gain(filter));
      rounding_ = rounding_ * gain.passed + passed_ * gain.rounding;
      passed_ *= gain.passed;
    }
  }

  /// Before the run began.
  [[nodiscard]] double rest() const { return passed_; }

  [[nodiscard]] double rest(std::vector<FilterState> const& filters) const {
    double path = 0;
    for (std::size_t i = 0; i < filters.size(); ++i) path = filters[i].path_behind(path, gains_[i]);
    return path;
  }

  /// The bound, from the sum of a run and what was still to come after it.
  [[nodiscard]] double above(double sum, double rest) const {
    constexpr double infinite = std::numeric_limits<double>::infinity();
    constexpr double of_sum = (cycles_between_checks + 4) * 0x1p-53;
    double const beyond = rounding_ + rest;
    if (beyond == 0) return sum;  // sums of 0 and 1
    double const bound = sum + (beyond * (1 + 0x1p-20) + sum * of_sum);
    return bound < infinite ? std::nextafter(bound, infinite) : infinite;
  }

 private:
  std::vector<FilterGain> gains_;
  double passed_ = 1;
  double rounding_ = 0;
};

/// Rest below which nothing that is reported changes any more.
constexpr double settled_rest = 1e-13;
/// Where only one figure counts, as a share of a change in that figure: later filters may amplify the rest,
/// by far less than a hundred thousand.
constexpr double negligible_rest = 1e-5;

double rest_of(std::vector<FilterState> const& filters) {
  double rest = 0;
  for (FilterState const& filter : filters) rest += filter.rest();
  return rest;
}

/// Follows the step response until `is_enough(rest, excess)`, where `excess` is the largest value above the
/// final one so far. Without a `bound` the rest of the path is not bounded.
template <typename IsEnough>
StepFigures follow_step(std::span<FilterDesign const> chain, std::uint64_t longest, double tolerance,
                        PathBound const* bound, IsEnough is_enough) {
  std::vector<FilterState> filters(chain.begin(), chain.end());
  double final_value = 1;
  for (FilterDesign const& filter : chain) final_value *= filter.dc_gain;

  StepFigures figures;
  double highest = 0;
  std::uint64_t& settling = figures.within_from;
  Rest rest{.value = 1, .path = bound != nullptr ? bound->rest() : 0};
  CarefulSum path;
  double path_since_check = 0;
  for (std::uint64_t n = 0; n < longest; ++n) {
    Signal y{1, n == 0 ? 1.0 : 0.0};
    for (FilterState& filter : filters) y = filter.step(y);
    path_since_check += std::abs(y.increment);
    highest = std::max(highest, y.value);
    if (!(std::abs(y.value - final_value) <= tolerance)) settling = n + 1;
    if (n % cycles_between_checks == 0 || n + 1 == longest) {
      path.add(path_since_check);
      path_since_check = 0;
      rest = {.value = rest_of(filters), .path = bound != nullptr ? bound->rest(filters) : 0};
      if (is_enough(rest, highest - final_value)) break;
    }
  }
  figures.peak_gain = path.value();
  if (bound != nullptr) figures.peak_gain_bound = bound->above(figures.peak_gain, rest.path);
  if (final_value > 0) figures.overshoot = std::max(0.0, highest / final_value - 1);
  if (settling < longest && rest.value <= tolerance) figures.settling_cycles = settling;
  return figures;
}

}  // namespace

StepFigures step_figures(std::span<FilterDesign const> chain, std::uint64_t longest, double tolerance) {
  PathBound const bound(chain);
  return follow_step(chain, longest, tolerance, &bound, [tolerance](Rest const& rest, double /*excess*/) {
    return rest.value <= std::min(settled_rest, tolerance) && rest.path <= settled_rest;
  });
}

double step_overshoot(std::span<FilterDesign const> chain, std::uint64_t longest) {
  auto const is_enough = [](Rest const& rest, double excess) {
    return rest.value <= std::max(settled_rest, negligible_rest * excess);
  };
  return follow_step(chain, longest, 0, nullptr, is_enough).overshoot;
}

std::optional<std::uint64_t> settling_cycles(std::span<FilterDesign const> chain, std::uint64_t longest,
                                             double tolerance) {
  auto const is_enough = [tolerance](Rest const& rest, double /*excess*/) {
    return rest.value <= negligible_rest * tolerance;
  };
  std::uint64_t const within_from = follow_step(chain, longest, tolerance, nullptr, is_enough).within_from;
  return within_from < longest ? std::optional(within_from) : std::nullopt;
}

}  // namespace axisc::design
