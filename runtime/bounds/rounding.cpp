#include "runtime/bounds/rounding.hpp"

#include "runtime/bounds/outward.hpp"
#include "runtime/limits.hpp"

namespace axisc::runtime::bounds {
namespace {

/// A runtime takes a p below 2^-44 and other numbers below 2^-62 as 0: then all of the product is the error.
double weight(double coefficient, double smallest, double roundings) {
  return magnitude(coefficient) < smallest ? roundings + 1 / unit_roundoff : roundings;
}

/// Roundings of  share a + direct b, and of `direct` itself.
struct ShareWeight {
  double share, direct;
};
constexpr double of_small_share = 0x1p-9;  ///< u times this is 2^-62

ShareWeight share_weight(FilterPart const& part, double of_direct) {
  if (!part.is_shared()) return {.share = 0, .direct = 0};
  return {.share = 4 * part.share + of_small_share, .direct = of_direct * part.direct + of_small_share};
}

/// Effects of errors behind the section or filter that is looked at.
struct Gains {
  double of_sum, of_d, of_position;
};

class RoundingSum {
 public:
  RoundingSum(Chain const& chain, SectionSizes const* sizes, Measure measure, Target target)
      : chain_(chain), sizes_(sizes), measure_(measure), gains_{target.of_sum, target.of_increment, 1} {}

  RoundingOfFilters all(Passing passing) {
    Passing before[most_filters + 1];
    before[0] = passing;
    for (uint32_t i = 0; i < chain_.filter_count; ++i) before[i + 1] = behind(chain_.filters[i], before[i]);
    for (uint32_t i = chain_.filter_count; i > 0; --i) {
      FilterPart const& part = chain_.filters[i - 1];
      if (part.delay > 0) {
        add_delay(part, before[i - 1]);
      } else {
        add_sections(part, before[i - 1]);
      }
    }
    return {.error = unit_roundoff * second_order * error_,
            .gain_of_d = gains_.of_d,
            .gain_of_sum = gains_.of_sum,
            .gain = gains_.of_position,
            .sum = before[chain_.filter_count].sum};
  }

 private:
  [[nodiscard]] double size(Size const& of) const { return of.*measure_; }
  /// Of x[n] - x[n-D]: D increments, or twice the distance from rest.
  [[nodiscard]] double path(uint32_t delay) const { return measure_ == &Size::increment ? delay : 2; }

  /// Behind the sections of a filter, before its share.
  [[nodiscard]] Passing filtered(FilterPart const& part, Passing before) const {
    uint32_t const last = part.first + part.count - 1;
    if (part.blocks_constant) return {.sum = size(sizes_[last].e), .d = size(sizes_[last].de)};
    Passing passing{.sum = before.sum, .d = size(sizes_[last].d) + size(sizes_[last].de)};
    for (uint32_t k = part.first; k <= last; ++k) passing.sum += size(sizes_[k].e);
    return passing;
  }

  [[nodiscard]] Passing behind(FilterPart const& part, Passing before) const {
    if (part.delay > 0) {
      double const both = part.share + part.direct;
      return {.sum = both * before.sum + part.direct * path(part.delay), .d = both * before.d};
    }
    Passing const within = filtered(part, before);
    return {.sum = part.share * within.sum + part.direct * before.sum,
            .d = part.share * within.d + part.direct * before.d};
  }

  void add_delay(FilterPart const& part, Passing before) {
    ShareWeight const roundings = share_weight(part, 5);
    double const both = roundings.share + roundings.direct;
    error_ += both * ((path(part.delay) + before.sum) * gains_.of_sum + before.d * gains_.of_d);
    double const passed = part.share + part.direct;
    gains_ = {gains_.of_sum * passed, gains_.of_d * passed, gains_.of_position * passed};
  }

