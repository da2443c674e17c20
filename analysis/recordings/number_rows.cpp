#include "analysis/recordings/number_rows.hpp"

#include "diagnostics/utf8.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

namespace axisc::recordings {

namespace {

constexpr std::size_t longest_shown = 40;
constexpr std::size_t longest_number = 400;

bool is_padding(char byte) {
  return byte == ' ' || byte == '\t' || byte == '\r' || byte == '"';
}

std::string_view trimmed(std::string_view text) {
  while (!text.empty() && is_padding(text.front())) text.remove_prefix(1);
  while (!text.empty() && is_padding(text.back())) text.remove_suffix(1);
  return text;
}

std::optional<double> parse(std::string_view text) {
  if (text.starts_with('+') && !text.starts_with("+-")) text.remove_prefix(1);
  double value = 0;
  auto const* const end = text.data() + text.size();
  auto const [stop, error] = std::from_chars(text.data(), end, value);
  if (error != std::errc{} || stop != end) return std::nullopt;
  return value;
}

std::optional<double> parse_with_comma(std::string_view field, std::size_t comma) {
  std::array<char, longest_number> text{};
  if (field.size() > text.size() || field.find('.') != std::string_view::npos) return std::nullopt;
  std::copy(field.begin(), field.end(), text.begin());
  text.at(comma) = '.';
  return parse({text.data(), field.size()});
}

char separator_of(std::string_view line) {
  for (char const separator : {'\t', ';'}) {
    if (line.find(separator) != std::string_view::npos) return separator;
  }
  return ',';
}

}  // namespace

std::optional<double> NumberRows::number_of(std::string_view field) const {
  auto const comma = field.find(',');
  auto const value = comma == std::string_view::npos ? parse(field) : parse_with_comma(field, comma);
  return value && (accepts_ == Accepts::any || std::isfinite(*value)) ? value : std::nullopt;
}

void NumberRows::split(std::string_view line) {
  fields_.clear();
  for (;;) {
    auto const end = line.find(separator_);
    fields_.push_back(trimmed(line.substr(0, end)));
    if (end == std::string_view::npos) break;
    line.remove_prefix(end + 1);
  }
  if (fields_.size() > 1 && fields_.back().empty()) fields_.pop_back();
}

NumberRows::NumberRows(ByteSource source, Accepts accepts) : lines_(std::move(source)), accepts_(accepts) {
  // Headers may be long; only the last one of each width can name the columns.
  std::vector<std::vector<std::string>> headers;
  for (std::string_view line; !has_first_;) {
    auto const step = lines_.next(line);
    if (step == TextLines::Step::too_long) fail({.problem = RowProblem::long_line, .line = lines_.number()});
    if (step == TextLines::Step::end || trimmed(line) == "EOF") {
      fail({.problem = RowProblem::no_rows, .line = lines_.number()});
    }
    if (problem_) return;
    separator_ = separator_of(line);
    split(line);
    has_first_ = fields_.size() > 1 && std::all_of(fields_.begin(), fields_.end(),
                                                   [&](auto field) { return number_of(field).has_value(); });
    if (has_first_) break;
    std::erase_if(headers, [&](auto const& header) { return header.size() == fields_.size(); });
    headers.emplace_back(fields_.begin(), fields_.end());
  }
  auto const named = std::find_if(headers.begin(), headers.end(),
                                  [&](auto const& header) { return header.size() == fields_.size(); });
  is_named_ = named != headers.end();
  if (is_named_) names_ = std::move(*named);
  for (std::size_t i = names_.size(); i < fields_.size(); ++i) names_.push_back(std::to_string(i + 1));
  is_read_.assign(names_.size(), true);
  marks_.resize(names_.size());
}

void NumberRows::read_only(std::vector<std::size_t> const& columns) {
  is_read_.assign(names_.size(), false);
  for (auto const column : columns) is_read_.at(column) = true;
}

NumberRows::Step NumberRows::fail(BadRow bad) {
  problem_ = std::move(bad);
  return Step::bad;
}

NumberRows::Step NumberRows::next(std::span<double> row) {
  if (problem_) return Step::bad;
  if (!has_first_) {
    std::string_view line;
    auto const step = lines_.next(line);
    if (step == TextLines::Step::too_long) {
      return fail({.problem = RowProblem::long_line, .line = lines_.number()});
    }
    if (step == TextLines::Step::end || trimmed(line) == "EOF") return Step::end;
    split(line);
  }
  has_first_ = false;
  if (fields_.size() != names_.size()) {
    return fail({.problem = RowProblem::field_count, .line = lines_.number(), .fields = fields_.size()});
  }
  for (std::size_t i = 0; i < fields_.size(); ++i) {
    if (!is_read_[i]) continue;
    auto const field = fields_[i];
    auto const value = number_of(field);
    if (!value) {
      return fail({.problem = RowProblem::not_a_number,
                   .line = lines_.number(),
                   .column = i,
                   .text = repair_utf8(field.substr(0, longest_shown))});
    }
    auto& marks = marks_[i];
    marks.comma = marks.comma || field.find(',') != std::string_view::npos;
    marks.point = marks.point || field.find('.') != std::string_view::npos;
    if (marks.comma && marks.point) {
      return fail({.problem = RowProblem::mixed_marks, .line = lines_.number(), .column = i});
    }
    row[i] = *value;
  }
  return Step::row;
}

}  // namespace axisc::recordings
