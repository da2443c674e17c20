// What `axisc suggest` answers: the present setting of an axis and three others, each with what it does.
#pragma once

#include "analysis/motion/contour/contour_predictions.hpp"
#include "analysis/tuning/suggestion/choice.hpp"
#include "axisc/answers/suggestion/chain_edits.hpp"
#include "axisc/answers/suggestion/guard_coverage.hpp"
#include "axisc/answers/suggestion/measured_resonances.hpp"
#include "axisc/workspace/workspace.hpp"
#include "configuration/machine/machine.hpp"

#include <array>
#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace axisc {

/// A setting of the group's axes. Lengths are position units, feeds mm/min, none where any keeps the
/// tolerance.
struct Setting {
  tuning::Chain chain;
  tuning::Figures figures;
  motion::ContourFigures corner = {}, circle = {};  ///< at the feed, of all axes together
  std::optional<double> corner_feed = {}, circle_feed = {};
  std::optional<GuardCoverage> guard = {};  ///< of the chain's Vibration Guard
};

struct Alternative {
  Setting setting;
  std::vector<AxisLines> axes;  ///< of the group, and of gantry slaves that follow them
  std::optional<std::string> command;
  ListEdits edits;
  std::vector<std::string>
      findings;  ///< codes that the edited lists would have and the present ones have not
  /// Switches a Vibration Guard of the lists off, whose parameters are unused then (AX3029): that is said in
  /// words, and no reason against the setting.
  bool replaces_guard = false;
};

struct Suggestion {
  std::string axis, group;
  std::vector<std::string> axes = {};  ///< names of the group's
  design::CycleTime cycle_time;
  tuning::Task task = {};
  std::optional<MeasuredResonances> measured = {};  ///< where the resonances are from a measurement
  double feed = 0, tolerance_mm = 0, radius_mm = 0;
  std::optional<Setting> present = {};  ///< none where the axis' filters block the constant part
  std::array<Alternative, tuning::senses> alternatives = {};
  /// By sense: the first one whose setting does the same, most often itself. Only these are proposed.
  std::array<std::size_t, tuning::senses> proposed = {};
  tuning::Sense recommended = tuning::Sense::balanced;
  std::optional<tuning::Candidate> not_clean = {};
  std::size_t looked_at = 0;

  /// Senses that the alternative of one of them stands for; none where another alternative stands for it.
  [[nodiscard]] std::vector<tuning::Sense> senses_of(std::size_t index) const;
};

/// A checked machine with the lists that it was made from.
struct SuggestionSubject {
  std::string const& path;
  Workspace& workspace;
  validator::LoadedMachine const& loaded;
  SourceSet const& sources;
  machine::Machine const& machine;
  std::size_t group = 0;
  std::size_t axis = 0;
};

/// The group's axes, then gantry slaves that follow one of them.
[[nodiscard]] std::vector<std::size_t> concerned_axes(SuggestionSubject const& subject);

/// None where nothing the control has helps: then `looked_at` and `keeps` say how many settings there are,
/// and how many keep the tolerance on the circle.
struct NoSuggestion {
  std::size_t looked_at = 0, keeps = 0;
  double least_vibration = 1;  ///< of those that keep it
};

[[nodiscard]] std::variant<NoSuggestion, Suggestion> suggestion_for(SuggestionSubject const& subject,
                                                                    tuning::Task task);

}  // namespace axisc
