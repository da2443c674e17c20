// The lines of `axisc diff` in words, for text and Markdown.
#pragma once

#include "axisc/answers/difference/diff_formats.hpp"

#include <set>
#include <string>
#include <vector>

namespace axisc {

/// One line: what, before, after.
struct DiffLine {
  std::string what, before, after;
  friend bool operator==(DiffLine const&, DiffLine const&) = default;
};

/// A parameter: its values, what it means, and where it is set.
struct DiffParameter {
  DiffLine line;
  std::string meaning;  ///< "P-AXIS-00151: cut-off frequency"; may be empty
  std::string restart;  ///< that a restart is needed, where it is
  /// Old and new, or one of them; of several axes those of each.
  std::vector<std::vector<std::string>> places;
};

/// What is said of a channel, of an axis, or of several axes.
struct DiffSection {
  std::string title;
  std::vector<std::string> axes = {};
  std::vector<DiffLine> facts = {};
  std::vector<DiffParameter> parameters = {};
  std::vector<DiffLine> effects = {};
};

/// All lines of a comparison.
class DiffWords {
 public:
  DiffWords(ShownDifference const& shown, Language language) : shown_(shown), language_(language) {}

  [[nodiscard]] std::string say(SentenceRef text, std::vector<Argument> arguments = {}) const;

  /// "… mean the same"; only where they do.
  [[nodiscard]] std::string nothing(std::string const& before, std::string const& after) const;
  /// NC cycle time, axes of one side only, gantries.
  [[nodiscard]] std::vector<DiffLine> machine() const;
  [[nodiscard]] std::vector<DiffSection> channels() const;
  /// Axes with differences; those that differ alike together, after what a line of the default list changes
  /// for several.
  [[nodiscard]] std::vector<DiffSection> axes() const;
  /// What needs a restart, and what is not shown.
  [[nodiscard]] std::vector<std::string> remarks() const;

 private:
  [[nodiscard]] DiffSection channel(ChannelDifference const& channel) const;
  [[nodiscard]] DiffSection axis(AxisDifference const& axis,
                                 std::set<ParameterChange const*> const& told) const;
  /// What lines of the default list change for several axes; `told` receives these changes.
  [[nodiscard]] std::vector<DiffSection> shared(std::set<ParameterChange const*>& told) const;
  /// "X (number 1, achsmds1.lis)".
  [[nodiscard]] std::string axis_name(ComparedAxis const& was, ComparedAxis const& is) const;
  [[nodiscard]] DiffParameter parameter(ParameterChange const& change) const;
  [[nodiscard]] std::string value(ParameterChange const& change, ComparedValue const& value) const;
  [[nodiscard]] std::string meaning(ParameterChange const& change) const;
  /// One or two.
  [[nodiscard]] std::vector<std::string> places(ParameterChange const& change) const;
  [[nodiscard]] std::vector<DiffLine> effects(image::ChainDifference const& chain) const;
  [[nodiscard]] std::string time(double cycles, design::CycleTime cycle_time) const;
  [[nodiscard]] std::string settling(image::ChainFigures const& chain, design::CycleTime cycle_time) const;
  [[nodiscard]] std::string corner(image::ChainFigures const& chain, design::CycleTime cycle_time) const;

  ShownDifference const& shown_;
  Language language_;
};

}  // namespace axisc
