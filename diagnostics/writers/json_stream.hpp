// Writes JSON from front to back, without building a tree. The text equals that of nlohmann's dump() with an
// indentation of two, or without indentation.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace axisc {

/// JSON text with `\u` escapes for characters that a reader would not see and a terminal might obey.
[[nodiscard]] std::string escape_invisible(std::string json);

/// With quotes and escapes, those of escape_invisible() as well; invalid UTF-8 becomes U+FFFD.
[[nodiscard]] std::string json_string(std::string_view text);

class JsonStream {
 public:
  /// Appends to `out` a value whose closing bracket is indented by `indent` blanks.
  JsonStream(std::string& out, std::size_t indent) : out_(out), indent_(indent) {}
  /// Appends to `out` a value without line breaks and blanks.
  explicit JsonStream(std::string& out) : out_(out), is_one_line_(true) {}

  void begin_object() { open('{'); }
  void end_object() { close('}'); }
  void begin_array() { open('['); }
  void end_array() { close(']'); }
  /// In an object; the value comes next. `name` is written as it is and needs no escape, in member() too.
  void key(std::string_view name);

  /// Made well-formed UTF-8.
  void string(std::string_view text);
  /// null for an empty text.
  void string_or_null(std::string_view text);
  void number(std::uint64_t value);
  void boolean(bool value);
  void null();
  /// A complete value, written unchanged.
  void raw(std::string_view text);

  /// A member of an object that is a string.
  void member(std::string_view name, std::string_view text) {
    key(name);
    string(text);
  }
  void member(std::string_view name, std::uint64_t value) {
    key(name);
    number(value);
  }

 private:
  void open(char bracket);
  void close(char bracket);
  /// The line break and comma before a value, if it is in an array.
  void begin_value();
  void begin_line();
  void break_line();

  std::string& out_;
  std::size_t indent_ = 0;
  bool is_one_line_ = false;
  bool is_first_ = true;  ///< the innermost brackets are still empty
  bool has_line_ = true;  ///< the value follows its key, or is the outermost
};

}  // namespace axisc
