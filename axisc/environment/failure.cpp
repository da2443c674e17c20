#include "axisc/environment/failure.hpp"

#include "diagnostics/sentences.hpp"
#include "diagnostics/terminal.hpp"

#include <string_view>
#include <utility>

namespace axisc {

namespace {

std::string line_of(SentenceRef severity, std::optional<Code> code, std::string const& sentence,
                    Language language) {
  std::string line = "axisc: " + std::string(severity.in(language));
  if (code) line += "[" + code_text(*code) + "]";
  return line + ": " + printable(sentence) + "\n";
}

}  // namespace

Failure::Failure(Message message, std::optional<Code> code)
    : Failure(std::string(), {std::move(message)}, code) {}

Failure::Failure(std::string place, std::vector<Message> sentences, std::optional<Code> code)
    : place_(std::move(place)),
      sentences_(std::move(sentences)),
      code_(code),
      what_(sentence(Language::english)) {}

std::string Failure::sentence(Language language) const {
  std::string text = place_;
  std::string_view before = place_.empty() ? "" : ": ";
  for (Message const& each : sentences_) {
    text.append(before).append(render(each, language));
    before = "; ";
  }
  return text;
}

std::string Failure::line(Language language) const {
  return line_of(says::word_error, code_, sentence(language), language);
}

std::string warning_line(Message const& message, Language language) {
  return line_of(says::word_warning, std::nullopt, render(message, language), language);
}

}  // namespace axisc
