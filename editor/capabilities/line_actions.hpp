// Actions that insert something in a single line of a document.
#pragma once

#include "diagnostics/finding.hpp"
#include "editor/reading/open_machines.hpp"

#include <cstddef>
#include <string>

#include <nlohmann/json_fwd.hpp>

namespace axisc::editor {

class LineActions {
 public:
  /// All outlive this object; actions are added to `actions`.
  LineActions(OpenMachines& machines, Document const& document, Json& actions)
      : machines_(machines), document_(document), actions_(actions) {}

  /// Allowing a finding on its line, and its page. `shown` is its diagnostic.
  void add_allowance(Finding const& finding, Json const& shown);
  /// The number in the unit of the list for a value that was written with another, which stays as a comment.
  void add_conversion(std::size_t offset);
  /// The word of a number of an enumeration, where the line has no comment yet.
  void add_word(std::size_t offset);

 private:
  /// A workspace edit.
  [[nodiscard]] Json insertion(TextPosition at, std::string const& text) const;
  void add_rewrite(std::string title, std::size_t at, std::string const& text);

  OpenMachines& machines_;
  Document const& document_;
  Json& actions_;
};

}  // namespace axisc::editor
