#include "axisc/files/csv.hpp"

#include "axisc/asked/quantities.hpp"
#include "axisc/environment/codes.hpp"
#include "axisc/environment/failure.hpp"
#include "diagnostics/ascii.hpp"
#include "diagnostics/format_number.hpp"
#include "diagnostics/terminal.hpp"
#include "diagnostics/utf8.hpp"
#include "presentation/csv_field.hpp"

#include <algorithm>
#include <utility>

namespace axisc::says {

constexpr Sentence empty{"{place}: the CSV file is empty; its first line names the columns",
                         "{place}: die CSV-Datei ist leer; die erste Zeile nennt die Spalten"};
constexpr Sentence unnamed_column{"{place}: a column has no name", "{place}: eine Spalte hat keinen Namen"};
constexpr Sentence duplicate_column{"{place}: column \"{column}\" occurs twice",
                                    "{place}: Spalte \"{column}\" kommt zweimal vor"};
constexpr Sentence unknown_column{
    "{place}: the image does not use column \"{column}\"; it uses {known}",
    "{place}: das Abbild verwendet Spalte \"{column}\" nicht; verwendbar sind {known}"};
constexpr Sentence semicolons{
    "{place}: the columns are separated by semicolons; write commas, and decimal points",
    "{place}: die Spalten sind durch Strichpunkte getrennt; Kommas und Dezimalpunkte schreiben"};
constexpr Sentence fields_of_line{
    "{place}: the number of fields is {fields}, the first line names {columns}",
    "{place}: die Zahl der Felder ist {fields}, die erste Zeile nennt {columns}"};
constexpr Sentence number{
    R"({place}: "{text}" in column "{column}" is not a number; write it with a decimal point)",
    R"({place}: "{text}" in Spalte "{column}" ist keine Zahl; mit Dezimalpunkt schreiben)"};
constexpr Sentence open_quote{"{place}: the quotation mark is not closed",
                              "{place}: das Anführungszeichen ist nicht geschlossen"};
constexpr Sentence long_line{"{place}: the line is longer than 1 MiB; this is not a CSV file",
                             "{place}: die Zeile ist länger als 1 MiB; das ist keine CSV-Datei"};

}  // namespace axisc::says

namespace axisc {

namespace {

constexpr std::size_t longest_shown = 40;

std::uint32_t code_points(std::string_view text) {
  return static_cast<std::uint32_t>(
      std::count_if(text.begin(), text.end(), [](char byte) { return !is_continuation_byte(byte); }));
}

std::string shown(std::string_view text) {
  return repair_utf8(text.size() > longest_shown ? text.substr(0, longest_shown) : text);
}

struct CsvPlace {
  std::string const& file;
  std::uint64_t line;
  std::uint32_t column;
};

/// The closing quote of a field that begins with one; a doubled quote is a character of the field.
std::size_t closing_quote(std::string_view field) {
  std::size_t at = field.find('"', 1);
  while (at != std::string_view::npos && field.substr(at + 1).starts_with('"')) at = field.find('"', at + 2);
  return at;
}

std::string without_doubled_quotes(std::string_view text) {
  std::string name(text);
  for (auto at = name.find("\"\""); at != std::string::npos; at = name.find("\"\"", at + 1)) {
    name.erase(at, 1);
  }
  return name;
}

[[noreturn]] void fail(SentenceRef text, CsvPlace const& place, std::vector<Argument> arguments = {}) {
  arguments.push_back(
      {"place", place.file + ":" + std::to_string(place.line) + ":" + std::to_string(place.column)});
  throw Failure({text, std::move(arguments)}, csv_malformed);
}

}  // namespace

CsvReader::CsvReader(std::string name, ByteSource source)
    : name_(std::move(name)), lines_(std::move(source)) {
  if (!next_line()) fail(says::empty, {name_, 1, 1});
  split_line();
  header_line_ = number_;
  for (auto const& field : fields_) {
    if (field.text.empty()) fail(says::unnamed_column, {name_, number_, field.column});
    std::string column = without_doubled_quotes(field.text);
    if (std::find(header_.begin(), header_.end(), column) != header_.end()) {
      fail(says::duplicate_column, {name_, number_, field.column}, {{"column", shown(column)}});
    }
    header_.push_back(std::move(column));
    header_columns_.push_back(field.column);
  }
}

bool CsvReader::next_line() {
  auto const step = lines_.next(line_);
  if (step == recordings::TextLines::Step::too_long) fail(says::long_line, {name_, lines_.number(), 1});
  number_ = lines_.number();
  return step == recordings::TextLines::Step::line;
}

void CsvReader::split_line() {
  fields_.clear();
  std::uint32_t column = 1;
  for (std::string_view rest = line_;;) {
    while (!rest.empty() && ascii::is_blank(rest.front())) {
      rest.remove_prefix(1);
      ++column;
    }
    bool const quoted = !rest.empty() && rest.front() == '"';
    auto const closing = quoted ? closing_quote(rest) : std::string_view::npos;
    if (quoted && closing == std::string_view::npos) fail(says::open_quote, {name_, number_, column});
    auto const comma = rest.find(',', quoted ? closing : 0);
    auto const raw = rest.substr(0, comma);
    auto text = raw;
    while (!text.empty() && ascii::is_blank(text.back())) text.remove_suffix(1);
    if (quoted && text.back() == '"' && text.size() == closing + 1) {
      text.remove_prefix(1);
      text.remove_suffix(1);
    }
    fields_.push_back({text, column});
    if (comma == std::string_view::npos) return;
    column += code_points(raw) + 1;
    rest.remove_prefix(comma + 1);
  }
}

bool CsvReader::next(std::span<double> row) {
  if (!next_line()) return false;
  split_line();
  if (fields_.size() != header_.size()) {
    auto const at = fields_.size() > header_.size() ? fields_[header_.size()].column : fields_.back().column;
    fail(says::fields_of_line, {name_, number_, at},
         {{"fields", std::to_string(fields_.size())}, {"columns", std::to_string(header_.size())}});
  }
  for (std::size_t i = 0; i < fields_.size(); ++i) {
    auto const value = parse_number(fields_[i].text);
    if (!value) {
      fail(says::number, {name_, number_, fields_[i].column},
           {{"text", shown(fields_[i].text)}, {"column", shown(header_[i])}});
    }
    row[i] = *value;
  }
  return true;
}

void CsvReader::refuse_column(std::size_t index, std::string_view known) const {
  bool const has_semicolons = header_[index].find(';') != std::string::npos;
  fail(has_semicolons ? says::semicolons : says::unknown_column,
       {name_, header_line_, header_columns_[index]},
       {{"column", shown(header_[index])}, {"known", std::string(known)}});
}

std::string csv_name(std::string_view name) {
  return presentation::csv_text(name);
}

void append_csv_name(std::string& line, std::string_view name) {
  presentation::append_csv_field(line, csv_name(name));
}

void append_csv_row(std::string& text, std::span<double const> row) {
  bool first = true;
  for (double const value : row) {
    if (!first) text += ',';
    first = false;
    text += format_exact(value);
  }
  text += '\n';
}

}  // namespace axisc
