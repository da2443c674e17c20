// A JSON file of the user's, read with the place of everything in it, so that each complaint names line and column.
#pragma once

#include "diagnostics/source_text.hpp"
#include "diagnostics/text.hpp"
#include "validator/located_json.hpp"

#include <string>
#include <vector>

namespace axisc::cli {

class LocatedFile {
 public:
  /// Failure where the file cannot be read, and with the sentence `malformed` where it is no JSON.
  LocatedFile(std::string path, Text malformed);

  [[nodiscard]] std::string const& path() const { return path_; }
  [[nodiscard]] validator::JsonValue const& root() const { return document_.root(); }
  [[nodiscard]] validator::JsonValue const& operator[](std::size_t index) const { return document_[index]; }
  /// The string at `value`; refuses any other kind.
  [[nodiscard]] std::string const& text(validator::JsonValue const& value) const;
  /// Failure: `what` with {place} as "axisc.json:3:5".
  [[noreturn]] void refuse(Span span, Text what, std::vector<Argument> arguments = {}) const;

 private:
  std::string path_;
  SourceText source_;
  validator::JsonDocument document_;
};

}  // namespace axisc::cli
