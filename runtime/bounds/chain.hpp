// A chain of filters and its kernel, as an image stores them.
#pragma once

#include "runtime/bounds/section_bound.hpp"
#include "runtime/verification/image_view.hpp"

#include <stdint.h>

namespace axisc::runtime::bounds {

inline constexpr uint32_t most_filters = axim_most_filters;
inline constexpr uint32_t most_sections = most_filters * axim_most_sections;

/// A filter that changes the signal: sections from `first` on, or a delay where there are none.
struct FilterPart {
  uint32_t first, count;
  uint32_t delay;
  bool blocks_constant;
  double share, direct;
  [[nodiscard]] bool is_shared() const { return share != 1 && direct != 1; }
};

/// Filters in series.
struct Chain {
  FilterPart filters[most_filters];
  uint32_t filter_count;
  SectionBound sections[most_sections];
  uint32_t section_count;
  uint32_t delay_cycles;  ///< of all delays together
  double final_value;     ///< H(1): 1, or the product of the direct parts of filters that block it
  bool is_certain;        ///< every section shrinks
};

/// As an image stores it.
struct StoredSection {
  double p, q, k, b;
};

/// The signal that passes unchanged.
void clear(Chain& chain);
/// Puts a filter behind the others; `part` says how many sections there are. Cost: that of bound_section for
/// each.
void append(Chain& chain, FilterPart part, StoredSection const* sections);

/// Sections in use are those of the `count` filters from `first` on. Expects an image that was accepted.
/// Cost: that of bound_section for each section.
void read_chain(ImageView const& view, uint32_t first, uint32_t count, Chain& chain);

/// y[n] = x[n] - sum of S_j d[n-j]; no tails for the signal that passes unchanged.
struct KernelPart {
  Table<record::tail> tails;
  uint32_t first, count;
  bool is_before;   ///< the filters; otherwise behind them
  double tail_sum;  ///< sum of |S|, rounded upwards
  double tap_sum;   ///< sum of |b|, rounded upwards

  /// S_j; 0 beyond the last one.
  [[nodiscard]] double tail(uint32_t j) const { return j < count ? tails[first + j][field::tail::value] : 0; }
  /// b_j = S_(j-1) - S_j with S_(-1) = 1
  [[nodiscard]] double tap(uint32_t j) const { return (j == 0 ? 1 : tail(j - 1)) - tail(j); }
};

/// `kernel` may be AXIM_NONE.
[[nodiscard]] KernelPart read_kernel(ImageView const& view, uint32_t kernel, bool is_before);

}  // namespace axisc::runtime::bounds
