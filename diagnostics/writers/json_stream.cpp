#include "diagnostics/writers/json_stream.hpp"

#include "diagnostics/terminal.hpp"
#include "diagnostics/utf8.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <string>
#include <string_view>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace axisc {
namespace {

bool needs_no_escape(std::string_view text) {
  if (text.find('"') != std::string_view::npos || text.find('\\') != std::string_view::npos) return false;
  return is_plain(text) || (is_visible(text) && valid_utf8_prefix(text) == text.size());
}

void append_escape(std::string& out, char32_t character) {
  constexpr char32_t first_of_pairs = 0x10000;
  if (character < first_of_pairs) {
    fmt::format_to(std::back_inserter(out), "\\u{:04x}", static_cast<std::uint32_t>(character));
    return;
  }
  char32_t const rest = character - first_of_pairs;
  append_escape(out, 0xD800 + (rest >> 10U));
  append_escape(out, 0xDC00 + (rest & 0x3FFU));
}

/// The text between the quotes.
void append_escaped(std::string& out, std::string_view text) {
  if (needs_no_escape(text)) {
    out += text;
    return;
  }
  std::string const quoted = json_string(text);
  out.append(quoted, 1, quoted.size() - 2);
}

}  // namespace

std::string escape_invisible(std::string json) {
  constexpr char32_t delete_character = 0x7F;
  auto const is_ascii = [](char byte) { return static_cast<unsigned char>(byte) < delete_character; };
  if (std::all_of(json.begin(), json.end(), is_ascii)) return json;
  std::string escaped;
  for (std::string_view rest = json; !rest.empty();) {
    DecodedCharacter const character = decode_utf8(rest);
    // Invisible characters of ASCII are escaped already, or between the values.
    if (character.value >= delete_character && !is_visible(character.value)) {
      append_escape(escaped, character.value);
    } else {
      escaped += rest.substr(0, character.size);
    }
    rest.remove_prefix(character.size);
  }
  return escaped;
}

std::string json_string(std::string_view text) {
  return escape_invisible(
      nlohmann::json(text).dump(-1, ' ', false, nlohmann::json::error_handler_t::replace));
}

void JsonStream::key(std::string_view name) {
  begin_line();
  ((out_ += '"') += name) += is_one_line_ ? "\":" : "\": ";
  has_line_ = true;
}

void JsonStream::string(std::string_view text) {
  begin_value();
  out_ += '"';
  // Line by line: in most messages of several lines only the line ends need an escape.
  for (std::size_t end = text.find('\n'); end != std::string_view::npos; end = text.find('\n')) {
    append_escaped(out_, text.substr(0, end));
    out_ += "\\n";
    text.remove_prefix(end + 1);
  }
  append_escaped(out_, text);
  out_ += '"';
}

void JsonStream::string_or_null(std::string_view text) {
  if (text.empty()) {
    null();
  } else {
    string(text);
  }
}

void JsonStream::number(std::uint64_t value) {
  raw(std::to_string(value));
}

void JsonStream::boolean(bool value) {
  raw(value ? "true" : "false");
}

void JsonStream::null() {
  raw("null");
}

void JsonStream::raw(std::string_view text) {
  begin_value();
  out_ += text;
}

void JsonStream::open(char bracket) {
  begin_value();
  out_ += bracket;
  indent_ += 2;
  is_first_ = true;
}

void JsonStream::close(char bracket) {
  indent_ -= 2;
  if (!is_first_) break_line();
  out_ += bracket;
  is_first_ = false;
}

void JsonStream::begin_value() {
  if (!has_line_) begin_line();
  has_line_ = false;
}

void JsonStream::begin_line() {
  if (!is_first_) out_ += ',';
  break_line();
  is_first_ = false;
}

void JsonStream::break_line() {
  if (is_one_line_) return;
  constexpr std::string_view line = "\n                                ";
  std::size_t const blanks = std::min(indent_, line.size() - 1);
  out_.append(line.data(), 1 + blanks);
  if (blanks < indent_) out_.append(indent_ - blanks, ' ');
}

}  // namespace axisc
