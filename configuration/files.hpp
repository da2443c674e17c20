// Where sources come from: the disk for the command line, editor buffers for a language server, a map in
// tests.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <variant>

namespace axisc::configuration {

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

/// Takes the next bytes of a file; false when no more are wanted.
using PieceReceiver = std::function<bool(std::string_view)>;

class Files {
 public:
  virtual ~Files() = default;
  /// The bytes of `path`, or why there are none.
  [[nodiscard]] virtual std::variant<std::string, FileError> read(std::string const& path) = 0;
  /// Hands the bytes of `path` over in pieces, in their order, or says why there are no more: an NC program may be far
  /// longer than what shall be in memory. Every call begins at the start of the file. What is in memory anyway comes in
  /// one piece, as it does here.
  [[nodiscard]] virtual std::optional<FileError> read_pieces(std::string const& path,
                                                             PieceReceiver const& receive);

 protected:
  Files() = default;
  Files(Files const&) = default;
  Files& operator=(Files const&) = default;
};

/// A file was not the same when it was read again. The environment is at fault, so this is thrown.
class SourceChanged : public std::runtime_error {
 public:
  explicit SourceChanged(std::string const& path) : std::runtime_error(path), path_(path) {}
  [[nodiscard]] std::string const& path() const { return path_; }

 private:
  std::string path_;
};

/// So much of a file at least, or all of it, shows what kind of file it is.
inline constexpr std::size_t judged_beginning = 8000;
/// What is wrong with a file that begins with `bytes`: it is not a text.
[[nodiscard]] std::optional<FileError> check_beginning(std::string_view bytes);

/// What is wrong with bytes that were read, before they are parsed: too large, one line too long, not a text.
[[nodiscard]] std::variant<std::monostate, FileError> check_text(std::string_view bytes);

}  // namespace axisc::configuration
