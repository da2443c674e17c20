// Whether a control plans a program's path as axisc does, and in which readings.
#pragma once

#include "axisc/answers/comparison/motion_recording.hpp"
#include "presentation/document.hpp"

#include <optional>
#include <string>
#include <vector>

namespace axisc {

[[nodiscard]] presentation::Document motion_answer(RecordedMotion const& recorded);

/// The text of an axisc.json with the readings that were told and nothing else; none where none was.
[[nodiscard]] std::optional<std::string> motion_settings(comparison::MotionComparison const& result);
/// Of the keys that are not written, the readings that they may have and what would tell them; none where no
/// reading fits.
[[nodiscard]] std::vector<Message> motion_left_open(comparison::MotionComparison const& result);

}  // namespace axisc
