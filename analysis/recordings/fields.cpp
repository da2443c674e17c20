#include "analysis/recordings/fields.hpp"

#include <algorithm>
#include <cstddef>

namespace axisc::recordings {

namespace {

bool is_padding(char byte) {
  return byte == ' ' || byte == '\t' || byte == '\r' || byte == '"';
}

std::string_view trimmed(std::string_view text) {
  while (!text.empty() && is_padding(text.front())) text.remove_prefix(1);
  while (!text.empty() && is_padding(text.back())) text.remove_suffix(1);
  return text;
}

void split_at_blanks(std::string_view line, std::vector<std::string_view>& fields) {
  while (!line.empty()) {
    if (line.front() != ' ') {
      auto const size = std::min(line.find(' '), line.size());
      fields.push_back(trimmed(line.substr(0, size)));
      line.remove_prefix(std::min(size + 1, line.size()));
      continue;
    }
    fields.emplace_back();
    line.remove_prefix(line.starts_with("  ") ? 2 : 1);
  }
}

}  // namespace

void split_fields(std::string_view line, char separator, std::vector<std::string_view>& fields) {
  fields.clear();
  if (separator == ' ') {
    split_at_blanks(line, fields);
  } else {
    for (;;) {
      auto const end = line.find(separator);
      fields.push_back(trimmed(line.substr(0, end)));
      if (end == std::string_view::npos) break;
      line.remove_prefix(end + 1);
    }
  }
}

std::vector<std::string_view> fields_of(std::string_view line, char separator) {
  std::vector<std::string_view> fields;
  split_fields(line, separator, fields);
  while (fields.size() > 1 && fields.back().empty()) fields.pop_back();
  return fields;
}

char usual_separator(std::string_view line) {
  for (char const separator : {'\t', ';'}) {
    if (line.find(separator) != std::string_view::npos) return separator;
  }
  return ',';
}

}  // namespace axisc::recordings
