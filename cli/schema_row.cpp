#include "cli/schema_row.hpp"

#include "cli/schema_words.hpp"
#include "diagnostics/ascii.hpp"
#include "schema/indexed_name.hpp"
#include "validator/build_version.hpp"
#include "validator/reading.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <string>
#include <string_view>
#include <utility>

namespace axisc::cli {

namespace {

using schema::DataType;
using validator::JsonKind;
using validator::JsonMember;
using validator::JsonValue;

constexpr std::string_view keys =
    "id, name, type, array, default, unit, minimum, exclusive_minimum, maximum, exclusive_maximum, symbols, "
    "number_names, max_length, axis_types, since";
constexpr double most_entries = 1000;
constexpr double highest_symbol = 65535;
constexpr double longest_string = 255;

bool is_whole(JsonValue const& value, double lowest, double highest) {
  return value.kind == JsonKind::number && value.number == std::floor(value.number) &&
         value.number >= lowest && value.number <= highest;
}

std::string sizes_text(std::array<std::uint16_t, 2> const& array) {
  return array[1] == 0 ? std::to_string(array[0])
                       : std::to_string(array[0]) + " x " + std::to_string(array[1]);
}

class EntryReader {
 public:
  EntryReader(LocatedFile const& file, JsonValue const& entry, schema::Catalogue const& catalogue)
      : file_(file), entry_(entry), catalogue_(catalogue) {}

  SchemaEntry read() {
    if (entry_.kind != JsonKind::object) file_.refuse(entry_.span, Text::schema_row);
    read_name();
    read_type();
    for (auto const& member : entry_.members) read_member(member, file_[member.value]);
    require_array();
    require_limits();
    require_symbols();
    require_default();
    row_.file = file_.path();
    return {.row = std::move(row_), .named = std::move(named_), .span = name_span_};
  }

 private:
  [[nodiscard]] JsonMember const* member(std::string_view key) const {
    auto const found = std::find_if(entry_.members.begin(), entry_.members.end(),
                                    [key](JsonMember const& each) { return each.key == key; });
    return found == entry_.members.end() ? nullptr : &*found;
  }

  /// Where a key's value stands; the name where the entry does not have the key.
  [[nodiscard]] Span span_of(std::string_view key) const {
    auto const* const found = member(key);
    return found == nullptr ? name_span_ : file_[found->value].span;
  }

  [[nodiscard]] Argument type_argument() const {
    return {"type", std::string(schema::data_type_name(row_.type))};
  }
  [[nodiscard]] Argument parameter() const { return {"parameter", row_.name}; }

  void read_name() {
    auto const* const found = member("name");
    if (found == nullptr) file_.refuse(entry_.span, Text::schema_row);
    auto const& value = file_[found->value];
    name_span_ = value.span;
    std::string const& name = file_.text(value);
    if (!is_parameter_pattern(name)) file_.refuse(value.span, Text::schema_name, {{"value", name}});
    for (auto const& known : catalogue_.parameters()) {
      if (known.name == name) {
        known_ = &known;
        row_ = schema::ParameterRow::from(known);
        return;
      }
    }
    // Most names exist with one set of indices; lists mean the same parameter by all of them.
    for (auto const& known : catalogue_.parameters()) {
      if (schema::without_brackets(known.name) != schema::without_brackets(name)) continue;
      file_.refuse(value.span, Text::schema_shape, {{"value", name}, {"known", std::string(known.name)}});
    }
    row_.name = name;
  }

  void read_type() {
    auto const* const found = member("type");
    if (found == nullptr) {
      if (known_ == nullptr) file_.refuse(name_span_, Text::schema_type_missing, {parameter()});
      return;
    }
    auto const& value = file_[found->value];
    auto const type = parse_data_type(file_.text(value));
    if (!type) file_.refuse(value.span, Text::schema_type, {{"types", data_type_names()}});
    if (known_ != nullptr && row_.type == *type) return;
    // What was said for another type does not hold for this one.
    row_.type = *type;
    row_.minimum = {};
    row_.maximum = {};
    row_.default_text.reset();
    row_.max_length = 0;
    row_.symbols.clear();
    row_.number_names.clear();
    if (*type == DataType::boolean) row_.symbols = {{"FALSE", 0}, {"TRUE", 1}};
  }