  void add_sections(FilterPart const& part, Passing before) {
    Gains const behind = gains_;
    ShareWeight const roundings = share_weight(part, 4);
    Passing within = filtered(part, before);
    error_ += (roundings.share * within.sum + roundings.direct * before.sum) * behind.of_sum;
    error_ += (roundings.share * within.d + roundings.direct * before.d) * behind.of_d;
    gains_ = {part.share * behind.of_sum, part.share * behind.of_d, part.share * behind.of_position};
    uint32_t const end = part.first + part.count;
    for (uint32_t k = end; k > part.first; --k) {
      SectionSizes const& sizes = sizes_[k - 1];
      if (!part.blocks_constant) {
        error_ += within.sum * gains_.of_sum + (size(sizes.d) + size(sizes.de)) * gains_.of_d;
        within.sum -= size(sizes.e);
      }
      bool const adds_to_sum = !part.blocks_constant || k == end;
      add_section(chain_.sections[k - 1], sizes, adds_to_sum ? gains_.of_sum : 0);
    }
    gains_.of_sum = (part.blocks_constant ? 0 : gains_.of_sum) + part.direct * behind.of_sum;
    gains_.of_d += part.direct * behind.of_d;
    gains_.of_position += part.direct * behind.of_position;
  }

  void add_section(SectionBound const& section, SectionSizes const& sizes, double of_sum) {
    double const of_de = of_sum * section.rr + gains_.of_d * (1 + section.change);
    double const of_e = of_sum * (section.ee - 1) + gains_.of_d * section.re;
    double const of_r = of_sum * section.er + gains_.of_d * section.rr;
    double const G = magnitude(section.g) * size(sizes.d);
    double const K = section.k * size(sizes.e);
    double const B = section.b * size(sizes.de);
    double const product = weight(section.p, smallest_numerator, 1) * magnitude(section.p) * size(sizes.d);
    error_ += (product + size(sizes.de)) * of_de;
    error_ += size(sizes.e) * of_e;
    error_ += (weight(section.g, smallest_coefficient, 4) * G + 3 * K + 2 * B + size(sizes.r)) * of_r;
    gains_.of_d = of_sum * section.excess + section.passed * gains_.of_d;
    gains_.of_position *= section.passed;
  }

  Chain const& chain_;
  SectionSizes const* sizes_;
  Measure measure_;
  Gains gains_;
  double error_ = 0;
};

}  // namespace

RoundingOfFilters rounding_of_filters(Chain const& chain, SectionSizes const* sizes, Passing before,
                                      Measure measure, Target target) {
  return RoundingSum(chain, sizes, measure, target).all(before);
}

double rounding_error(Chain const& chain, KernelPart const& kernel, Response const& alone,
                      Response const& joint, Measure measure) {
  double const d = measure == &Size::increment ? 1 : 2;
  // Of E = S_0 d[n] + S_1 d[n-1] + ..., whether as a sum of products or as a moving average.
  double const of_kernel = (10.0 * kernel.count + 16) * kernel.tail_sum + 0x1p-60;
  if (kernel.count == 0) {
    RoundingOfFilters const filters = rounding_of_filters(chain, alone.sections, {0, d}, measure, {1, 0});
    return filters.error + unit_roundoff * second_order * d * filters.gain_of_d;
  }
  if (kernel.is_before) {
    Passing const before{.sum = kernel.tail_sum * d, .d = kernel.tap_sum * d};
    RoundingOfFilters const filters = rounding_of_filters(chain, joint.sections, before, measure, {1, 0});
    double const of_setpoint = kernel.tail_sum * filters.gain_of_sum + kernel.tap_sum * filters.gain_of_d;
    double const of_increment = (1 + 2 * kernel.tap_sum) * filters.gain_of_d;
    return filters.error + unit_roundoff * second_order * d *
                               (of_setpoint + of_kernel * filters.gain +
                                kernel.tail_sum * filters.gain_of_sum + of_increment);
  }
  RoundingOfFilters const filters =
      rounding_of_filters(chain, alone.sections, {0, d}, measure, {1, kernel.tail_sum});
  double const d_behind = alone.output.*measure;
  return filters.error +
         unit_roundoff * second_order *
             (d * filters.gain_of_d + of_kernel * d_behind + (filters.sum + kernel.tail_sum * d_behind));
}

}  // namespace axisc::runtime::bounds
