#include "analysis/recordings/text_lines.hpp"

#include "diagnostics/ascii.hpp"

#include <algorithm>

namespace axisc::recordings {

namespace {

constexpr std::size_t piece = std::size_t{1} << 16U;
constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";

}  // namespace

ByteSource source_of(std::string_view bytes) {
  return [bytes](std::span<char> buffer) mutable {
    auto const size = std::min(buffer.size(), bytes.size());
    std::copy_n(bytes.data(), size, buffer.data());
    bytes.remove_prefix(size);
    return size;
  };
}

bool TextLines::fill() {
  buffer_.erase(0, used_);
  used_ = 0;
  auto const filled = buffer_.size();
  if (filled > longest_line) return false;
  buffer_.resize(filled + piece);
  auto const got = source_({buffer_.data() + filled, piece});
  buffer_.resize(filled + got);
  ended_ = got == 0;
  return true;
}

TextLines::Step TextLines::next(std::string_view& line) {
  for (;;) {
    auto const end = buffer_.find('\n', used_);
    if (end == std::string::npos && !ended_) {
      if (fill()) continue;
      ++number_;
      return Step::too_long;
    }
    if (used_ == buffer_.size()) return Step::end;
    auto const stop = std::min(end, buffer_.size());
    line = std::string_view(buffer_).substr(used_, stop - used_);
    used_ = std::min(stop + 1, buffer_.size());
    ++number_;
    if (number_ == 1 && line.starts_with(byte_order_mark)) line.remove_prefix(byte_order_mark.size());
    if (line.ends_with('\r')) line.remove_suffix(1);
    if (!std::all_of(line.begin(), line.end(), ascii::is_blank)) return Step::line;
  }
}

}  // namespace axisc::recordings
