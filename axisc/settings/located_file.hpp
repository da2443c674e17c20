// A JSON file written by the user, read with the position of every value, so that each message names line and
// column.
#pragma once

#include "configuration/json_shape.hpp"
#include "configuration/located_json.hpp"
#include "diagnostics/finding.hpp"
#include "diagnostics/source_text.hpp"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace axisc {

class LocatedFile {
 public:
  /// Failure if the file cannot be read; with `code`, if it is not JSON (sentence `malformed`) or does not
  /// match `shape` (the first mistake).
  LocatedFile(std::string path, configuration::JsonShape const& shape, SentenceRef malformed,
              std::optional<Code> code = std::nullopt);

  [[nodiscard]] std::string const& path() const { return path_; }
  [[nodiscard]] std::string_view bytes() const { return source_.bytes().substr(source_.text_begin()); }
  [[nodiscard]] configuration::JsonValue const& root() const { return document_.root(); }
  [[nodiscard]] configuration::JsonValue const& operator[](std::size_t index) const {
    return document_[index];
  }
  /// A key's value; null if `object` does not have the key.
  [[nodiscard]] configuration::JsonValue const* find(configuration::JsonValue const& object,
                                                     std::string_view key) const;
  /// Stores the values of the file, or of an object in it, in the members that the shape's keys name.
  void fill(void* target) const { fill(shape_, root(), target); }
  void fill(configuration::JsonShape const& shape, configuration::JsonValue const& object,
            void* target) const;
  /// Failure: the place as "axisc.json:3:5", and `what`.
  [[noreturn]] void refuse(Span span, SentenceRef what, std::vector<Argument> arguments = {}) const;

 private:
  [[noreturn]] void refuse(Span span, std::vector<Message> sentences) const;

  std::string path_;
  configuration::JsonShape const& shape_;
  std::optional<Code> code_;
  SourceText source_;
  configuration::JsonDocument document_;
};

}  // namespace axisc
