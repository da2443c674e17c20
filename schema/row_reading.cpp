#include "schema/row_reading.hpp"

#include <algorithm>
#include <cstddef>
#include <optional>
#include <utility>

#include <nlohmann/json.hpp>

namespace axisc::schema {
namespace {

// Symbols keep the order of the file: messages list them that way.
using Json = nlohmann::ordered_json;

ParameterRow::Words words_in(Json const& object) {
  ParameterRow::Words words;
  for (auto const& [word, number] : object.items()) {
    words.emplace_back(word, number.is_null() ? std::nullopt : std::optional(number.get<int>()));
  }
  return words;
}

class RowReader {
 public:
  RowReader(Json const& entry, Parameter const* known, ListKind kind)
      : entry_(entry), known_(known), kind_(kind) {}

  RowReading read() && {
    if (known_ != nullptr) row_ = ParameterRow::from(*known_);
    row_.kind = kind_;
    row_.name = entry_.at("name").get<std::string>();
    read_type();
    read_fields();
    read_limit("minimum", "exclusive_minimum", row_.minimum);
    read_limit("maximum", "exclusive_maximum", row_.maximum);
    read_symbols();
    check_array();
    check_limits();
    check_default();
    return std::move(reading_);
  }

 private:
  [[nodiscard]] Json const* find(std::string_view key) const {
    auto const found = entry_.find(std::string(key));
    return found == entry_.end() ? nullptr : &*found;
  }

  void complain(RowContradiction what, std::string_view key, std::string value = {}) {
    reading_.problems.push_back({.what = what, .key = key, .value = std::move(value)});
  }

  void read_type() {
    Json const* const word = find("type");
    if (word == nullptr) {
      if (known_ == nullptr) complain(RowContradiction::type_missing, "name");
      return;
    }
    DataType const type = parse_data_type(word->get<std::string>()).value();
    if (known_ != nullptr && row_.type == type) return;
    // Properties of another type do not apply to this one.
    row_.type = type;
    row_.minimum = {};
    row_.maximum = {};
    row_.default_text.reset();
    row_.max_length = 0;
    row_.symbols = own_symbols();
    row_.number_names.clear();
  }

  void read_fields() {
    if (auto const* const id = find("id")) row_.p_axis = parse_number(kind_, id->get<std::string>()).value();
    if (auto const* const flags = find("flags")) row_.is_flags = flags->get<bool>();
    if (auto const* const text = find("default")) row_.default_text = text->get<std::string>();
    if (auto const* const unit = find("unit")) {
      row_.unit_translatory = (unit->is_string() ? *unit : unit->at("translatory")).get<std::string>();
      row_.unit_rotary = (unit->is_string() ? *unit : unit->at("rotary")).get<std::string>();
    }
    if (auto const* const names = find("number_names")) row_.number_names = words_in(*names);
    if (auto const* const types = find("axis_types")) {
      row_.axis_types.clear();
      for (Json const& type : *types) row_.axis_types += type.get<std::string>();
    }
    if (auto const* const name = find("former_name")) row_.former_name = name->get<std::string>();
    if (auto const* const since = find("since")) row_.since = since->get<std::string>();
    if (auto const* const length = find("max_length")) {
      row_.max_length = length->get<std::uint16_t>();
      if (row_.type != DataType::string) complain(RowContradiction::length_of_numbers, "max_length");
    }
  }

  void read_limit(std::string_view closed_key, std::string_view open_key, Limit& limit) {
    using Kind = Limit::Kind;
    bool const open = find(open_key) != nullptr;
    std::string_view const key = open ? open_key : closed_key;
    Json const* const value = find(key);
    if (value == nullptr) return;
    if (!is_number(row_.type)) complain(RowContradiction::limits_of_words, key);
    if (value->is_number()) {
      limit = {.number = value->get<double>(), .kind = Kind::number, .open = open};
      return;
    }
    auto const text = value->get<std::string>();
    if (auto const number = parse_number(kind_, text)) {
      reading_.named.push_back({.key = key, .p_axis = *number});
      limit = {.p_axis = *number, .kind = Kind::parameter, .open = open};
      return;
    }
    constexpr std::size_t before = 4;  // MIN( or MAX(
    auto const type =
        parse_data_type(std::string_view(text).substr(before, text.size() - before - 1)).value();
    DataRange const range = data_range(type);
    limit = {
        .number = text.starts_with("MAX") ? range.highest : range.lowest, .kind = Kind::number, .open = open};
  }

