// Filters designed and evaluated in quadruple precision with textbook formulas, independent of the compiler's
// design.
#pragma once

#include "runtime/image_builder.hpp"
#include "runtime/quad.hpp"

#include <cstdint>
#include <deque>
#include <vector>

namespace axisc::test {

/// H(z) = (b0 + b1 z^-1 + b2 z^-2) / (1 + a1 z^-1 + a2 z^-2)
struct DirectSection {
  Quad b0 = 1, b1 = 0, b2 = 0, a1 = 0, a2 = 0;
};

/// A filter of a chain: sections, or a delay, and the share that goes through it.
struct ExactFilter {
  std::vector<DirectSection> sections;
  bool blocks_constant = false;
  std::uint32_t delay_cycles = 0;
  bool is_delay = false;
  double share = 1;

  /// The image's record of it: coefficients rounded once.
  [[nodiscard]] FilterRecord record() const;
};

/// Designs for a frequency f (Hz) and a cycle time T (s).
namespace exact {
[[nodiscard]] ExactFilter lowpass(Quad f, Quad T, Quad quality);
[[nodiscard]] ExactFilter highpass(Quad f, Quad T, Quad quality);
[[nodiscard]] ExactFilter bandpass(Quad f, Quad T, Quad quality);
[[nodiscard]] ExactFilter bandstop(Quad f, Quad T, Quad quality);
[[nodiscard]] ExactFilter allpass(Quad f, Quad T, Quad quality);
[[nodiscard]] ExactFilter pt1(Quad f, Quad T);
[[nodiscard]] ExactFilter pt2(Quad f, Quad T);
[[nodiscard]] ExactFilter first_order_highpass(Quad f, Quad T);
[[nodiscard]] ExactFilter first_order_allpass(Quad f, Quad T);
/// Butterworth prototype of order 3; the -3 dB bandwidth is f/quality.
[[nodiscard]] ExactFilter bandstop_of_order_3(Quad f, Quad T, Quad quality);
/// Thiran's all-pass of order 1 or 2 for a delay in cycles.
[[nodiscard]] ExactFilter thiran(int order, Quad delay);
[[nodiscard]] ExactFilter delay(std::uint32_t cycles);
[[nodiscard]] ExactFilter joined(ExactFilter first, ExactFilter const& second);
[[nodiscard]] ExactFilter with_share(ExactFilter filter, double share);
}  // namespace exact

/// The exact filter of the numbers that an image stores.
[[nodiscard]] ExactFilter stored_filter(FilterRecord const& record);

/// Runs filters in series, from the steady state for a position.
class ExactChain {
 public:
  ExactChain(std::vector<ExactFilter> filters, Quad position);
  [[nodiscard]] Quad step(Quad x);

 private:
  struct SectionState {
    Quad x1 = 0, x2 = 0, y1 = 0, y2 = 0;
  };
  struct FilterState {
    std::vector<SectionState> sections;
    std::deque<Quad> delayed;
  };
  std::vector<ExactFilter> filters_;
  std::vector<FilterState> states_;
};

}  // namespace axisc::test
