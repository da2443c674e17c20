// B4: how far the executed filter is from the exact one.
//
// An operation errs by at most u times what it gives. With "size" the most that its signal reaches, and
// "gain" what an error of one unit in every cycle does to the end of the chain,
//
//     E = u sum over all operations of gain * size.
//
// Operations of a section, with the sizes D, DE, E, R of d, de, e, r and G = |g| D, K = |k| E, B = |b| DE:
//
//     operation               size                                       to the sum   to later sections
//     de = p d + r            |p| D + DE                                 rr           1 + change
//     e += de                 E                                          ee - 1       re
//     r += g d - k e - b de   2 G + K + (G + K) + B + (G + K + B) + R    er           rr
//     d += de,  sum += e      the sizes of both, where the section passes the constant part
//
// (g itself was rounded.) ee, re, er, rr and change are sums over all cycles of what the states (e, r) do
// (section_bound.hpp): an error of e is A (1, 0) then, without the first term of its sum; one of de is the
// difference of A (0, 1) and (0, 1). Where a processor contracts multiplications and additions, some of these
// roundings do not happen.
#pragma once

#include "runtime/bounds/response.hpp"

#include <stdint.h>

namespace axisc::runtime::bounds {

/// Which of the two sizes: for every unit of the largest increment, or of the largest distance from rest.
using Measure = double Size::*;

/// What is asked for: errors of the output, or the sum of the errors of its increments.
struct Target {
  double of_sum;        ///< 1, or 0
  double of_increment;  ///< effect of an error in the increment behind the chain
};

struct RoundingOfFilters {
  double error;        ///< E of all operations from the first section on
  double gain_of_d;    ///< effect of an error of the increment before the chain
  double gain_of_sum;  ///< of the sum before the chain
  double gain;         ///< of an error of the setpoint itself: sum of |h|, section after section
  double sum;          ///< size of the sum behind the chain
};

/// Sizes of what is already added to the setpoint, and of its increment.
struct Passing {
  double sum, d;
};

/// `before`: what enters the chain.
[[nodiscard]] RoundingOfFilters rounding_of_filters(Chain const& chain, SectionSizes const* sizes,
                                                    Passing before, Measure measure, Target target);

/// E of the chain as the runtime executes it. `alone` is the response of the filters without a kernel,
/// `joint` that with it; for a kernel before the filters the latter counts.
[[nodiscard]] double rounding_error(Chain const& chain, KernelPart const& kernel, Response const& alone,
                                    Response const& joint, Measure measure);

}  // namespace axisc::runtime::bounds
