// The parts of a path that a search looks at.
//
// Where the velocity stays the same for longer than anything before or after matters, each axis is in its
// steady state: on a straight line the error stays the same, on an arc or helix it is a smooth function of
// the angle, of which a few places a turn are enough. So the cost of a search depends on how many blocks
// there are and how far they turn, not on how slowly they are passed. The proof looks at the parts that it
// leaves out.
#pragma once

#include "analysis/motion/path_trial.hpp"

#include <span>
#include <vector>

namespace axisc::motion {

/// Parts of `span`, in their order; `before` and `after` as in PathTrial.
[[nodiscard]] std::vector<TrialSpan> searched_spans(std::span<TimedPiece const> path, TrialSpan const& span,
                                                    double before, double after);

}  // namespace axisc::motion