  void read_member(JsonMember const& named, JsonValue const& value) {
    std::string const& key = named.key;
    if (key == "name" || key == "type") return;
    if (key == "id") {
      auto const number = parse_p_axis(file_.text(value));
      if (!number) file_.refuse(value.span, Text::schema_identifier);
      row_.p_axis = *number;
    } else if (key == "array") {
      read_array(value);
    } else if (key == "default") {
      row_.default_text = file_.text(value);
    } else if (key == "unit") {
      read_unit(value);
    } else if (key == "minimum" || key == "exclusive_minimum") {
      row_.minimum = limit(value, key != "minimum");
    } else if (key == "maximum" || key == "exclusive_maximum") {
      row_.maximum = limit(value, key != "maximum");
    } else if (key == "symbols") {
      read_symbols(value);
    } else if (key == "number_names") {
      read_number_names(value);
    } else if (key == "max_length") {
      if (!is_whole(value, 1, longest_string)) file_.refuse(value.span, Text::schema_max_length);
      row_.max_length = static_cast<std::uint16_t>(value.number);
    } else if (key == "axis_types") {
      read_axis_types(value);
    } else if (key == "since") {
      if (!validator::parse_build_version(file_.text(value))) {
        file_.refuse(value.span, Text::settings_build, {{"value", value.string}});
      }
      row_.since = value.string;
    } else {
      file_.refuse(named.key_span, Text::settings_unknown_key, {{"key", key}, {"keys", std::string(keys)}});
    }
  }

  [[nodiscard]] std::size_t indices() const {
    return static_cast<std::size_t>(std::count(row_.name.begin(), row_.name.end(), '['));
  }

  void read_array(JsonValue const& value) {
    bool good = value.kind == JsonKind::array && value.items.size() == indices() && indices() > 0;
    for (std::size_t i = 0; good && i < value.items.size(); ++i) {
      auto const& size = file_[value.items[i]];
      good = is_whole(size, 1, most_entries);
      if (good) row_.array.at(i) = static_cast<std::uint16_t>(size.number);
    }
    if (!good) refuse_array(value.span);
  }

  [[noreturn]] void refuse_array(Span span) const {
    file_.refuse(span, Text::schema_array, {{"count", std::to_string(indices())}, parameter()});
  }

  void require_array() const {
    std::size_t const given = row_.array[1] != 0 ? 2 : row_.array[0] != 0 ? 1 : 0;
    if (given != indices()) refuse_array(span_of("array"));
    if (known_ == nullptr || known_->array == row_.array) return;
    Argument const size{"size", sizes_text(known_->array)};
    if (validator::is_compiled_family(row_.name)) {
      file_.refuse(span_of("array"), Text::schema_array_fixed, {parameter(), size});
    }
    if (row_.array[0] < known_->array[0] || row_.array[1] < known_->array[1]) {
      file_.refuse(span_of("array"), Text::schema_array_smaller, {parameter(), size});
    }
  }

  void read_unit(JsonValue const& value) {
    if (value.kind == JsonKind::string && !value.string.empty()) {
      row_.unit_translatory = value.string;
      row_.unit_rotary = value.string;
      return;
    }
    bool good = value.kind == JsonKind::object && value.members.size() == 2;
    for (std::size_t i = 0; good && i < value.members.size(); ++i) {
      auto const& unit = file_[value.members[i].value];
      bool const linear = value.members[i].key == "translatory";
      good = unit.kind == JsonKind::string && !unit.string.empty() &&
             (linear || value.members[i].key == "rotary");
      if (good) (linear ? row_.unit_translatory : row_.unit_rotary) = unit.string;
    }
    if (!good) file_.refuse(value.span, Text::schema_unit);
  }

  schema::Limit limit(JsonValue const& value, bool open) {
    using Kind = schema::Limit::Kind;
    if (value.kind == JsonKind::number) return {.number = value.number, .kind = Kind::number, .open = open};
    if (value.kind == JsonKind::string) {
      std::string_view const text = value.string;
      if (auto const number = parse_p_axis(text)) {
        named_.push_back({.span = value.span, .p_axis = *number});
        return {.p_axis = *number, .kind = Kind::parameter, .open = open};
      }
      bool const highest = text.starts_with("MAX(");
      if ((highest || text.starts_with("MIN(")) && text.ends_with(")")) {
        auto const type = parse_data_type(text.substr(4, text.size() - 5));
        if (type && is_number(*type)) {
          schema::DataRange const range = schema::data_range(*type);
          return {.number = highest ? range.highest : range.lowest, .kind = Kind::number, .open = open};
        }
      }
    }
    file_.refuse(value.span, Text::schema_limit);
  }

