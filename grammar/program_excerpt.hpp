// An NC program that is read as its lines come and of which only the lines stay that the checks can point at:
// programs of a hundred megabytes hold a handful of commands.
#pragma once

#include "grammar/nc_program.hpp"

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace axisc::grammar {

/// Memory: the lines with a command, a function that is wanted or a comment that speaks to this program, and
/// the block that is open.
class ProgramExcerptReader {
 public:
  explicit ProgramExcerptReader(WantsFunction wants = nullptr)
      : reader_(collector_, ProgramDetail::commands, wants) {}
  ProgramExcerptReader(ProgramExcerptReader const&) = delete;
  ProgramExcerptReader& operator=(ProgramExcerptReader const&) = delete;

  /// The next line without its line end and without a byte order mark.
  void line(std::string_view text);
  /// After the last line, before the results are used.
  void finish();

  /// Its spans count in bytes(), its lines in the whole program.
  [[nodiscard]] NcProgram& program() { return collector_.program; }
  /// The lines that were kept, each followed by LF.
  [[nodiscard]] std::string& bytes() { return bytes_; }
  /// Which lines these are, from 1.
  [[nodiscard]] std::vector<std::uint32_t>& numbers() { return numbers_; }

 private:
  [[nodiscard]] std::size_t collected() const;

  ProgramCollector collector_;
  ProgramReader reader_;
  std::string bytes_;
  std::vector<std::uint32_t> numbers_;
  // Lines after these belong to an open block and are dropped when nothing is found in it.
  std::size_t kept_bytes_ = 0;
  std::size_t kept_lines_ = 0;
};

}  // namespace axisc::grammar
