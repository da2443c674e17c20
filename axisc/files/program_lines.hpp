// Reads an NC program line by line, in constant memory and as often as needed.
#pragma once

#include "system/file.hpp"

#include <cstdint>
#include <functional>
#include <string>
#include <string_view>

namespace axisc {

class ProgramLines {
 public:
  /// "-" is standard input, which cannot be read twice and is kept in memory; otherwise a regular file.
  /// Failure AX9001, AX9003.
  explicit ProgramLines(std::string path);

  /// Calls `line` with each line, without its end, and its place in the program, until it returns false.
  void read(std::function<bool(std::string_view line, std::uint32_t offset)> const& line);

  /// Bytes of the program.
  [[nodiscard]] std::uint64_t size() const { return size_; }

 private:
  [[nodiscard]] std::size_t fill(char* buffer, std::size_t size);

  std::string path_;
  system::File file_;
  bool in_memory_ = false;
  std::string content_;
  std::uint64_t size_ = 0;
  std::uint64_t read_ = 0;
};

}  // namespace axisc
