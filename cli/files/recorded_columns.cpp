#include "cli/files/recorded_columns.hpp"

#include "cli/codes.hpp"
#include "cli/failure.hpp"
#include "cli/files/byte_source.hpp"
#include "cli/options/quantities.hpp"
#include "diagnostics/ascii.hpp"
#include "diagnostics/format_number.hpp"
#include "diagnostics/utf8.hpp"

#include <algorithm>
#include <cmath>
#include <string_view>

namespace axisc::cli::says {

constexpr Sentence no_numbers{"{file} has no line of numbers", "{file} hat keine Zeile mit Zahlen"};
constexpr Sentence no_column{"{file} has no column \"{column}\"; it has {known}",
                             "{file} hat keine Spalte \"{column}\"; vorhanden sind {known}"};
constexpr Sentence which_columns{
    "{file} has the columns {known}; name the setpoint before the filters with --in and behind them with "
    "--out",
    "{file} hat die Spalten {known}; den Sollwert vor den Filtern mit --in und den dahinter mit --out "
    "nennen"};
constexpr Sentence bad_field{"{file}:{line}: \"{text}\" is not a number",
                             "{file}:{line}: \"{text}\" ist keine Zahl"};
constexpr Sentence few_fields{
    "{file}:{line}: the line has {fields} fields, the first line of numbers {columns}",
    "{file}:{line}: die Zeile hat {fields} Felder, die erste mit Zahlen {columns}"};
constexpr Sentence mixed_marks{
    "{file}:{line}: the column has decimal commas and decimal points; write it without thousands separators",
    "{file}:{line}: die Spalte hat Dezimalkommas und Dezimalpunkte; ohne Tausendertrennzeichen schreiben"};
constexpr Sentence other_cycle{
    "{file}:{line}: {step} ms passed since the line before, which is not a whole number of cycles of {cycle} "
    "ms; "
    "record with the NC cycle",
    "{file}:{line}: seit der Zeile davor vergingen {step} ms, das ist keine ganze Zahl von Zyklen von "
    "{cycle} ms; "
    "mit dem NC-Zyklus aufzeichnen"};
constexpr Sentence long_recording_line{"{file}:{line}: the line is longer than 1 MiB",
                                       "{file}:{line}: die Zeile ist länger als 1 MiB"};

}  // namespace axisc::cli::says

namespace axisc::cli {

namespace {

constexpr std::size_t piece = std::size_t{1} << 16U;
constexpr std::size_t longest_line = std::size_t{1} << 20U;
constexpr std::size_t longest_shown = 40;
/// A longer pause is not a lost sample.
constexpr double longest_gap = 1000;
constexpr double cycle_tolerance = 0.1;

using Fields = std::vector<std::string_view>;

class Lines {
 public:
  explicit Lines(std::string const& path) : path_(path), source_(open_source(path)) {}

  bool next(std::string_view& line) {
    for (;;) {
      auto const end = buffer_.find('\n', used_);
      if (end != std::string::npos || ended_) {
        if (used_ == buffer_.size()) return false;
        auto const stop = std::min(end, buffer_.size());
        line = std::string_view(buffer_).substr(used_, stop - used_);
        used_ = std::min(stop + 1, buffer_.size());
        ++number_;
        if (number_ == 1 && line.starts_with("\xEF\xBB\xBF")) line.remove_prefix(3);
        while (!line.empty() && (ascii::is_blank(line.back()) || line.back() == '\r')) line.remove_suffix(1);
        return true;
      }
      fill();
    }
  }
  [[nodiscard]] std::uint64_t number() const { return number_; }
  [[noreturn]] void fail(SentenceRef sentence, std::vector<Argument> arguments = {}) const {
    arguments.push_back({"file", path_});
    arguments.push_back({"line", std::to_string(number_)});
    throw Failure({.sentence = sentence, .arguments = std::move(arguments)}, csv_malformed);
  }

 private:
  void fill() {
    buffer_.erase(0, used_);
    used_ = 0;
    if (buffer_.size() > longest_line) fail(says::long_recording_line);
    auto const filled = buffer_.size();
    buffer_.resize(filled + piece);
    auto const got = source_({buffer_.data() + filled, piece});
    buffer_.resize(filled + got);
    ended_ = got == 0;
  }

