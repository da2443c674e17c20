// A chain of filters as plain numbers, run over a whole recording.
#pragma once

#include "design/filter_design.hpp"

#include <cstddef>
#include <span>
#include <vector>

namespace axisc::comparison {

/// From a given cycle of the recording on, a kernel has other taps; it fades over to them as the runtime
/// does.
struct Switch {
  std::size_t cycle = 0;
  std::vector<double> taps{};
  std::size_t fade_cycles = 0;
};

/// Either second-order sections with a share, or the taps of a kernel; taps take precedence.
struct Link {
  std::vector<design::IncrementSection> sections{};
  bool blocks_constant = false;
  double share = 1;  ///< of the sections; taps have theirs in them
  std::vector<double> taps{};
  std::vector<Switch> switches{};  ///< of taps, by rising cycle
};

using Chain = std::vector<Link>;

[[nodiscard]] Link link_of(design::FilterDesign const& filter);

/// Answers an input that comes piece by piece, from rest at its first value, which is that of cycle `first`
/// of the recording.
class Runner {
 public:
  explicit Runner(Chain chain, std::size_t first = 0);
  /// Replaces the next piece by its answer.
  void run(std::span<double> signal);

 private:
  struct State {
    double e = 0, r = 0;
  };
  struct Memory {
    std::vector<State> states{};
    double origin = 0;  ///< the first input
    double sum = 0, last = 0,
           passed = 0;  ///< sum of what sections have added, their last input, integral of blocking sections
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

/// The largest number of taps of a kernel and those it is switched to.
[[nodiscard]] std::size_t most_taps(Link const& link);

/// Cycles after which an unknown state has less than a millionth of its effect; at most 20000.
[[nodiscard]] std::size_t settling_cycles(Chain const& chain);

/// The factor by which the chain amplifies the rms of independent errors of its input.
[[nodiscard]] double noise_gain(Chain const& chain);

/// The factor by which the chain amplifies the largest error of its input at most, if all errors conspire:
/// the sum of the magnitudes of its impulse response; for switched kernels, the largest of these sums.
[[nodiscard]] double worst_gain(Chain const& chain);

}  // namespace axisc::comparison
