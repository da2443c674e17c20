#include "axisc/answers/execution/mapping_table.hpp"

#include <array>

namespace axisc::says {

constexpr Sentence column_signal{"signal", "Signal"};
constexpr Sentence column_column{"column", "Spalte"};
constexpr Sentence column_found_by{"found by", "gefunden über"};
constexpr Sentence column_unit{"unit", "Einheit"};
constexpr Sentence column_numbers{"numbers", "Zahlen"};
constexpr Sentence column_every{"every", "alle"};
constexpr Sentence by_option{"option", "Option"};
constexpr Sentence by_object{"object", "Objekt"};
constexpr Sentence by_name{"name", "Name"};
constexpr Sentence by_order{"order", "Reihenfolge"};
constexpr Sentence unscaled{"unscaled", "unskaliert"};
constexpr Sentence raw{"raw", "roh"};
constexpr Sentence scaled{"scaled", "skaliert"};

}  // namespace axisc::says

namespace axisc {

namespace {

using namespace presentation;

struct Word {
  std::string_view symbol;
  SentenceRef words;
};
/// By FoundBy and by Scaling, of which `open` and `neither` are refused.
constexpr std::array<Word, 4> found_by{{{"option", says::by_option},
                                        {"object", says::by_object},
                                        {"name", says::by_name},
                                        {"order", says::by_order}}};
constexpr std::array<Word, 3> scalings{
    {{"unscaled", says::unscaled}, {"raw", says::raw}, {"scaled", says::scaled}}};

template <std::size_t size>
Symbol symbol(std::array<Word, size> const& words, std::size_t index) {
  return {.symbol = words.at(index).symbol, .words = words.at(index).words};
}

}  // namespace

Table mapping_table(std::vector<std::string> const& signals, std::vector<MappedColumn> const& columns) {
  Table table{.key = "mapping",
              .columns = {head_column("signal", says::column_signal),
                          column("column", says::column_column),
                          data_column("number"),
                          column("found_by", says::column_found_by),
                          {.key = {}, .label = says::column_unit, .audience = Audience::people},
                          data_column("unit"),
                          column("numbers", says::column_numbers),
                          column("sample_time_ms", says::column_every, Unit::millisecond)}};
  for (std::size_t i = 0; i < columns.size(); ++i) {
    auto const& one = columns[i];
    constexpr int digits = 6;
    Value const every =
        one.sample_time_ms > 0 ? Value(rounded(one.sample_time_ms, Unit::millisecond, digits)) : Value();
    table.rows.push_back(
        {signals.at(i), one.name, one.number, symbol(found_by, static_cast<std::size_t>(one.by)),
         one.unit.empty() ? Value() : Value(one.unit), one.unit.empty() ? Value() : Value(one.unit.written()),
         symbol(scalings, static_cast<std::size_t>(one.scaling)), every});
  }
  return table;
}

}  // namespace axisc
