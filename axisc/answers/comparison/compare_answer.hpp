// Whether a control does what axisc computes.
#pragma once

#include "analysis/comparison/settings.hpp"
#include "analysis/comparison/verdict.hpp"
#include "axisc/answers/execution/recorded_axis.hpp"
#include "diagnostics/wording.hpp"
#include "presentation/document.hpp"

#include <string>

namespace axisc {

/// `axis` is a name for people.
[[nodiscard]] presentation::Document compare_answer(std::string const& axis, RecordedAxis const& recorded);

/// What a reading departs in, with what the lists' values make the same as it.
[[nodiscard]] Wording reading_words(comparison::Reading const& reading);

/// The text of an axisc.json with these readings and nothing else.
[[nodiscard]] std::string design_settings(design::Readings const& readings);
/// Of a setting that is not written, the readings that it may be.
[[nodiscard]] Message left_open(comparison::OpenSetting const& open);

}  // namespace axisc
