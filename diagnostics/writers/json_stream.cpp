#include "diagnostics/writers/json_stream.hpp"

#include "diagnostics/terminal.hpp"
#include "diagnostics/utf8.hpp"

#include <algorithm>
#include <cstddef>
#include <string>
#include <string_view>

#include <nlohmann/json.hpp>

namespace axisc {
namespace {

bool needs_no_escape(std::string_view text) {
  if (text.find('"') != std::string_view::npos || text.find('\\') != std::string_view::npos) return false;
  auto const is_control = [](char byte) { return static_cast<unsigned char>(byte) < 0x20; };
  return is_plain(text) ||
         (std::none_of(text.begin(), text.end(), is_control) && valid_utf8_prefix(text) == text.size());
}

/// The text between the quotes.
void append_escaped(std::string& out, std::string_view text) {
  if (needs_no_escape(text)) {
    out += text;
    return;
  }
  std::string const quoted =
      nlohmann::json(text).dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
  out.append(quoted, 1, quoted.size() - 2);
}

}  // namespace

void JsonStream::key(std::string_view name) {
  begin_line();
  ((out_ += '"') += name) += "\": ";
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
  constexpr std::string_view line = "\n                                ";
  std::size_t const blanks = std::min(indent_, line.size() - 1);
  out_.append(line.data(), 1 + blanks);
  if (blanks < indent_) out_.append(indent_ - blanks, ' ');
}

}  // namespace axisc
