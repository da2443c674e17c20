#include "cli/report/console.hpp"

#include "cli/codes.hpp"
#include "cli/failure.hpp"
#include "cli/files/output_file.hpp"

namespace axisc::cli {

namespace {

/// Large enough that writing costs nothing beside what is written, small enough to stay in the processor's caches.
constexpr std::size_t piece = std::size_t{1} << 15U;

Text reason(system::Refusal refusal) {
  switch (refusal) {
    case system::Refusal::closed_pipe:
      return Text::cli_stdout_closed_pipe;
    case system::Refusal::no_space:
      return Text::cli_stdout_no_space;
    case system::Refusal::not_open:
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
  auto const error = system::write(stream_, buffer_);
  buffer_.clear();
  if (!error) return;
  if (stream_ == system::Stream::error) throw Failure({.text = Text::cli_stderr_failed, .arguments = {}}, cannot_write);
  throw Failure({.text = reason(error->refusal), .arguments = {{"reason", system::text_of(*error)}}}, cannot_write);
}

}  // namespace axisc::cli
