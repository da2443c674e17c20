#include "editor/reading/edited_text.hpp"

#include <algorithm>
#include <utility>

namespace axisc::editor {

EditedText::EditedText(std::string text, PositionEncoding encoding)
    : text_(std::move(text)), encoding_(encoding) {
  for (std::size_t i = 0; i <= text_.size(); ++i) {
    if (begins_line(i)) begins_.push_back(i);
  }
}

bool EditedText::begins_line(std::size_t offset) const {
  if (offset == 0) return true;
  char const before = text_[offset - 1];
  return before == '\n' || (before == '\r' && (offset == text_.size() || text_[offset] != '\n'));
}

std::size_t EditedText::offset(TextPosition position) const {
  if (position.line >= begins_.size()) return text_.size();
  std::size_t const begin = begins_[position.line];
  std::size_t const next = position.line + 1 < begins_.size() ? begins_[position.line + 1] : text_.size();
  auto const line = std::string_view(text_).substr(begin, next - begin);
  return begin + offset_of_unit(line.substr(0, line.find_first_of("\r\n")), position.character, encoding_);
}

void EditedText::replace(std::size_t begin, std::size_t end, std::string_view inserted) {
  text_.replace(begin, end - begin, inserted);
  // A line may begin or end at either end of the inserted text: CR and LF can meet there.
  std::size_t const inserted_end = begin + inserted.size();
  std::vector<std::size_t> found;
  for (std::size_t i = begin; i <= inserted_end; ++i) {
    if (begins_line(i)) found.push_back(i);
  }
  auto const first = std::lower_bound(begins_.begin(), begins_.end(), begin);
  auto const last = std::upper_bound(first, begins_.end(), end);
  std::transform(last, begins_.end(), last, [&](std::size_t each) { return each - end + inserted_end; });
  auto const kept = std::min(last - first, static_cast<std::ptrdiff_t>(found.size()));
  std::copy_n(found.begin(), kept, first);
  if (first + kept != last) {
    begins_.erase(first + kept, last);
  } else {
    begins_.insert(last, found.begin() + kept, found.end());
  }
}

}  // namespace axisc::editor
