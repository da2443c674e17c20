// Failures that end the program with exit status 2: the command line, a file or the environment is at fault.
#pragma once

#include "diagnostics/finding.hpp"

#include <exception>
#include <optional>
#include <string>
#include <vector>

namespace axisc {

/// One sentence that states the problem and what to do about it. main() prints it.
class Failure : public std::exception {
 public:
  explicit Failure(Message message, std::optional<Code> code = std::nullopt);
  /// "axisc.json:2:3: unknown key …; did you mean …?": a place and the message about it.
  Failure(std::string place, std::vector<Message> sentences, std::optional<Code> code);

  [[nodiscard]] char const* what() const noexcept override { return what_.c_str(); }
  /// The message alone, without program name, severity and code.
  [[nodiscard]] std::string sentence(Language language) const;
  /// "axisc: error[AX9001]: …" with a line end.
  [[nodiscard]] std::string line(Language language) const;

 private:
  std::string place_;
  std::vector<Message> sentences_;
  std::optional<Code> code_;
  std::string what_;
};

/// Thrown when standard output has no reader any more; main() exits silently, as other filters do.
struct ReaderGone {};

/// "axisc: warning: …" with a line end.
[[nodiscard]] std::string warning_line(Message const& message, Language language);

}  // namespace axisc
