// The distance of samples.
#pragma once

#include "analysis/recordings/signal.hpp"

namespace axisc::recordings {

/// The median difference of successive times, or the mean of those that are within half of the median,
/// because times are rounded when they are written; 0 of fewer than two times. Of a long recording, every so
/// many differences are taken, 100,000 at most.
[[nodiscard]] double usual_step(Signal const& times);

}  // namespace axisc::recordings
