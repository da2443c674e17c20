// What people read about the keys of `motion` in axisc.json.
#pragma once

#include "analysis/comparison/motion/reading_combinations.hpp"
#include "diagnostics/sentence.hpp"

#include <cstddef>

namespace axisc {

/// What the readings of a key differ in, as a heading: no full stop.
[[nodiscard]] SentenceRef subject_of(comparison::MotionKey key);
/// What it takes to tell them apart: a motion, on axes that are as they must be.
[[nodiscard]] SentenceRef telling_motion_of(comparison::MotionKey key);

}  // namespace axisc
