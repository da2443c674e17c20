#include "axisc/settings/located_file.hpp"

#include "axisc/environment/failure.hpp"
#include "axisc/files/disk_files.hpp"
#include "configuration/json_check.hpp"
#include "configuration/json_reading.hpp"
#include "configuration/sentences.hpp"

#include <utility>
#include <variant>

namespace axisc {

namespace {

std::vector<Message> sentences_of(configuration::JsonProblem const& problem) {
  std::vector<Message> sentences{problem.message};
  if (!problem.suggestion.empty()) {
    sentences.push_back(
        {axisc::configuration::says::json_did_you_mean, {{"suggestion", problem.suggestion}}});
  }
  if (!problem.number.empty()) {
    sentences.push_back({axisc::configuration::says::json_write_number, {{"replacement", problem.number}}});
  }
  if (!problem.known_keys.empty()) {
    sentences.push_back({axisc::configuration::says::json_known_keys, {{"keys", problem.known_keys}}});
  }
  return sentences;
}

}  // namespace

LocatedFile::LocatedFile(std::string path, configuration::JsonShape const& shape, SentenceRef malformed,
                         std::optional<Code> code)
    : path_(std::move(path)), shape_(shape), code_(code), source_(path_, read_regular(path_)) {
  auto parsed = configuration::parse_json(source_.bytes(), source_.text_begin());
  if (auto const* const error = std::get_if<configuration::JsonError>(&parsed)) {
    std::vector<Message> sentences{{malformed}};
    if (error->reason) sentences.push_back(*error->reason);
    refuse(error->span, std::move(sentences));
  }
  document_ = std::get<configuration::JsonDocument>(std::move(parsed));
  auto const problems = configuration::check_json(document_, shape_).problems;
  if (!problems.empty()) refuse(problems.front().span, sentences_of(problems.front()));
}

configuration::JsonValue const* LocatedFile::find(configuration::JsonValue const& object,
                                                  std::string_view key) const {
  auto const* const member = object.find(key);
  return member == nullptr ? nullptr : &document_[member->value];
}

void LocatedFile::fill(configuration::JsonShape const& shape, configuration::JsonValue const& object,
                       void* target) const {
  std::vector<bool> const all(document_.values.size(), true);
  configuration::JsonReading(document_, all).fill(shape, object, target);
}

void LocatedFile::refuse(Span span, SentenceRef what, std::vector<Argument> arguments) const {
  refuse(span, {Message{what, std::move(arguments)}});
}

void LocatedFile::refuse(Span span, std::vector<Message> sentences) const {
  auto const position = source_.position(span.begin);
  throw Failure(path_ + ":" + std::to_string(position.line) + ":" + std::to_string(position.column),
                std::move(sentences), code_);
}

}  // namespace axisc
