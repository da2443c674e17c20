// Where sources come from: the disk for the command line, editor buffers for a language server, a map in
// tests.
#pragma once

#include <cstdint>
#include <string>
#include <variant>

namespace axisc::validator {

enum class FileError : std::uint8_t {
  not_found,
  is_folder,
  no_permission,
  not_readable,
  too_large,
  line_too_long,
  binary,
  utf16,
  image
};

/// Longest file that is read.
inline constexpr std::uint64_t largest_file = 1ULL << 30U;

class Files {
 public:
  virtual ~Files() = default;
  /// The bytes of `path`, or why there are none.
  [[nodiscard]] virtual std::variant<std::string, FileError> read(std::string const& path) = 0;

 protected:
  Files() = default;
  Files(Files const&) = default;
  Files& operator=(Files const&) = default;
};

/// What is wrong with bytes that were read, before they are parsed: too large, one line too long, not a text.
[[nodiscard]] std::variant<std::monostate, FileError> check_text(std::string_view bytes);

}  // namespace axisc::validator
