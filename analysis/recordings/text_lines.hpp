// Lines of a text that arrives piece by piece.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <string_view>

namespace axisc::recordings {

/// Fills the buffer from its front and returns the number of bytes; 0 at the end. May throw.
using ByteSource = std::function<std::size_t(std::span<char> buffer)>;

/// A source of bytes that outlive it.
[[nodiscard]] ByteSource source_of(std::string_view bytes);

inline constexpr std::size_t longest_line = std::size_t{1} << 20U;

/// Memory is a line and 64 KiB. A byte order mark and the ends of lines, also CRLF, are left out.
class TextLines {
 public:
  enum class Step : std::uint8_t { line, end, too_long };

  explicit TextLines(ByteSource source) : source_(std::move(source)) {}

  /// The next line that is not blank; `line` is valid until the next call. After too_long nothing can be
  /// read.
  [[nodiscard]] Step next(std::string_view& line);
  [[nodiscard]] std::uint64_t number() const { return number_; }  ///< of the last line, from 1

 private:
  [[nodiscard]] bool fill();

  ByteSource source_;
  std::string buffer_;
  std::size_t used_ = 0;  ///< bytes of buffer_ that were handed out
  std::uint64_t number_ = 0;
  bool ended_ = false;
};

}  // namespace axisc::recordings
