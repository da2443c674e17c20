// The frames of the language server protocol: a header with the length of the message, an empty line, the message.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace axisc::editor {

/// Longest message that is read.
inline constexpr std::size_t longest_message = std::size_t{1} << 30U;

class FrameReader {
 public:
  /// Takes bytes as they arrive.
  void add(std::string_view bytes) { pending_ += bytes; }
  /// The next complete message; none where bytes are missing, or after a header that gives no length.
  [[nodiscard]] std::optional<std::string> next();
  /// A header gave no usable length: where the next message begins is unknown.
  [[nodiscard]] bool is_broken() const { return is_broken_; }

 private:
  std::string pending_;
  bool is_broken_ = false;
};

[[nodiscard]] std::string framed(std::string_view message);

}  // namespace axisc::editor
