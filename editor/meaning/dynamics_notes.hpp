// What becomes of a value that says how fast an axis may be driven: the jerk of a ramp time, and the value
// that counts where another parameter caps it.
#pragma once

#include "configuration/machine/path_dynamics.hpp"
#include "diagnostics/sentence.hpp"
#include "editor/reading/open_list.hpp"

#include <optional>
#include <string>

namespace axisc::editor {

class DynamicsNotes {
 public:
  /// `list` outlives the notes. Cost: some dozen values, at the first note.
  DynamicsNotes(OpenList const& list, Language language) : list_(list), language_(language) {}

  /// "40 m/s³", "4000 mm/s² counts (P-AXIS-00008)"; empty for other parameters, for lines whose value another
  /// line replaces, and where there is nothing to say.
  [[nodiscard]] std::string of(grammar::Assignment const& line, schema::NameLookup const& found);
  /// As a sentence for a hover: "\nThe jerk is a/tr = 40 m/s³.\n".
  [[nodiscard]] std::string sentence_of(grammar::Assignment const& line, schema::NameLookup const& found);

 private:
  /// What there is to say of a value.
  struct Note {
    std::string counts, cap;  ///< where another value counts, and what caps it; without a cap: that of 0
    std::string jerk;
  };
  [[nodiscard]] std::optional<Note> note_of(grammar::Assignment const& line, schema::NameLookup const& found);

  OpenList const& list_;
  Language language_;
  std::optional<machine::AxisDynamics> dynamics_;
};

}  // namespace axisc::editor
