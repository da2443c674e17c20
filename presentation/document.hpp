// An answer, described once: facts, tables, paragraphs and figures as data. writers.hpp writes it in every
// format.
#pragma once

#include "presentation/pictures/figure.hpp"
#include "presentation/value.hpp"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace axisc::presentation {

/// The readers of a part of an answer. People read text, Markdown and HTML, programs read JSON and CSV.
enum class Audience : std::uint8_t { all, people, programs };

/// One value under a name. People do not see a field without a value. Keys are snake_case and end with the
/// suffix of their unit.
struct Field {
  std::string key;
  Words label;
  Value value;
  Audience audience = Audience::all;
  std::string member = {};  ///< where neighbours of one key form an object in JSON: its member
};

/// A field that only programs read, and one that only people see.
[[nodiscard]] Field data(std::string key, Value value, std::string member = {});
[[nodiscard]] Field shown(Words label, Value value);

/// In JSON members of the enclosing object.
struct Facts {
  std::vector<Field> fields;
};

struct Column {
  std::string key;
  Words label;
  Unit unit = Unit::none;  ///< of its numbers, where they have none themselves
  std::string member =
      {};  ///< where columns of one key form an object in JSON: its member; "key.member" in CSV
  Audience audience = Audience::all;
  bool is_head = false;  ///< identifies a row: repeated where a wide table is divided
};

[[nodiscard]] Column column(std::string key, Words label, Unit unit = Unit::none, std::string member = {});
[[nodiscard]] Column head_column(std::string key, Words label, Unit unit = Unit::none);
/// A column that only programs read.
[[nodiscard]] Column data_column(std::string key, std::string member = {});
[[nodiscard]] std::vector<Column> data_columns(std::vector<std::string> keys);

using Row = std::vector<Value>;

/// A sentence for people; the parts of it that programs need are fields.
struct Paragraph {
  Words words;
};

/// Lines that stay as they are, such as a part of a list. In JSON one string.
struct Verbatim {
  std::string key;
  std::string text;
  Audience audience = Audience::all;
};

/// Pages of prose: Markdown without headings. In JSON one string.
struct Prose {
  std::string key;
  Wording markdown;
};

struct Picture {
  pictures::Figure figure;
};

struct Table;
struct Section;
struct Sections;
using Block = std::variant<Facts, Table, Paragraph, Verbatim, Prose, Picture, Section, Sections>;

/// In JSON an object; one without a key adds its members to the enclosing object.
struct Section {
  std::string key;
  std::optional<Words> title;
  std::vector<Block> blocks;
  /// Distinguishes it from its neighbours: first members in JSON, first columns in CSV; for people the title
  /// does so.
  std::vector<Field> identity = {};
  Audience audience = Audience::all;
  std::string id = {};     ///< links lead here
  bool is_folded = false;  ///< HTML shows the title alone until more is wanted
};

/// An object of fields that only programs read.
[[nodiscard]] Section data_section(std::string key, std::vector<Field> fields);
/// Blocks under a title.
[[nodiscard]] Section part(Words title, std::vector<Block> blocks, Audience audience = Audience::all);

/// Folded away until it is asked for, where the format can.
[[nodiscard]] Section folded(Words title, std::vector<Block> blocks);

/// Sections of one kind; in JSON an array.
struct Sections {
  std::string key;
  std::vector<Section> items;
};

/// In JSON an array of objects, in CSV rows.
struct Table {
  std::string key;
  std::vector<Column> columns = {};
  std::vector<Row> rows = {};  ///< as many values as columns
  Audience audience = Audience::all;
  std::size_t most_shown =
      static_cast<std::size_t>(-1);  ///< rows that people see; then how many more there are
  std::size_t left_out = 0;          ///< rows that are not kept because there were too many
  /// More about each row, or empty: in JSON further members of its object; people see it after the table.
  std::vector<Section> details = {};
};

/// A row for each element.
template <class Range, class ToRow>
[[nodiscard]] Table table_of(std::string key, std::vector<Column> columns, Range const& elements,
                             ToRow to_row) {
  Table table{.key = std::move(key), .columns = std::move(columns)};
  for (auto const& element : elements) table.rows.push_back(to_row(element));
  return table;
}

/// A row of fields; the first row makes the columns, of which people see the first as head.
void add_row(Table& table, std::vector<Field> fields);

struct Document {
  int version = 1;  ///< of the JSON form; 0: it is a file of another kind, without a version
  Words title;
  std::vector<Block> blocks;
  /// Key of the tables that CSV has, also of one for people, or of sections, of which CSV has the fields;
  /// empty: no CSV.
  std::string csv_table = {};
};

}  // namespace axisc::presentation
