// The standard filter types, a row each: which parameters a type uses, in which ranges, and what follows from
// the type alone (manual "axis filters", sections 2.1 and 3).
//
// A new type is an enumerator with its number in filter_specification.hpp, a row here and its mathematics in
// filter_realisations_def.hpp; a row without mathematics does not compile.
#pragma once

#include "design/filter_specification.hpp"
#include "design/kernels/kernel_design.hpp"

#include <array>
#include <cassert>
#include <cstdint>
#include <limits>
#include <optional>
#include <string_view>

namespace axisc::design {

/// Where a type has its order from.
enum class OrderSource : std::uint8_t {
  configured,  ///< `order`, 1 to the highest
  fixed,       ///< the type: always the highest; `order` only switches the filter on
  computed,    ///< the time constant; `order` only switches the filter on
};

struct OrderRange {
  OrderSource source = OrderSource::configured;
  std::uint32_t highest = 0;  ///< 0 where computed

  /// For an active filter, so that 0 does not fit.
  [[nodiscard]] constexpr bool fits(double order) const {
    return order >= 1 && (source != OrderSource::configured || order <= highest);
  }
};

/// Both ends belong to it.
struct QualityRange {
  double lowest = 0;
  double highest = 0;

  [[nodiscard]] constexpr bool fits(double quality) const { return quality >= lowest && quality <= highest; }
};

enum class TimeMeaning : std::uint8_t {
  lag,    ///< τ of poles at -1/τ, with the cut-off frequency 1/(2π τ)
  delay,  ///< the delay itself
};

/// In cycles: `lowest` belongs to it, `limit` does not.
struct TimeConstantRange {
  TimeMeaning meaning = TimeMeaning::lag;
  double lowest = 0;
  double limit = std::numeric_limits<double>::infinity();

  [[nodiscard]] constexpr bool fits(double cycles) const { return cycles >= lowest && cycles < limit; }
};

/// A type without one of the optional values ignores the parameter.
struct FilterKind {
  FilterType type;
  std::string_view word;  ///< the symbol of P-AXIS-00204
  bool uses_prototype = false;
  bool uses_frequency = false;  ///< fg_f0: 0 < f < 0.5/T
  OrderRange order;
  std::optional<QualityRange> quality{};  ///< guete
  std::optional<TimeConstantRange> time_constant{};
  bool blocks_constant = false;  ///< H(1) = 0, else H(1) = 1
};

namespace detail {

inline constexpr OrderRange up_to_6{OrderSource::configured, 6};
/// The order of the prototype: a band filter of order n has 2n poles.
inline constexpr OrderRange up_to_3{OrderSource::configured, 3};
inline constexpr QualityRange band_quality{1, 10};
inline constexpr TimeConstantRange lag{TimeMeaning::lag, 1};
inline constexpr TimeConstantRange short_delay{TimeMeaning::delay, 0, 6};

}  // namespace detail

/// By rising number.
// clang-format off
inline constexpr std::array filter_kinds{
    FilterKind{.type = FilterType::lowpass, .word = "LOWPASS", .uses_prototype = true, .uses_frequency = true,
               .order = detail::up_to_6},
    FilterKind{.type = FilterType::highpass, .word = "HIGHPASS", .uses_prototype = true, .uses_frequency = true,
               .order = detail::up_to_6, .blocks_constant = true},
    FilterKind{.type = FilterType::bandpass, .word = "BANDPASS", .uses_prototype = true, .uses_frequency = true,
               .order = detail::up_to_3, .quality = detail::band_quality, .blocks_constant = true},
    FilterKind{.type = FilterType::bandstop, .word = "BANDSTOP", .uses_prototype = true, .uses_frequency = true,
               .order = detail::up_to_3, .quality = detail::band_quality},
    FilterKind{.type = FilterType::allpass, .word = "ALLPASS", .uses_prototype = true, .uses_frequency = true,
               .order = detail::up_to_6},
    FilterKind{.type = FilterType::pt1, .word = "PT1", .order = {OrderSource::fixed, 1},
               .time_constant = detail::lag},
    FilterKind{.type = FilterType::pt2, .word = "PT2", .order = {OrderSource::fixed, 2},
               .time_constant = detail::lag},
    FilterKind{.type = FilterType::time_delay, .word = "TIME_DELAY", .order = {OrderSource::computed},
               .time_constant = detail::short_delay},
};
// clang-format on

/// The prototype, P-AXIS-00153, with which a filter[i] is an HSC filter: a linear-phase kernel that programs
/// switch on.
inline constexpr int hsc_prototype = 5;

/// Values are the numbers of P-AXIS-00204.
enum class HscType : std::uint8_t { mean = 8, novib = 12 };

/// The values that an HSC type uses besides prototype, order, share and time constant. Its order is 0 to
/// longest_kernel_order.
struct HscKind {
  HscType type;
  KernelType kernel;
  bool uses_frequency = false;  ///< fg_f0: 0 < f < 0.5/T
};

inline constexpr std::array hsc_kinds{
    HscKind{.type = HscType::mean, .kernel = KernelType::moving_average},
    HscKind{.type = HscType::novib, .kernel = KernelType::novib, .uses_frequency = true},
};

/// The row of a number of P-AXIS-00204; null for all others.
[[nodiscard]] constexpr HscKind const* find_hsc_kind(int number) {
  for (HscKind const& kind : hsc_kinds) {
    if (static_cast<int>(kind.type) == number) return &kind;
  }
  return nullptr;
}

/// The row of a number of P-AXIS-00204; null for HSC filters and undocumented types.
[[nodiscard]] constexpr FilterKind const* find_filter_kind(int number) {
  for (FilterKind const& kind : filter_kinds) {
    if (static_cast<int>(kind.type) == number) return &kind;
  }
  return nullptr;
}
/// The row of an enumerator, which every one has; other numbers are not allowed.
[[nodiscard]] constexpr FilterKind const& kind_of(FilterType type) {
  // By index: with -fsanitize=undefined g++ takes no comparison of pointers for a constant.
  std::size_t at = 0;
  while (at + 1 < filter_kinds.size() && filter_kinds[at].type != type) ++at;
  assert(filter_kinds[at].type == type);
  return filter_kinds[at];
}

// May be called with any number that an image holds: without a row nothing is used.
[[nodiscard]] constexpr bool uses_frequency(FilterType type) {
  FilterKind const* const kind = find_filter_kind(static_cast<int>(type));
  return kind != nullptr && kind->uses_frequency;
}
[[nodiscard]] constexpr bool uses_prototype(FilterType type) {
  FilterKind const* const kind = find_filter_kind(static_cast<int>(type));
  return kind != nullptr && kind->uses_prototype;
}
[[nodiscard]] constexpr bool uses_quality(FilterType type) {
  FilterKind const* const kind = find_filter_kind(static_cast<int>(type));
  return kind != nullptr && kind->quality;
}
[[nodiscard]] constexpr bool uses_time_constant(FilterType type) {
  FilterKind const* const kind = find_filter_kind(static_cast<int>(type));
  return kind != nullptr && kind->time_constant;
}
/// PT1 and PT2 have the order of their type, TIME_DELAY that of its time constant.
[[nodiscard]] constexpr bool computes_order(FilterType type) {
  FilterKind const* const kind = find_filter_kind(static_cast<int>(type));
  return kind != nullptr && kind->order.source != OrderSource::configured;
}

/// All values that the type uses, and the share, are in their ranges: what design_filter() expects.
[[nodiscard]] bool is_in_range(FilterSpecification const& specification, CycleTime cycle_time);

}  // namespace axisc::design
