#include "cli/terminal/console.hpp"

#include "axisc/environment/codes.hpp"
#include "axisc/environment/failure.hpp"

namespace axisc::cli::says {

constexpr Sentence stdout_no_space{"cannot write standard output: no space is left",
                                   "die Standardausgabe ist nicht schreibbar: kein Speicherplatz mehr"};
constexpr Sentence stdout_closed{"cannot write standard output: it is closed",
                                 "die Standardausgabe ist nicht schreibbar: sie ist geschlossen"};
constexpr Sentence stdout_failed{"cannot write standard output: {reason}",
                                 "die Standardausgabe ist nicht schreibbar: {reason}"};
constexpr Sentence stderr_failed{"cannot write standard error",
                                 "die Standardfehlerausgabe ist nicht schreibbar"};

}  // namespace axisc::cli::says

namespace axisc::cli {

namespace {

/// Large enough that system calls do not matter, small enough to stay in the processor's caches.
constexpr std::size_t piece = std::size_t{1} << 15U;

SentenceRef reason(system::Refusal refusal) {
  switch (refusal) {
    case system::Refusal::no_space: return says::stdout_no_space;
    case system::Refusal::not_open: return says::stdout_closed;
    default: return says::stdout_failed;
  }
}

}  // namespace

void Console::write(std::string_view text) {
  if (text.size() >= piece) {
    flush();
    print(text);
    return;
  }
  // Reserved at once: a buffer that grew step by step would touch twice the memory.
  if (buffer_.capacity() < piece) buffer_.reserve(2 * piece);
  buffer_ += text;
  if (buffer_.size() >= piece) flush();
}

void Console::flush() {
  if (buffer_.empty()) return;
  // Taken out, so that nothing is printed twice after a failure.
  std::string text = std::exchange(buffer_, {});
  print(text);
  text.clear();
  buffer_ = std::move(text);
}

void Console::print(std::string_view text) {
  if (before_printing_) before_printing_();
  auto const error = system::write(stream_, text);
  if (!error) return;
  if (error->refusal == system::Refusal::closed_pipe) throw ReaderGone();
  if (stream_ == system::Stream::error) {
    throw Failure({says::stderr_failed}, cannot_write);
  }
  throw Failure({reason(error->refusal), {{"reason", system::text_of(*error)}}}, cannot_write);
}

}  // namespace axisc::cli