  /// The symbols that every row of the type has.
  [[nodiscard]] ParameterRow::Words own_symbols() const {
    if (row_.type != DataType::boolean) return {};
    return {{"FALSE", 0}, {"TRUE", 1}};
  }

  void read_symbols() {
    Json const* const symbols = find("symbols");
    if (symbols == nullptr) return;
    if (row_.type != DataType::string && row_.type != DataType::boolean) {
      complain(RowContradiction::symbols_of_numbers, "symbols");
    }
    row_.symbols = own_symbols();
    for (auto& symbol : words_in(*symbols)) {
      if (is_symbol(symbol.first)) complain(RowContradiction::symbol_twice, "symbols", symbol.first);
      row_.symbols.push_back(std::move(symbol));
    }
  }

  void check_array() {
    auto const indices = static_cast<std::size_t>(std::count(row_.name.begin(), row_.name.end(), '['));
    auto given = static_cast<std::size_t>(
        std::count_if(row_.array.begin(), row_.array.end(), [](std::uint16_t size) { return size != 0; }));
    if (auto const* const sizes = find("array")) {
      given = sizes->size();
      row_.array = {};
      for (std::size_t i = 0; i < std::min(given, row_.array.size()); ++i) {
        row_.array.at(i) = sizes->at(i).get<std::uint16_t>();
      }
    }
    if (given != indices) complain(RowContradiction::array_sizes, "array");
  }

  void check_limits() {
    using Kind = Limit::Kind;
    bool const numbers = row_.minimum.kind == Kind::number && row_.maximum.kind == Kind::number;
    if (!numbers || row_.minimum.number <= row_.maximum.number) return;
    for (std::string_view const key : {"minimum", "exclusive_minimum", "maximum", "exclusive_maximum"}) {
      if (find(key) == nullptr) continue;
      complain(RowContradiction::minimum_above_maximum, key);
      return;
    }
  }

  /// Also where only the type or the symbols changed: an old default may not fit any more.
  void check_default() {
    if (!row_.default_text) return;
    std::string const& text = *row_.default_text;
    if (auto const number = parse_number(kind_, text)) {
      reading_.named.push_back({.key = "default", .p_axis = *number});
      return;
    }
    bool const touched = known_ == nullptr || find("default") != nullptr || find("symbols") != nullptr;
    if (touched && !is_value(text)) complain(RowContradiction::default_not_a_value, "default", text);
  }

  [[nodiscard]] bool is_symbol(std::string_view text) const {
    return std::any_of(row_.symbols.begin(), row_.symbols.end(),
                       [text](auto const& symbol) { return symbol.first == text; });
  }

  [[nodiscard]] bool is_value(std::string const& text) const {
    if (is_symbol(text)) return true;
    if (row_.type == DataType::boolean) return text == "0" || text == "1";
    if (row_.type != DataType::string) return is_number_of_type(text, row_.type);
    // A set of flags has "none" as its default, which is a number and no word.
    return row_.symbols.empty() || is_number_of_type(text, DataType::uns64);
  }

  Json const& entry_;
  Parameter const* known_;
  ListKind kind_;
  RowReading reading_;
  ParameterRow& row_ = reading_.row;
};

}  // namespace

RowReading read_row(nlohmann::ordered_json const& entry, Parameter const* known, ListKind kind) {
  return RowReader(entry, known, kind).read();
}

}  // namespace axisc::schema
