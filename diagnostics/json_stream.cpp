#include "diagnostics/json_stream.hpp"

#include "diagnostics/utf8.hpp"

#include <algorithm>
#include <cstddef>
#include <string>
#include <string_view>

#include <nlohmann/json.hpp>

namespace axisc {
namespace {

bool needs_no_escape(std::string_view text) {
  auto const is_special = [](char byte) {
    return static_cast<unsigned char>(byte) < 0x20 || byte == '"' || byte == '\\';
  };
  return std::none_of(text.begin(), text.end(), is_special) && valid_utf8_prefix(text) == text.size();
}

}  // namespace

void JsonStream::key(std::string_view name) {
  begin_line();
  out_ += '"';
  out_ += name;
  out_ += "\": ";
  has_line_ = true;
}

void JsonStream::string(std::string_view text) {
  begin_value();
  if (!needs_no_escape(text)) {
    out_ += nlohmann::json(text).dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
    return;
  }
  out_ += '"';
  out_ += text;
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
  out_ += line.substr(0, 1 + blanks);
  out_.append(indent_ - blanks, ' ');
}

}  // namespace axisc