  void require_limits() const {
    for (std::string const side : {"minimum", "maximum"}) {
      auto const* const closed = member(side);
      auto const* const open = member("exclusive_" + side);
      if (closed != nullptr && open != nullptr) {
        file_.refuse(open->key_span, Text::schema_limit_both, {parameter()});
      }
      auto const* const given = closed != nullptr ? closed : open;
      if (given == nullptr) continue;
      if (!is_number(row_.type)) {
        file_.refuse(given->key_span, Text::schema_limit_type, {parameter(), type_argument()});
      }
      using Kind = schema::Limit::Kind;
      bool const numbers = row_.minimum.kind == Kind::number && row_.maximum.kind == Kind::number;
      if (numbers && row_.minimum.number > row_.maximum.number) {
        file_.refuse(file_[given->value].span, Text::schema_limit_order, {parameter()});
      }
    }
  }

  void read_symbols(JsonValue const& value) {
    schema::ParameterRow::Words words;
    if (row_.type == DataType::boolean) words = {{"FALSE", 0}, {"TRUE", 1}};
    if (value.kind != JsonKind::object || value.members.empty()) {
      file_.refuse(value.span, Text::schema_symbols);
    }
    std::set<std::string> seen{"FALSE", "TRUE"};
    if (row_.type != DataType::boolean) seen.clear();
    for (auto const& symbol : value.members) {
      auto const& number = file_[symbol.value];
      bool const is_word =
          !symbol.key.empty() && std::all_of(symbol.key.begin(), symbol.key.end(), [](char c) {
            return ascii::is_capital(c) || ascii::is_digit(c) || c == '_';
          });
      bool const is_null = number.kind == JsonKind::null;
      if (!is_word || !seen.insert(symbol.key).second || !(is_null || is_whole(number, 0, highest_symbol))) {
        file_.refuse(symbol.key_span, Text::schema_symbols);
      }
      words.emplace_back(symbol.key, is_null ? std::nullopt : std::optional(static_cast<int>(number.number)));
    }
    row_.symbols = std::move(words);
  }

  void read_number_names(JsonValue const& value) {
    if (value.kind != JsonKind::object) file_.refuse(value.span, Text::schema_number_names);
    schema::ParameterRow::Words words;
    for (auto const& name : value.members) {
      auto const& number = file_[name.value];
      if (!is_whole(number, 0, highest_symbol)) file_.refuse(name.key_span, Text::schema_number_names);
      words.emplace_back(name.key, static_cast<int>(number.number));
    }
    row_.number_names = std::move(words);
  }

  void require_symbols() const {
    bool const may_have_words = row_.type == DataType::string || row_.type == DataType::boolean;
    if (!may_have_words && member("symbols") != nullptr) {
      file_.refuse(span_of("symbols"), Text::schema_symbols_type, {parameter(), type_argument()});
    }
    if (row_.type != DataType::string && member("max_length") != nullptr) {
      file_.refuse(span_of("max_length"), Text::schema_max_length);
    }
  }

  void read_axis_types(JsonValue const& value) {
    if (value.kind != JsonKind::array || value.items.empty()) {
      file_.refuse(value.span, Text::schema_axis_types);
    }
    std::string types;
    for (auto const item : value.items) {
      auto const& type = file_[item];
      bool const good = type.kind == JsonKind::string && type.string.size() == 1 &&
                        std::string_view("TRS").find(type.string) != std::string_view::npos &&
                        types.find(type.string) == std::string::npos;
      if (!good) file_.refuse(type.span, Text::schema_axis_types);
      types += type.string;
    }
    row_.axis_types = types;
  }

  /// Also where only the type or the symbols changed: an old default may not fit any more.
  void require_default() {
    if (!row_.default_text) return;
    std::string const& text = *row_.default_text;
    if (auto const number = parse_p_axis(text)) {
      named_.push_back({.span = span_of("default"), .p_axis = *number});
      return;
    }
    bool const touched = member("default") != nullptr || member("symbols") != nullptr || known_ == nullptr;
    if (touched && !is_default_of(row_, text)) {
      file_.refuse(span_of("default"), Text::schema_default, {{"value", text}, parameter()});
    }
  }

  LocatedFile const& file_;
  JsonValue const& entry_;
  schema::Catalogue const& catalogue_;
  schema::Parameter const* known_ = nullptr;
  schema::ParameterRow row_;
  std::vector<NamedNumber> named_;
  Span name_span_;
};

}  // namespace

SchemaEntry read_schema_entry(LocatedFile const& file, JsonValue const& entry,
                              schema::Catalogue const& catalogue) {
  return EntryReader(file, entry, catalogue).read();
}

}  // namespace axisc::cli
