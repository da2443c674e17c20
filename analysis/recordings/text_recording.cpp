#include "analysis/recordings/text_recording.hpp"

#include "analysis/recordings/column_layout.hpp"
#include "analysis/recordings/decimal_number.hpp"
#include "analysis/recordings/fields.hpp"
#include "analysis/recordings/header_table.hpp"
#include "analysis/recordings/row_groups.hpp"
#include "analysis/recordings/text_encoding.hpp"

#include <algorithm>
#include <deque>
#include <optional>
#include <utility>

namespace axisc::recordings {

namespace {

/// Of a text without names: they decide which columns are times.
constexpr std::size_t deciding_rows = 256;
/// Bytes before the first row: of thousands of channels.
constexpr std::size_t longest_header = std::size_t{8} << 20U;
/// A comment of a channel may have so many lines that look like rows.
constexpr std::size_t longest_comment = 64;

bool is_end(std::string_view line) {
  constexpr std::string_view around = " \t;,:\"";
  auto const begin = line.find_first_not_of(around);
  if (begin == std::string_view::npos || line[begin] != 'E') return false;
  return line.substr(begin, line.find_last_not_of(around) + 1 - begin) == "EOF";
}

class TextReader {
 public:
  explicit TextReader(ByteSource source) : lines_(as_utf8(std::move(source))) {}

  std::variant<Recording, BadRecording> read() {
    if (!read_header()) return problem_;
    auto table = table_layout(header_, ahead_.front());
    if (auto* const bad = std::get_if<BadRecording>(&table)) return std::move(*bad);
    auto* const described = std::get_if<Layout>(&table);
    RowGroups rows(described != nullptr ? std::move(*described) : columns());
    for (auto const& line : ahead_) {
      if (auto bad = rows.add(line.text, line.number)) return *std::move(bad);
    }
    ahead_.clear();
    std::string_view line;
    while (next(line)) {
      if (auto bad = rows.add(line, lines_.number())) return *std::move(bad);
    }
    if (is_failed_) return problem_;
    return rows.finish();
  }

 private:
  /// False at the end, or where a line is too long.
  bool next(std::string_view& line) {
    auto const step = lines_.next(line);
    if (step == TextLines::Step::too_long) {
      is_failed_ = true;
      problem_ = {.problem = RecordingProblem::long_line, .line = lines_.number()};
    }
    return step == TextLines::Step::line && !is_end(line);
  }

  /// All lines before the first row, which is the first one ahead.
  bool read_header() {
    std::optional<TableKey> key;
    std::size_t header_size = 0;
    for (std::string_view line; next(line);) {
      if (auto const found = table_key(line)) {
        key = found;
      } else if (is_row(line, key)) {
        ahead_.push_back({lines_.number(), std::string(line)});
        if (!key || key->name != "SymbolComment" || !is_comment()) return true;
        key = table_key(header_.back().text);
        continue;
      }
      header_size += line.size();
      if (header_size > longest_header) break;
      header_.push_back({lines_.number(), std::string(line)});
    }
    if (!ahead_.empty()) return true;
    if (!is_failed_) problem_ = {.problem = RecordingProblem::no_rows, .line = lines_.number()};
    return false;
  }

  static bool is_number(std::string_view field) { return parse_number(field).has_value(); }

  /// After a line of names: as many fields, the first one a number, and others that may be empty.
  [[nodiscard]] bool is_first_with_gaps(std::string_view line) const {
    if (header_.empty()) return false;
    char const separator = usual_separator(line);
    std::vector<std::string_view> fields, names;
    split_fields(line, separator, fields);
    split_fields(header_.back().text, separator, names);
    return fields.size() == names.size() && fields.size() > 1 && is_number(fields.front()) &&
           std::none_of(names.begin(), names.end(), is_number) &&
           std::all_of(fields.begin(), fields.end(),
                       [](std::string_view field) { return field.empty() || is_number(field); });
  }

  [[nodiscard]] bool is_row(std::string_view line, std::optional<TableKey> const& key) const {
    auto const usual = fields_of(line, usual_separator(line));
    if (usual.size() > 1 && std::all_of(usual.begin(), usual.end(), is_number)) return true;
    if (!key) return is_first_with_gaps(line);
    auto const fields = fields_of(line, key->separator);
    if (fields.size() < 2) return false;
    bool const is_described = key->name != "Name" && key->name != "SymbolComment";
    if (is_described && is_number(fields.front())) return true;
    return std::any_of(fields.begin(), fields.end(), is_number) &&
           std::all_of(fields.begin(), fields.end(),
                       [](std::string_view field) { return field.empty() || is_number(field); });
  }

  /// A row of the table comes after what looks like a row of numbers: all of that is the header's.
  bool is_comment() {
    for (std::string_view line; ahead_.size() < longest_comment && next(line);) {
      ahead_.push_back({lines_.number(), std::string(line)});
      auto const key = table_key(line);
      if (!key || key->name == "SymbolComment") continue;
      for (auto& each : ahead_) header_.push_back(std::move(each));
      ahead_.clear();
      return true;
    }
    return false;
  }

  Layout columns() {
    std::vector<TextLine> rows(ahead_.begin(), ahead_.end());
    for (std::string_view line; rows.size() < deciding_rows && next(line);) {
      rows.push_back({lines_.number(), std::string(line)});
      ahead_.push_back(rows.back());
    }
    return column_layout(header_, rows);
  }

  TextLines lines_;
  std::vector<TextLine> header_;
  std::deque<TextLine> ahead_;  ///< read, but not used yet
  bool is_failed_ = false;
  BadRecording problem_;
};

}  // namespace

std::variant<Recording, BadRecording> read_text_recording(ByteSource source) {
  return TextReader(std::move(source)).read();
}

}  // namespace axisc::recordings
