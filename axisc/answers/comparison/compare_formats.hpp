// What `axisc compare` prints.
#pragma once

#include "analysis/comparison/settings.hpp"
#include "analysis/comparison/telling_motion.hpp"
#include "analysis/comparison/verdict.hpp"
#include "diagnostics/message.hpp"

#include <string>

namespace axisc {

struct ShownComparison {
  std::string axis;
  std::string input_name, output_name;
  std::size_t cycles = 0, repeated = 0;
  double thousandths = 1;  ///< µm (or 0.001°) in a unit of the recording
  bool is_rotary = false;
  std::size_t jumps = 0;                                 ///< by a modulo range, which were taken out
  std::optional<comparison::Motion> telling;             ///< what would tell the fitting readings apart
  std::vector<comparison::KernelSwitch> found_switches;  ///< not given with `--at`
  comparison::Comparison result;
};

[[nodiscard]] std::string compare_text(ShownComparison const& shown, Language language);
[[nodiscard]] std::string compare_json(ShownComparison const& shown, Language language);
/// What a reading departs in: with what the lists' values make the same as it.
[[nodiscard]] std::string reading_words(comparison::Reading const& reading, Language language);
/// A line for a setting that is not written, with the readings that it may be.
[[nodiscard]] std::string open_setting_text(comparison::OpenSetting const& open, Language language);
/// The text of an axisc.json with these readings and nothing else.
[[nodiscard]] std::string design_settings(design::Readings const& readings);

}  // namespace axisc
