// Interface for reading sources: from the disk for the command line, from editor buffers for a language
// server, from a map in tests.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

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
  image,
  not_regular,  ///< a pipe or a device
  link_loop     ///< symbolic links in a circle
};

/// Longest file that is read.
inline constexpr std::uint64_t largest_file = 1ULL << 30U;

/// Receives the next bytes of a file; returns false to stop.
using PieceReceiver = std::function<bool(std::string_view)>;

class Files {
 public:
  virtual ~Files() = default;
  /// The bytes of `path`, or why they cannot be read.
  [[nodiscard]] virtual std::variant<std::string, FileError> read(std::string const& path) = 0;
  /// Passes the bytes of `path` on in pieces, in their order, or returns why it cannot: an NC program may be
  /// too long to be kept in memory. Every call begins at the start of the file. The default implementation
  /// reads the whole file and passes it in one piece.
  [[nodiscard]] virtual std::optional<FileError> read_pieces(std::string const& path,
                                                             PieceReceiver const& receive);
  /// True for a file that could be read. The default implementation reads it.
  [[nodiscard]] virtual bool is_file(std::string const& path);
  /// The names in a folder, in any order; `folder` ends in a separator or is empty for the working folder.
  /// None where it cannot be read, and from the default implementation.
  [[nodiscard]] virtual std::vector<std::string> names_in(std::string const& folder);
  /// True for two names of one file. The default implementation compares the names.
  [[nodiscard]] virtual bool is_same(std::string const& one, std::string const& other);

 protected:
  Files() = default;
  Files(Files const&) = default;
  Files& operator=(Files const&) = default;
};

/// Thrown if a file has changed when it is read again: an error of the environment, not of the input.
class SourceChanged : public std::runtime_error {
 public:
  explicit SourceChanged(std::string const& path) : std::runtime_error(path), path_(path) {}
  [[nodiscard]] std::string const& path() const { return path_; }

 private:
  std::string path_;
};

/// This much of a file, or all of it, is enough to determine its kind.
inline constexpr std::size_t judged_beginning = 8000;
/// The error of a file that begins with `bytes`, if it is not text.
[[nodiscard]] std::optional<FileError> check_beginning(std::string_view bytes);

/// The error of bytes that are to be parsed: too large, a line too long, not text.
[[nodiscard]] std::variant<std::monostate, FileError> check_text(std::string_view bytes);

}  // namespace axisc::configuration
