// Standard output and standard error, written so that no failure goes unnoticed.
#pragma once

#include "system/process.hpp"

#include <functional>
#include <string>
#include <string_view>
#include <utility>

namespace axisc::cli {

/// Collects text and writes it in large pieces. A full disk is a Failure, a closed pipe ReaderGone.
class Console {
 public:
  /// A failure of standard output is reported; a failure of standard error cannot be.
  explicit Console(system::Stream stream) : stream_(stream) {}
  Console(Console const&) = delete;
  Console& operator=(Console const&) = delete;
  ~Console() = default;

  void write(std::string_view text);
  /// Writes the collected text. Must be called at the end: the destructor writes nothing.
  void flush();
  /// Called before something is printed; may be empty.
  void before_printing(std::function<void()> action) { before_printing_ = std::move(action); }

 private:
  void print(std::string_view text);

  system::Stream stream_ = system::Stream::output;
  std::function<void()> before_printing_;
  std::string buffer_;
};

/// Standard output and standard error of the program.
struct Streams {
  Console out{system::Stream::output};
  Console err{system::Stream::error};
};

}  // namespace axisc::cli
