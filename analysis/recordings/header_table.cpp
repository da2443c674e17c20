#include "analysis/recordings/header_table.hpp"

#include "analysis/recordings/decimal_number.hpp"
#include "analysis/recordings/fields.hpp"
#include "analysis/recordings/text_encoding.hpp"
#include "diagnostics/ascii.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <utility>

namespace axisc::recordings {

namespace {

/// One that begins with another one stands before it.
constexpr std::array<std::string_view, 20> keys{"Unit ScaleFactor",
                                                "Unit Offset",
                                                "SymbolComment",
                                                "SampleTime[ms]",
                                                "VariableSize",
                                                "SymbolBased",
                                                "IndexOffset",
                                                "IndexGroup",
                                                "SymbolName",
                                                "ScaleFactor",
                                                "Data-Type",
                                                "StartTime",
                                                "EndTime",
                                                "BitMask",
                                                "Offset",
                                                "NetID",
                                                "NetId",
                                                "Name",
                                                "Port",
                                                "Unit"};
/// Their values have no blanks, so that they show the groups whatever separates.
constexpr std::array<std::string_view, 7> shaping{"Data-Type", "IndexGroup",   "Port",   "NetID",
                                                  "NetId",     "VariableSize", "BitMask"};
constexpr std::string_view separators = "\t;,: ";

using Values = std::vector<std::string>;

/// By field: is it the key?
using Shape = std::vector<bool>;

Shape shape_of(std::string_view line, TableKey const& key) {
  Shape shape;
  for (auto const field : fields_of(line, key.separator)) shape.push_back(field == key.name);
  return shape;
}

/// Every group has a channel.
bool is_sound(Shape const& shape) {
  if (shape.size() < 2 || !shape.front() || shape.back()) return false;
  for (std::size_t i = 1; i < shape.size(); ++i) {
    if (shape[i] && shape[i - 1]) return false;
  }
  return true;
}

/// The field at the front, which it removes with the separator after it.
std::string_view take_field(std::string_view& line, char separator) {
  auto size = line.find(separator);
  if (line.starts_with('"')) {
    auto const quote = line.find('"', 1);
    bool const is_quoted =
        quote != std::string_view::npos && (quote + 1 == line.size() || line[quote + 1] == separator);
    if (is_quoted) size = quote + 1;
  }
  size = std::min(size, line.size());
  auto field = line.substr(0, size);
  line.remove_prefix(std::min(size + 1, line.size()));
  if (field.size() > 1 && field.starts_with('"') && field.ends_with('"')) {
    field = field.substr(1, field.size() - 2);
  }
  return field;
}

/// The values of a row; none where it does not split into these groups, as with names that contain the
/// separator.
std::optional<Values> split_by(Shape const& shape, std::string_view line, TableKey const& key) {
  Values values;
  for (bool const is_key : shape) {
    if (is_key) {
      if (!line.starts_with(key.name)) return std::nullopt;
      line.remove_prefix(key.name.size());
      if (!line.empty() && line.front() != key.separator) return std::nullopt;
      line.remove_prefix(std::min<std::size_t>(1, line.size()));
    } else {
      auto const field = take_field(line, key.separator);
      values.push_back(utf8_text(ascii::trimmed(field)));
    }
  }
  bool const is_complete = line.find_first_not_of(key.separator) == std::string_view::npos;
  return is_complete ? std::optional(std::move(values)) : std::nullopt;
}

/// The rows of a table, by key.
class Table {
 public:
  Table(Shape shape, char separator) : shape_(std::move(shape)), separator_(separator) {}

  void add(std::string_view line, TableKey const& key) {
    if (key.separator != separator_ || rows_.contains(key.name)) return;
    if (auto values = split_by(shape_, line, key)) rows_.emplace(key.name, *std::move(values));
  }
  [[nodiscard]] std::string text(std::string_view key, std::size_t channel) const {
    auto const found = rows_.find(key);
    return found == rows_.end() ? std::string() : found->second.at(channel);
  }
  [[nodiscard]] bool has(std::string_view key) const { return rows_.contains(key); }

  [[nodiscard]] Layout layout() const {
    Layout made{.separator = separator_, .fields = shape_.size(), .groups = {}, .recording = {}};
    auto& recording = made.recording;
    recording.form = Form::scope_text;
    recording.is_named = has("Name") || has("SymbolName");
    for (std::size_t field = 0; field < shape_.size(); ++field) {
      if (shape_[field]) {
        made.groups.push_back(
            {.first = field, .clock = recording.clocks.size(), .channel = recording.channels.size()});
        recording.clocks.emplace_back();
        made.units.emplace_back(TimeUnit::milliseconds);
      } else {
        ++made.groups.back().values;
        recording.channels.push_back(channel(recording.channels.size(), field));
        recording.channels.back().clock = recording.clocks.size() - 1;
        auto& sample_time = recording.clocks.back().sample_time;
        if (!sample_time) sample_time = number("SampleTime[ms]", recording.channels.size() - 1);
      }
    }
    return made;
  }

