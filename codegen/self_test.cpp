#include "codegen/self_test.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>

#include <boost/multiprecision/cpp_bin_float.hpp>

namespace axisc::codegen {
namespace {

namespace mp = boost::multiprecision;

/// The number type of the expected outputs.
struct Extended {
  using Number = mp::number<mp::cpp_bin_float<50>, mp::et_off>;
  static Number multiply_add(Number const& a, Number const& b, Number const& c) { return a * b + c; }
};

/// A processor that rounds every operation.
struct Separate {
  using Number = double;
  static double multiply_add(double a, double b, double c) { return a * b + c; }
};

/// A processor that contracts multiplication and addition.
struct Fused {
  using Number = double;
  static double multiply_add(double a, double b, double c) { return std::fma(a, b, c); }
};

/// Output for `input` from the steady state for 0: the recursion of docs/image-format.md.
template <class Arithmetic>
class FilterModel {
 public:
  using Number = typename Arithmetic::Number;

  explicit FilterModel(design::FilterDesign const& filter)
      : filter_(filter), states_(filter.sections.size()), line_(filter.delay_cycles, Number(0)) {}

  std::vector<Number> run(std::vector<double> const& input) {
    std::vector<Number> output;
    output.reserve(input.size());
    for (double const x : input) output.push_back(step(Number(x)));
    return output;
  }

 private:
  struct State {
    Number r{0}, e{0};
  };

  Number step(Number const& x) {
    Number const share = filter_.share.filtered;
    Number const direct = filter_.share.direct;
    Number const direct_low = filter_.share.direct_low;
    switch (filter_.realisation) {
      case design::Realisation::sections: {
        Number const sum = step_sections(x);
        if (!filter_.blocks_constant) return Arithmetic::multiply_add(share, sum, x);
        return Arithmetic::multiply_add(share, sum, Arithmetic::multiply_add(direct, x, direct_low * x));
      }
      case design::Realisation::delay: {
        Number const delayed = std::exchange(line_[next_], x);
        next_ = (next_ + 1) % line_.size();
        return Arithmetic::multiply_add(direct + direct_low, x - delayed, delayed);
      }
      case design::Realisation::pass_through: break;
    }
    return x;
  }

  /// The cascade's contribution to x, or its replacement.
  Number step_sections(Number const& x) {
    Number d = x - previous_;
    Number sum(0);
    previous_ = x;
    for (std::size_t i = 0; i < states_.size(); ++i) {
      design::IncrementSection const& section = filter_.sections[i];
      State& state = states_[i];
      // As the runtime computes it: r += (p + q) d - k e - b de.
      Number const de = Arithmetic::multiply_add(section.p, d, state.r);
      state.e += de;
      Number change = (Number(section.p) + Number(section.q)) * d;
      change = Arithmetic::multiply_add(-section.k, state.e, change);
      state.r += Arithmetic::multiply_add(-section.b, de, change);
      d = filter_.blocks_constant ? de : Number(d + de);
      sum = filter_.blocks_constant ? state.e : Number(sum + state.e);
    }
    return sum;
  }

  design::FilterDesign const& filter_;
  std::vector<State> states_;
  std::vector<Number> line_;
  std::size_t next_ = 0;
  Number previous_{0};
};

/// Step, alternating ramp, rest, step to 1.
std::vector<double> test_input(std::size_t delay_cycles, double amplitude) {
  constexpr std::size_t step = 8;
  constexpr std::size_t ramp = 16;
  constexpr std::size_t rest = 7;
  std::vector<double> input(step, amplitude);
  for (std::size_t i = 1; i <= ramp; ++i) {
    double const height = amplitude * static_cast<double>(i) / ramp;
    input.push_back(i % 2 == 0 ? height : -height);
  }
  input.insert(input.end(), rest + delay_cycles, 0.0);
  input.push_back(1);
  return input;
}

SelfTest make_self_test(design::FilterDesign const& filter, double amplitude) {
  SelfTest test{.input = test_input(filter.delay_cycles, amplitude), .output = {}};
  for (Extended::Number const& y : FilterModel<Extended>(filter).run(test.input)) {
    test.output.push_back(static_cast<double>(y));
  }
  return test;
}

template <class Arithmetic>
double largest_error(design::FilterDesign const& filter, SelfTest const& test) {
  std::vector<double> const output = FilterModel<Arithmetic>(filter).run(test.input);
  double largest = 0;
  for (std::size_t i = 0; i < output.size(); ++i) {
    largest = std::max(largest, std::abs(output[i] - test.output[i]));
  }
  return largest;
}

}  // namespace

SelfTest make_self_test(design::FilterDesign const& filter) {
  constexpr double half_of_the_tolerance = std::numeric_limits<double>::epsilon();
  constexpr int attempts = 16;
  SelfTest best;
  double least_error = std::numeric_limits<double>::infinity();
  for (int attempt = 0; attempt < attempts && least_error > half_of_the_tolerance; ++attempt) {
    double const amplitude = (64 - attempt) * 0x1p-12;
    SelfTest test = make_self_test(filter, amplitude);
    double const error = std::max(largest_error<Separate>(filter, test), largest_error<Fused>(filter, test));
    if (error < least_error) {
      best = std::move(test);
      least_error = error;
    }
  }
  return best;
}

/// y[n] = x[n] - Σ S_j d[n-j]
SelfTest make_self_test(design::KernelDesign const& kernel) {
  constexpr double amplitude = 0x1p-6;
  using Number = Extended::Number;
  std::vector<double> const& tails = kernel.tail_sums;
  SelfTest test{.input = test_input(tails.size(), amplitude), .output = {}};
  std::vector<Number> exact_tails(tails.begin(), tails.end());
  // The input is nearly always constant: d is 0 then, and its products would change nothing.
  struct Increment {
    std::size_t cycle;
    Number d;
  };
  std::vector<Increment> increments;
  double before = 0;
  for (std::size_t n = 0; n < test.input.size(); ++n) {
    double const x = std::exchange(before, test.input[n]);
    if (test.input[n] != x) increments.push_back({.cycle = n, .d = Number(test.input[n]) - Number(x)});
  }
  for (std::size_t n = 0; n < test.input.size(); ++n) {
    Number y = test.input[n];
    // From the latest one on, as the runtime adds them up.
    for (std::size_t i = increments.size(); i-- > 0;) {
      auto const& [cycle, d] = increments[i];
      if (cycle > n || n - cycle >= tails.size()) continue;
      y -= exact_tails[n - cycle] * d;
    }
    test.output.push_back(static_cast<double>(y));
  }
  return test;
}

}  // namespace axisc::codegen
