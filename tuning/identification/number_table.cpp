#include "tuning/identification/number_table.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <optional>

namespace axisc::tuning {
namespace {

constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";

std::string_view trimmed(std::string_view text) {
  constexpr std::string_view blanks = " \t\r\"";
  auto const first = text.find_first_not_of(blanks);
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(blanks) - first + 1);
}

std::vector<std::string_view> split(std::string_view line, char separator) {
  std::vector<std::string_view> fields;
  for (;;) {
    auto const end = line.find(separator);
    fields.push_back(trimmed(line.substr(0, end)));
    if (end == std::string_view::npos) break;
    line.remove_prefix(end + 1);
  }
  // Many programs end a row with a separator.
  if (fields.size() > 1 && fields.back().empty()) fields.pop_back();
  return fields;
}

std::optional<double> number(std::string_view field, bool decimal_comma) {
  std::string text(field);
  if (decimal_comma) std::replace(text.begin(), text.end(), ',', '.');
  if (text.starts_with('+')) text.erase(0, 1);
  double value = 0;
  auto const [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size() || !std::isfinite(value)) return std::nullopt;
  return value;
}

struct Line {
  std::size_t number = 0;
  std::vector<std::string_view> fields;
};

/// The lines that are not blank.
std::vector<Line> lines_of(std::string_view bytes) {
  if (bytes.starts_with(byte_order_mark)) bytes.remove_prefix(byte_order_mark.size());
  char separator = ',';
  if (bytes.find('\t') != std::string_view::npos) {
    separator = '\t';
  } else if (bytes.find(';') != std::string_view::npos) {
    separator = ';';
  }
  std::vector<Line> lines;
  for (std::size_t n = 1; !bytes.empty(); ++n) {
    auto const end = bytes.find('\n');
    auto const line = bytes.substr(0, end);
    bytes.remove_prefix(end == std::string_view::npos ? bytes.size() : end + 1);
    if (trimmed(line) == "EOF") break;
    if (!trimmed(line).empty()) lines.push_back({.number = n, .fields = split(line, separator)});
  }
  return lines;
}

bool is_row(Line const& line) {
  return line.fields.size() > 1 &&
         std::all_of(line.fields.begin(), line.fields.end(),
                     [](std::string_view field) { return number(field, true).has_value(); });
}

}  // namespace

std::variant<NumberTable, BadMeasurement> read_number_table(std::string_view bytes) {
  auto const lines = lines_of(bytes);
  auto const first = std::find_if(lines.begin(), lines.end(), is_row);
  if (lines.end() - first < 2) return BadMeasurement{.problem = MeasurementProblem::no_rows};
  auto const width = first->fields.size();
  NumberTable table{.names = {}, .columns = std::vector<std::vector<double>>(width), .lines = {}};
  bool const is_named = first != lines.begin() && (first - 1)->fields.size() == width;
  for (std::size_t i = 0; i < width; ++i) {
    table.names.push_back(is_named ? std::string((first - 1)->fields[i]) : std::to_string(i + 1));
  }
  std::vector<bool> has_point(width), has_comma(width);
  for (auto line = first; line != lines.end(); ++line) {
    if (line->fields.size() != width) {
      return BadMeasurement{.problem = MeasurementProblem::field_count, .line = line->number};
    }
    for (std::size_t i = 0; i < width; ++i) {
      auto const field = line->fields[i];
      if (field.find('.') != std::string_view::npos) has_point[i] = true;
      if (field.find(',') != std::string_view::npos) has_comma[i] = true;
      auto const value = number(field, true);
      if (!value) return BadMeasurement{.problem = MeasurementProblem::not_a_number, .line = line->number};
      table.columns[i].push_back(*value);
    }
    table.lines.push_back(line->number);
  }
  for (std::size_t i = 0; i < width; ++i) {
    if (!has_point[i] || !has_comma[i]) continue;
    return BadMeasurement{.problem = MeasurementProblem::mixed_numbers, .column = table.names[i]};
  }
  return table;
}

}  // namespace axisc::tuning
