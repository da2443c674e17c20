// Standard output and standard error, written so that no failure goes unnoticed.
#pragma once

#include "system/process.hpp"

#include <functional>
#include <string>
#include <string_view>
#include <utility>

namespace axisc::cli {

class OutputFile;

/// Collects text and writes it in large pieces. A closed pipe or a full disk is a Failure.
class Console {
 public:
  /// A failure of standard output is reported; of standard error there is nobody left to tell.
  explicit Console(system::Stream stream) : stream_(stream) {}
  /// For a file that is to be whole or not there; it is committed by its owner.
  explicit Console(OutputFile& file) : file_(&file) {}
  Console(Console const&) = delete;
  Console& operator=(Console const&) = delete;
  ~Console() = default;

  void write(std::string_view text);
  /// Writes what was collected. Must be called at the end: the destructor writes nothing.
  void flush();
  /// Called before something is printed; empty: nothing is.
  void before_printing(std::function<void()> action) { before_printing_ = std::move(action); }
  /// Forgets what was collected, after a failure.
  void discard() { buffer_.clear(); }

 private:
  system::Stream stream_ = system::Stream::output;
  OutputFile* file_ = nullptr;
  std::function<void()> before_printing_;
  std::string buffer_;
};

/// The two streams of the program.
struct Streams {
  Console out{system::Stream::output};
  Console err{system::Stream::error};
};

}  // namespace axisc::cli
