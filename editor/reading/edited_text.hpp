// A text while a client's edits arrive: many edits in one message cost as much as their lines, not each the whole text.
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

  /// As offset_of().
  [[nodiscard]] std::size_t offset(TextPosition position) const;
  /// Cost: the bytes and lines after `begin`, moved at once.
  void replace(std::size_t begin, std::size_t end, std::string_view inserted);
  [[nodiscard]] std::string take() && { return std::move(text_); }

 private:
  /// After LF, CRLF or CR, and at 0.
  [[nodiscard]] bool begins_line(std::size_t offset) const;

  std::string text_;
  PositionEncoding encoding_;
  std::vector<std::size_t> begins_;  ///< of the lines
};

}  // namespace axisc::editor
