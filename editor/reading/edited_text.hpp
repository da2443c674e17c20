// A text under edits: many edits in one message do not each cost a pass over the whole text.
#pragma once

#include "editor/reading/text_positions.hpp"

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace axisc::editor {

class EditedText {
 public:
  EditedText(std::string text, PositionEncoding encoding);

  /// As TextLines, for the current text.
  [[nodiscard]] std::size_t offset(TextPosition position) const;
  /// Cost: moving the bytes and line starts after `begin`.
  void replace(std::size_t begin, std::size_t end, std::string_view inserted);
  [[nodiscard]] std::string take() && { return std::move(text_); }

 private:
  /// True at 0, and after LF, CRLF or CR.
  [[nodiscard]] bool begins_line(std::size_t offset) const;

  std::string text_;
  PositionEncoding encoding_;
  std::vector<std::size_t> begins_;  ///< start of each line
};

}  // namespace axisc::editor
