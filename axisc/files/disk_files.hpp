// Reads files from the disk for the library.
#pragma once

#include "axisc/environment/failure.hpp"
#include "configuration/files.hpp"
#include "system/error.hpp"

#include <cstdint>
#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace axisc {

/// Reads regular files: no list, program or settings file may make the program wait, or read a device
/// without end.
class DiskFiles final : public configuration::Files {
 public:
  /// `dash_is_standard_input`: "-" means standard input, which is read once and kept.
  explicit DiskFiles(bool dash_is_standard_input = false) : dash_is_standard_input_(dash_is_standard_input) {}
  [[nodiscard]] std::variant<std::string, configuration::FileError> read(std::string const& path) override;
  /// Memory: one block; standard input, which can be read only once, is kept completely.
  [[nodiscard]] std::optional<configuration::FileError> read_pieces(
      std::string const& path, configuration::PieceReceiver const& receive) override;
  [[nodiscard]] bool is_file(std::string const& path) override;
  [[nodiscard]] std::vector<std::string> names_in(std::string const& folder) override;
  [[nodiscard]] bool is_same(std::string const& one, std::string const& other) override;

 private:
  bool dash_is_standard_input_;
  std::optional<std::string> standard_input_;
};

/// The line for a file that could not be read: AX9001, or AX9003 where it is too large.
[[nodiscard]] Failure unreadable(std::string const& path, configuration::FileError error);
/// The line for any other error; errors without a sentence here are quoted in the system's words.
[[nodiscard]] Failure unreadable(std::string const& path, system::Error const& error);

enum class Dash : std::uint8_t { is_standard_input, is_a_name };

/// The bytes of a file or pipe that a command needs whole. Failure where it cannot be read.
[[nodiscard]] std::string read_whole(std::string const& path, Dash dash = Dash::is_standard_input);
/// The bytes of a file that must not be a pipe. Failure where it cannot be read.
[[nodiscard]] std::string read_regular(std::string const& path);

}  // namespace axisc
