// A chain of filters as plain numbers, run over a whole recording.
#pragma once

#include "design/filter_design.hpp"

#include <cstddef>
#include <span>
#include <vector>

namespace axisc::comparison {

/// From a cycle of the recording on a kernel has other taps; it fades over to them as the runtime does.
struct Switch {
  std::size_t cycle = 0;
  std::vector<double> taps{};
  std::size_t fade_cycles = 0;
};

/// Either second-order sections with a share, or the taps of a kernel: those, where there are any.
struct Link {
  std::vector<design::IncrementSection> sections{};
  bool blocks_constant = false;
  double share = 1;  ///< of the sections; taps have theirs in them
  std::vector<double> taps{};
  std::vector<Switch> switches{};  ///< of taps, by rising cycle
};

using Chain = std::vector<Link>;

[[nodiscard]] Link link_of(design::FilterDesign const& filter);

/// Answers an input that comes piece by piece, from rest at its first value, which is that of cycle `first` of the recording.
class Runner {
 public:
  explicit Runner(Chain chain, std::size_t first = 0);
  /// The next piece becomes its answer.
  void run(std::span<double> signal);

 private:
  struct State {
    double e = 0, r = 0;
  };
  struct Memory {
    std::vector<State> states{};
    double origin = 0;  ///< the first input
    double sum = 0, last = 0,
           passed = 0;  ///< what sections have added, their last input, what blocking ones integrated
    std::vector<double> before{};  ///< inputs of all taps but the first one, from the origin
  };

  static void run_sections(Link const& link, Memory& memory, std::span<double> signal);
  void run_taps(Link const& link, Memory& memory, std::span<double> signal);
  void apply(std::vector<double> const& taps, double origin, std::size_t from,
             std::span<double> signal) const;

  Chain chain_;
  std::vector<Memory> memories_;
  bool is_running_ = false;
  std::size_t cycle_;  ///< of the next piece's first value
  std::vector<double> padded_, before_fade_;
};

/// The answer to `input`, from rest at its first value, that of cycle `first` of the recording.
[[nodiscard]] std::vector<double> respond(Chain const& chain, std::span<double const> input,
                                          std::size_t first = 0);

/// Of a kernel and whatever it is switched to.
[[nodiscard]] std::size_t most_taps(Link const& link);

/// Cycles after which a state that is not known has less than a millionth of its effect; at most 20000.
[[nodiscard]] std::size_t settling_cycles(Chain const& chain);

/// How many times as large errors of the input are behind the chain: their rms, where one is independent of the other.
[[nodiscard]] double noise_gain(Chain const& chain);

/// How many times as large as the largest error of the input its errors can become behind the chain, where all of them conspire:
/// the sum of the magnitudes of its answer to an impulse; of kernels that are switched, the largest of these sums.
[[nodiscard]] double worst_gain(Chain const& chain);

}  // namespace axisc::comparison
