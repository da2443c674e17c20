#include "cli/report/json_slices.hpp"

#include <algorithm>
#include <string>

namespace axisc::cli {

namespace {

std::string_view without_blanks(std::string_view text) {
  auto const begin = std::min(text.find_first_not_of(" \t\r\n"), text.size());
  return text.substr(begin);
}

std::size_t string_length(std::string_view text) {
  for (std::size_t i = 1; i < text.size(); ++i) {
    if (text[i] == '\\') {
      ++i;
    } else if (text[i] == '"') {
      return i + 1;
    }
  }
  return text.size();
}

/// Length of the value at the beginning of `text`.
std::size_t value_length(std::string_view text) {
  std::size_t depth = 0;
  for (std::size_t i = 0; i < text.size();) {
    char const character = text[i];
    if (character == '"') {
      i += string_length(text.substr(i));
      if (depth == 0) return i;
      continue;
    }
    bool const opens = character == '{' || character == '[';
    bool const closes = character == '}' || character == ']';
    if (depth == 0 && !opens) return std::min(text.find_first_of(",}] \t\r\n"), text.size());
    if (opens) ++depth;
    if (closes) --depth;
    ++i;
    if (depth == 0) return i;
  }
  return text.size();
}

/// Takes a value and what separates it from the next one.
std::string_view take_value(std::string_view& text) {
  text = without_blanks(text);
  auto const value = text.substr(0, value_length(text));
  text = without_blanks(text.substr(value.size()));
  if (!text.empty() && (text.front() == ',' || text.front() == ':')) {
    text = without_blanks(text.substr(1));
  }
  return value;
}

}  // namespace

std::optional<std::string_view> json_member(std::string_view object, std::string_view key) {
  auto rest = without_blanks(object);
  if (!rest.starts_with('{')) return std::nullopt;
  auto const quoted = "\"" + std::string(key) + "\"";
  for (rest = without_blanks(rest.substr(1)); !rest.empty() && rest.front() != '}';) {
    auto const name = take_value(rest);
    auto const value = take_value(rest);
    if (name == quoted) return value;
  }
  return std::nullopt;
}

std::optional<std::vector<std::string_view>> json_items(std::string_view array) {
  auto rest = without_blanks(array);
  if (!rest.starts_with('[')) return std::nullopt;
  std::vector<std::string_view> items;
  for (rest = without_blanks(rest.substr(1)); !rest.empty() && rest.front() != ']';) {
    items.push_back(take_value(rest));
  }
  return items;
}

}  // namespace axisc::cli