 private:
  [[nodiscard]] std::optional<double> number(std::string_view key, std::size_t channel) const {
    auto const parsed = parse_number(text(key, channel));
    if (!parsed || !std::isfinite(parsed->value)) return std::nullopt;
    return parsed->value;
  }
  [[nodiscard]] Channel channel(std::size_t index, std::size_t field) const {
    Channel made{.name = text(has("Name") ? "Name" : "SymbolName", index), .column = field + 1};
    if (made.name.empty()) made.name = std::to_string(field + 1);
    made.symbol = text("SymbolName", index);
    made.data_type = text("Data-Type", index);
    made.unit = text("Unit", index);
    made.port = parse_whole(text("Port", index));
    made.index_group = parse_whole(text("IndexGroup", index));
    made.index_offset = parse_whole(text("IndexOffset", index));
    made.scale = {.factor = number("ScaleFactor", index).value_or(1),
                  .offset = number("Offset", index).value_or(0),
                  .unit_factor = number("Unit ScaleFactor", index).value_or(1),
                  .unit_offset = number("Unit Offset", index).value_or(0)};
    return made;
  }

  Shape shape_;
  char separator_;
  std::map<std::string_view, Values> rows_;
};

/// A row of numbers or blanks that ends where a group ends.
bool fits(TextLine const& row, Shape const& shape, char separator) {
  auto const fields = fields_of(row.text, separator);
  bool const ends_with_group = fields.size() == shape.size() ||
                               (fields.size() < shape.size() && fields.size() > 1 && shape[fields.size()]);
  return ends_with_group && std::all_of(fields.begin(), fields.end(), [](std::string_view field) {
           return field.empty() || parse_number(field).has_value();
         });
}

/// The last line before the rows is not of a table.
bool names_columns(TextLine const& last, TextLine const& first_row) {
  if (table_key(last.text)) return false;
  char const separator = usual_separator(first_row.text);
  auto const fields = fields_of(first_row.text, separator).size();
  return fields > 1 && fields_of(last.text, separator).size() == fields;
}

}  // namespace

std::optional<TableKey> table_key(std::string_view line) {
  for (auto const key : keys) {
    bool const is_key = line.size() > key.size() && line.starts_with(key) &&
                        separators.find(line[key.size()]) != std::string_view::npos;
    if (is_key) return TableKey{.name = key, .separator = line[key.size()]};
  }
  return std::nullopt;
}

std::variant<std::monostate, Layout, BadRecording> table_layout(std::vector<TextLine> const& header,
                                                                TextLine const& first_row) {
  TextLine const* shaping_row = nullptr;
  TextLine const* name_row = nullptr;
  std::optional<char> separator;
  for (auto line = header.rbegin(); line != header.rend(); ++line) {
    auto const key = table_key(line->text);
    if (!key || (separator && key->separator != *separator)) continue;
    if (key->name == "Name") {
      name_row = &*line;
      break;
    }
    if (std::find(shaping.begin(), shaping.end(), key->name) == shaping.end()) continue;
    shaping_row = &*line;
    separator = key->separator;
  }
  std::size_t begin = name_row == nullptr ? 0 : static_cast<std::size_t>(name_row - header.data());
  bool const is_preamble = begin + 1 < header.size() && header[begin + 1].text.starts_with("File");
  if (name_row != nullptr && is_preamble) ++begin;
  bool const is_certain = shaping_row != nullptr;
  auto const* const row = is_certain ? shaping_row : name_row;
  if (row == nullptr) return std::monostate();
  auto const key = *table_key(row->text);
  auto const shape = shape_of(row->text, key);
  if (names_columns(header.back(), first_row)) return std::monostate();
  if (!is_certain && (!is_sound(shape) || !fits(first_row, shape, key.separator))) return std::monostate();
  if (!is_sound(shape)) {
    return BadRecording{
        .problem = RecordingProblem::bad_table, .line = row->number, .text = std::string(key.name)};
  }
  Table table(shape, key.separator);
  for (std::size_t i = begin; i < header.size(); ++i) {
    if (auto const each = table_key(header[i].text)) table.add(header[i].text, *each);
  }
  return table.layout();
}

}  // namespace axisc::recordings
