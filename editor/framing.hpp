// Frames of the language server protocol: a header with the length, an empty line, the message.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace axisc::editor {

/// Longest accepted message, in bytes.
inline constexpr std::size_t longest_message = std::size_t{1} << 30U;

class FrameReader {
 public:
  /// Appends bytes that have arrived.
  void add(std::string_view bytes) { pending_ += bytes; }
  /// The next complete message; none if bytes are missing, or if a header gave no usable length.
  [[nodiscard]] std::optional<std::string> next();
  /// A header gave no usable length, so the start of the next message is unknown.
  [[nodiscard]] bool is_broken() const { return is_broken_; }

 private:
  std::string pending_;
  bool is_broken_ = false;
};

[[nodiscard]] std::string framed(std::string_view message);

}  // namespace axisc::editor
