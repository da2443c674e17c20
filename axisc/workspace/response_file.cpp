#include "axisc/workspace/response_file.hpp"

#include "axisc/environment/failure.hpp"
#include "axisc/files/disk_files.hpp"
#include "diagnostics/utf8.hpp"

#include <algorithm>
#include <string_view>
#include <utility>
#include <variant>

#include <climits>

namespace axisc::says {

constexpr Sentence nested{
    "{place}: a response file cannot name another one; write ./{name} for a file of that name",
    "{place}: eine Antwortdatei kann keine weitere nennen; eine Datei dieses Namens als ./{name} angeben"};
constexpr Sentence response_long{
    "{place}: a name of {length} bytes is not a path; a response file has one path per line, or a NUL after "
    "each",
    "{place}: ein Name von {length} Bytes ist kein Pfad; eine Antwortdatei hat einen Pfad je Zeile oder ein "
    "NUL nach jedem"};
constexpr Sentence empty{"{file} names no input", "{file} nennt keine Eingabe"};

}  // namespace axisc::says

namespace axisc {

namespace {

/// 'it'\''s' means it's, as in a shell.
std::string without_quotes(std::string_view name) {
  if (name.size() < 2 || !name.starts_with('\'') || !name.ends_with('\'')) return std::string(name);
  std::string plain(name.substr(1, name.size() - 2));
  constexpr std::string_view quote = "'\\''";
  for (auto at = plain.find(quote); at != std::string::npos; at = plain.find(quote, at + 1)) {
    plain.replace(at, quote.size(), "'");
  }
  return plain;
}

void add_path(std::vector<NamedInput>& inputs, std::string name, std::string place) {
  if (name.starts_with('@')) {
    throw Failure({says::nested, {{"place", std::move(place)}, {"name", std::move(name)}}});
  }
  if (name.size() >= PATH_MAX) {
    throw Failure(
        {says::response_long, {{"place", std::move(place)}, {"length", std::to_string(name.size())}}});
  }
  inputs.push_back({.path = std::move(name), .place = std::move(place)});
}

void read_response_file(std::string const& file, std::vector<NamedInput>& inputs) {
  auto const bytes = read_whole(file);
  // As shells of Windows write them.
  if (bytes.starts_with("\xFF\xFE") || bytes.starts_with("\xFE\xFF")) {
    throw unreadable(file, configuration::FileError::utf16);
  }
  bool const has_nul = bytes.find('\0') != std::string::npos;
  auto const before = inputs.size();
  std::size_t number = 0;
  for (std::string_view rest = without_byte_order_mark(bytes); !rest.empty();) {
    auto const end = std::min(rest.find(has_nul ? '\0' : '\n'), rest.size());
    auto name = rest.substr(0, end);
    rest.remove_prefix(std::min(end + 1, rest.size()));
    ++number;
    if (!has_nul && name.ends_with('\r')) name.remove_suffix(1);
    if (name.empty()) continue;
    add_path(inputs, has_nul ? std::string(name) : without_quotes(name), file + ":" + std::to_string(number));
  }
  if (inputs.size() == before) {
    throw Failure({says::empty, {{"file", file}}});
  }
}

}  // namespace

std::vector<NamedInput> read_response_files(std::vector<std::string> const& words) {
  std::vector<NamedInput> inputs;
  for (auto const& word : words) {
    if (word.size() > 1 && word.front() == '@') {
      read_response_file(word.substr(1), inputs);
    } else {
      inputs.push_back({.path = word});
    }
  }
  return inputs;
}

}  // namespace axisc