  std::string const& path_;
  ByteSource source_;
  std::string buffer_;
  std::size_t used_ = 0;
  std::uint64_t number_ = 0;
  bool ended_ = false;
};

char separator_of(std::string_view line) {
  for (char const separator : {'\t', ';'}) {
    if (line.find(separator) != std::string_view::npos) return separator;
  }
  return ',';
}

void split(std::string_view line, char separator, Fields& fields) {
  fields.clear();
  for (;;) {
    auto const end = line.find(separator);
    auto field = line.substr(0, end);
    while (!field.empty() && (ascii::is_blank(field.front()) || field.front() == '"')) field.remove_prefix(1);
    while (!field.empty() && (ascii::is_blank(field.back()) || field.back() == '"')) field.remove_suffix(1);
    fields.push_back(field);
    if (end == std::string_view::npos) break;
    line.remove_prefix(end + 1);
  }
  if (fields.size() > 1 && fields.back().empty()) fields.pop_back();
}

std::optional<double> number_of(std::string_view field) {
  auto const comma = field.find(',');
  if (comma == std::string_view::npos) return parse_finite(field);
  if (field.find('.') != std::string_view::npos) return std::nullopt;
  std::string text(field);
  text[comma] = '.';
  return parse_finite(text);
}

bool is_data(Fields const& fields) {
  return fields.size() >= 2 &&
         std::all_of(fields.begin(), fields.end(), [](auto field) { return number_of(field).has_value(); });
}

struct Column {
  std::size_t index = 0;
  bool has_comma = false, has_point = false;
};

struct Layout {
  char separator = ',';
  std::vector<std::string> names;
  std::optional<Column> time;
  double ms_per_unit = 1;
  Column input, output;
};

bool is_time(std::string_view name) {
  std::string lower(name.substr(0, 4));
  for (char& c : lower) c = static_cast<char>(c >= 'A' && c <= 'Z' ? c + ('a' - 'A') : c);
  return lower == "time" || lower == "zeit";
}

std::string known(std::vector<std::string> const& names) {
  std::string text;
  for (auto const& name : names) {
    text +=
        (text.empty() ? "\"" : ", \"") + repair_utf8(std::string_view(name).substr(0, longest_shown)) + "\"";
  }
  return text;
}

std::size_t index_of(std::string const& wanted, Layout const& layout, Lines const& lines) {
  auto const& names = layout.names;
  auto const found = std::find(names.begin(), names.end(), wanted);
  if (found != names.end()) return static_cast<std::size_t>(found - names.begin());
  auto const number = parse_count(wanted);
  if (number && *number >= 1 && *number <= names.size()) return static_cast<std::size_t>(*number - 1);
  lines.fail(says::no_column, {{"column", wanted}, {"known", known(names)}});
}

void choose_columns(Layout& layout, bool named, WantedColumns const& wanted, Lines const& lines) {
  auto const columns = layout.names.size();
  std::vector<bool> times(columns, false);
  for (std::size_t i = 0; i < columns; ++i) {
    times[i] = named ? is_time(layout.names[i]) : (columns == 4 && i % 2 == 0) || (columns == 3 && i == 0);
  }
  std::vector<std::size_t> values;
  for (std::size_t i = 0; i < columns; ++i) {
    if (!times[i]) values.push_back(i);
  }
  bool const is_clear = values.size() == 2;
  if ((!wanted.input || !wanted.output) && !is_clear) {
    lines.fail(says::which_columns, {{"known", known(layout.names)}});
  }
  layout.input.index = wanted.input ? index_of(*wanted.input, layout, lines) : values[0];
  layout.output.index = wanted.output ? index_of(*wanted.output, layout, lines) : values[1];
  for (std::size_t i = 0; i < layout.input.index; ++i) {
    if (times[i]) layout.time = Column{.index = i};
  }
  if (!layout.time) return;
  std::string_view const name = layout.names[layout.time->index];
  if (name.ends_with("_s") || name.ends_with("[s]")) layout.ms_per_unit = 1000;
}

/// Reads to the first line of numbers, which `fields` then has.
Layout read_layout(Lines& lines, Fields& fields, WantedColumns const& wanted) {
  Layout layout;
  std::vector<std::vector<std::string>> headers;
  for (std::string_view line; lines.next(line);) {
    if (line.empty()) continue;
    layout.separator = separator_of(line);
    split(line, layout.separator, fields);
    if (is_data(fields)) break;
    headers.emplace_back(fields.begin(), fields.end());
    fields.clear();
  }
  if (fields.empty()) lines.fail(says::no_numbers);
  auto const named = std::find_if(headers.rbegin(), headers.rend(),
                                  [&](auto const& header) { return header.size() == fields.size(); });
  if (named != headers.rend()) layout.names = *named;
  for (std::size_t i = layout.names.size(); i < fields.size(); ++i) {
    layout.names.push_back(std::to_string(i + 1));
  }
  choose_columns(layout, named != headers.rend(), wanted, lines);
  return layout;
}

double value(std::string_view field, Column& column, Lines const& lines) {
  auto const parsed = number_of(field);
  if (!parsed) lines.fail(says::bad_field, {{"text", repair_utf8(field.substr(0, longest_shown))}});
  column.has_comma = column.has_comma || field.find(',') != std::string_view::npos;
  column.has_point = column.has_point || field.find('.') != std::string_view::npos;
  if (column.has_comma && column.has_point) lines.fail(says::mixed_marks);
  return *parsed;
}

/// Values between the last one and `next`.
void bridge(std::vector<double>& values, double next, std::size_t missing) {
  double const last = values.back();
  for (std::size_t i = 1; i <= missing; ++i) {
    values.push_back(last + (next - last) * static_cast<double>(i) / static_cast<double>(missing + 1));
  }
}

}  // namespace

RecordedColumns read_recorded_columns(std::string const& path, WantedColumns const& wanted,
                                      design::CycleTime cycle_time) {
  Lines lines(path);
  Fields fields;
  auto layout = read_layout(lines, fields, wanted);
  RecordedColumns recorded{.input_name = layout.names[layout.input.index],
                           .output_name = layout.names[layout.output.index],
                           .input = {},
                           .output = {},
                           .gaps = {}};
  double const cycle_ms = cycle_time.microseconds() / 1000;
  double last_time = 0;
  for (std::string_view line;;) {
    if (fields.size() != layout.names.size()) {
      lines.fail(says::few_fields, {{"fields", std::to_string(fields.size())},
                                    {"columns", std::to_string(layout.names.size())}});
    }
    double const input = value(fields[layout.input.index], layout.input, lines);
    double const output = value(fields[layout.output.index], layout.output, lines);
    bool is_repeated = false;
    if (layout.time) {
      double const time = value(fields[layout.time->index], *layout.time, lines) * layout.ms_per_unit;
      double const cycles = recorded.input.empty() ? 1 : (time - last_time) / cycle_ms;
      double const whole = std::round(cycles);
      if (std::abs(cycles - whole) > cycle_tolerance || whole < 0 || whole > longest_gap) {
        lines.fail(says::other_cycle,
                   {{"step", format_rounded(cycles * cycle_ms, 6)}, {"cycle", format_rounded(cycle_ms, 6)}});
      }
      is_repeated = whole == 0;
      auto const missing = whole > 1 ? static_cast<std::size_t>(whole) - 1 : 0;
      for (std::size_t i = 0; i < missing; ++i) recorded.gaps.push_back(recorded.input.size() + i);
      if (missing > 0) {
        bridge(recorded.input, input, missing);
        bridge(recorded.output, output, missing);
      }
      last_time = time;
    }
    if (is_repeated) {
      ++recorded.repeated;
    } else {
      recorded.input.push_back(input);
      recorded.output.push_back(output);
    }
    do {
      if (!lines.next(line) || line == "EOF") return recorded;
    } while (line.empty());
    split(line, layout.separator, fields);
  }
}

}  // namespace axisc::cli
