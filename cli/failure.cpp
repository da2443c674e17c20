#include "cli/failure.hpp"

#include <system_error>
#include <utility>

namespace axisc::cli {

namespace {

/// One line, whatever a file name contains.
std::string without_line_ends(std::string text) {
  for (char& character : text) {
    if (static_cast<unsigned char>(character) < 0x20U || character == 0x7F) character = '?';
  }
  return text;
}

std::string line_of(Text severity, std::optional<Code> code, Message const& message, Language language) {
  std::string line = "axisc: " + std::string(text_template(severity, language));
  if (code) line += "[" + code_text(*code) + "]";
  return line + ": " + without_line_ends(render(message, language)) + "\n";
}

}  // namespace

Failure::Failure(Message message, std::optional<Code> code)
    : message_(std::move(message)), code_(code), what_(render(message_, Language::english)) {}

std::string Failure::line(Language language) const {
  return line_of(Text::word_error, code_, message_, language);
}

std::string warning_line(Message const& message, Language language) {
  return line_of(Text::word_warning, std::nullopt, message, language);
}

std::string system_error_text(int number) {
  return std::generic_category().message(number);
}

}  // namespace axisc::cli
