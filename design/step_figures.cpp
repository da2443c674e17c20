#include "design/filter_analysis.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

namespace axisc::design {
namespace {

/// What a filter hands on in a cycle: its output and the output's increment.
struct Signal {
  double value = 0;
  double increment = 0;
};

/// Bounds of what the states will still do without input.
struct Rest {
  double value = 0;  ///< to the output
  double path = 0;   ///< to the sum of the output's |increments|
};

/// By square root, which rounds alike on every host; hypot, which std::abs uses, does not, and images hold
/// peak gains.
double largest_radius(std::pair<std::complex<double>, std::complex<double>> const& poles) {
  return std::sqrt(std::max(std::norm(poles.first), std::norm(poles.second)));
}

/// The recursion of the increment form:
///     de = p d + r;  e += de;  r = de + q d - k e - b de
/// Left alone it is an oscillator, e' = v, v' = -b v - k (e + v), with the energy v² + k e².
class SectionState {
 public:
  explicit SectionState(IncrementSection const& section)
      : section_(section), reserve_(1 - largest_radius(poles(section))) {}

  double step(double d) {
    auto const [p, q, k, b] = section_;
    double const de = p * d + r_;
    e_ += de;
    r_ = de + q * d - k * e_ - b * de;
    return de;
  }
  [[nodiscard]] double excess() const { return e_; }

  void add_rest(Rest& rest) const {
    double const energy = r_ * r_ + section_.k * e_ * e_;
    rest.value += std::sqrt(energy / section_.k);
    rest.path += std::sqrt(energy) / std::max(reserve_, 1e-12);
  }

 private:
  IncrementSection section_;
  double reserve_;  ///< 1 - pole radius
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
      case Realisation::pass_through:
        return x;
      case Realisation::delay:
        return step_delay(x);
      case Realisation::sections:
        break;
    }
    return blocks_constant_ ? step_blocking(x) : step_unit(x);
  }

  void add_rest(Rest& rest) const {
    for (SectionState const& section : sections_) section.add_rest(rest);
    for (Signal const& delayed : line_) {
      rest.value += std::abs(delayed.increment);
      rest.path += std::abs(delayed.increment);
    }
  }

 private:
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

Rest rest_of(std::vector<FilterState> const& filters) {
  Rest rest;
  for (FilterState const& filter : filters) filter.add_rest(rest);
  return rest;
}

/// Rest below which nothing that is reported changes any more.
constexpr double settled_rest = 1e-13;
/// Where only one figure counts, as a share of what would change it: later filters may amplify what is left,
/// by far less than a hundred thousand.
constexpr double negligible_rest = 1e-5;
constexpr std::uint64_t cycles_between_checks = 32;

/// Looks at the step response until `is_enough(rest, excess)`, of which the latter is the largest above the
/// final value so far.
template <typename IsEnough>
StepFigures follow_step(std::span<FilterDesign const> chain, std::uint64_t longest, double tolerance,
                        IsEnough is_enough) {
  std::vector<FilterState> filters(chain.begin(), chain.end());
  double final_value = 1;
  for (FilterDesign const& filter : chain) final_value *= filter.dc_gain;

  StepFigures figures;
  double highest = 0;
  std::uint64_t& settling = figures.within_from;
  Rest rest;
  for (std::uint64_t n = 0; n < longest; ++n) {
    Signal y{1, n == 0 ? 1.0 : 0.0};
    for (FilterState& filter : filters) y = filter.step(y);
    figures.peak_gain += std::abs(y.increment);
    highest = std::max(highest, y.value);
    if (!(std::abs(y.value - final_value) <= tolerance)) settling = n + 1;
    if (n % cycles_between_checks == 0 || n + 1 == longest) {
      rest = rest_of(filters);
      if (is_enough(rest, highest - final_value)) break;
    }
  }
  if (final_value > 0) figures.overshoot = std::max(0.0, highest / final_value - 1);
  if (settling < longest && rest.value <= tolerance) figures.settling_cycles = settling;
  return figures;
}

}  // namespace

StepFigures step_figures(std::span<FilterDesign const> chain, std::uint64_t longest, double tolerance) {
  return follow_step(chain, longest, tolerance, [tolerance](Rest const& rest, double /*excess*/) {
    return rest.value <= std::min(settled_rest, tolerance) && rest.path <= settled_rest;
  });
}

double step_overshoot(std::span<FilterDesign const> chain, std::uint64_t longest) {
  auto const is_enough = [](Rest const& rest, double excess) {
    return rest.value <= std::max(settled_rest, negligible_rest * excess);
  };
  return follow_step(chain, longest, 0, is_enough).overshoot;
}

std::optional<std::uint64_t> settling_cycles(std::span<FilterDesign const> chain, std::uint64_t longest,
                                             double tolerance) {
  auto const is_enough = [tolerance](Rest const& rest, double /*excess*/) {
    return rest.value <= negligible_rest * tolerance;
  };
  std::uint64_t const within_from = follow_step(chain, longest, tolerance, is_enough).within_from;
  return within_from < longest ? std::optional(within_from) : std::nullopt;
}

}  // namespace axisc::design
