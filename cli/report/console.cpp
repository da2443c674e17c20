#include "cli/report/console.hpp"

#include "cli/codes.hpp"
#include "cli/failure.hpp"
#include "cli/files/file_descriptor.hpp"
#include "cli/files/output_file.hpp"

#include <cerrno>
#include <unistd.h>

namespace axisc::cli {

namespace {

/// Large enough that writing costs nothing beside what is written, small enough to stay in the processor's caches.
constexpr std::size_t piece = std::size_t{1} << 15U;

Text reason(int error) {
  switch (error) {
    case EPIPE:
      return Text::cli_stdout_closed_pipe;
    case ENOSPC:
      return Text::cli_stdout_no_space;
    case EBADF:
      return Text::cli_stdout_closed;
    default:
      return Text::cli_stdout_failed;
  }
}

}  // namespace

void Console::write(std::string_view text) {
  // All at once: a buffer that grew step by step would touch twice the memory.
  if (buffer_.capacity() < piece) buffer_.reserve(2 * piece);
  buffer_ += text;
  if (buffer_.size() >= piece) flush();
}

void Console::flush() {
  if (buffer_.empty()) return;
  if (before_printing_) before_printing_();
  if (file_ != nullptr) {
    file_->write(buffer_);
    buffer_.clear();
    return;
  }
  int const error = write_all(descriptor_, buffer_);
  buffer_.clear();
  if (error != 0 && descriptor_ == STDOUT_FILENO) {
    throw Failure({.text = reason(error), .arguments = {{"reason", system_error_text(error)}}}, cannot_write);
  }
  if (error != 0) throw Failure({.text = Text::cli_stderr_failed, .arguments = {}}, cannot_write);
}

}  // namespace axisc::cli
