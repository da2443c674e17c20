#include "diagnostics/format_number.hpp"
#include "presentation/csv_field.hpp"
#include "presentation/shown_table.hpp"
#include "presentation/writers.hpp"

#include <algorithm>

namespace axisc::presentation {

namespace {

std::string name_of(Column const& column) {
  return column.member.empty() ? column.key : column.key + "." + column.member;
}

/// The rows of all tables of one key; of an array of sections a row each.
class CsvWriter {
 public:
  CsvWriter(std::string_view key, Language language) : key_(key), language_(language) {}

  void collect(std::vector<Block> const& blocks) {
    for (auto const& block : blocks) std::visit(*this, block);
  }

  void operator()(Facts const& /*facts*/) {}
  void operator()(Paragraph const& /*paragraph*/) {}
  void operator()(Verbatim const& /*verbatim*/) {}
  void operator()(Prose const& /*prose*/) {}
  void operator()(Picture const& /*picture*/) {}
  void operator()(Section const& section) {
    if (!is_for_programs(section.audience)) return;
    auto const outside = identity_.size();
    for (auto const& field : section.identity) identity_.emplace_back(array_, field);
    collect(section.blocks);
    identity_.erase(identity_.begin() + static_cast<std::ptrdiff_t>(outside), identity_.end());
  }
  void operator()(Sections const& sections) {
    for (auto const& section : sections.items) {
      array_ = sections.key;
      if (sections.key == key_) {
        add_section(section);
      } else {
        (*this)(section);
      }
    }
  }
  void operator()(Table const& table) {
    if (table.key != key_) return;
    std::vector<std::size_t> places;
    for (auto const& [array, field] : identity_) {
      bool const is_taken =
          std::any_of(table.columns.begin(), table.columns.end(),
                      [&key = field.key](Column const& column) { return name_of(column) == key; });
      places.push_back(place_of(is_taken ? array + "." + field.key : field.key));
    }
    for (auto const& column : table.columns) {
      places.push_back(is_for_programs(column.audience) ? place_of(name_of(column)) : names_.size());
    }
    for (auto const& row : table.rows) {
      auto& cells = rows_.emplace_back(names_.size());
      std::size_t next = 0;
      for (auto const& [array, field] : identity_) cells[places[next++]] = text_of_cell(field.value);
      for (std::size_t i = 0; i < row.size(); ++i, ++next) {
        if (is_for_programs(table.columns[i].audience)) cells[places[next]] = text_of_cell(row[i]);
      }
    }
  }

  [[nodiscard]] std::string text() const {
    if (names_.empty()) return {};
    std::string text;
    append_row(text, names_);
    for (auto row : rows_) {
      row.resize(names_.size());
      append_row(text, row);
    }
    return text;
  }

 private:
  /// A row of its fields and those of the objects in it, "minimum.open"; columns are those that some row
  /// fills.
  void add_section(Section const& section) {
    std::vector<std::string> cells;
    auto const add = [&](std::vector<Field> const& fields, std::string const& object) {
      for (auto const& field : fields) {
        auto cell = text_of_cell(field.value);
        if (!is_for_programs(field.audience) || cell.empty()) continue;
        auto const place = place_of(object + field.key + (field.member.empty() ? "" : "." + field.member));
        cells.resize(names_.size());
        cells[place] = std::move(cell);
      }
    };
    auto const add_all = [&](auto const& self, std::vector<Block> const& blocks,
                             std::string const& object) -> void {
      for (auto const& block : blocks) {
        if (auto const* const facts = std::get_if<Facts>(&block)) add(facts->fields, object);
      }
      for (auto const& block : blocks) {
        auto const* const inner = std::get_if<Section>(&block);
        if (inner != nullptr && !inner->key.empty()) self(self, inner->blocks, object + inner->key + ".");
      }
    };
    for (auto const& [array, field] : identity_) add({field}, {});
    add(section.identity, {});
    add_all(add_all, section.blocks, {});
    rows_.push_back(std::move(cells));
  }
  std::size_t place_of(std::string const& name) {
    auto const found = std::find(names_.begin(), names_.end(), name);
    auto const place = static_cast<std::size_t>(found - names_.begin());
    if (found == names_.end()) names_.push_back(name);
    return place;
  }

  [[nodiscard]] std::string text_of_cell(Value const& value) const {
    if (value.is_nothing() || value.is_blank()) return {};
    if (auto const* const quantity = std::get_if<Quantity>(&value.form())) {
      return format_exact(quantity->value);
    }
    if (auto const* const truth = std::get_if<bool>(&value.form())) return *truth ? "true" : "false";
    if (auto const* const symbol = std::get_if<Symbol>(&value.form())) return std::string(symbol->symbol);
    if (value.is_number()) return presentation::text_of(value, language_);
    return csv_text(presentation::text_of(value, language_));
  }

  static void append_row(std::string& text, std::vector<std::string> const& cells) {
    for (std::size_t i = 0; i < cells.size(); ++i) {
      if (i > 0) text += ',';
      append_csv_field(text, cells[i]);
    }
    text += '\n';
  }

  std::string_view key_;
  Language language_;
  std::string array_;                                    ///< of the sections being collected
  std::vector<std::pair<std::string, Field>> identity_;  ///< of the sections around, with the array's key
  std::vector<std::string> names_;
  std::vector<std::vector<std::string>> rows_;
};

}  // namespace

std::string write_csv(Document const& document, WriterOptions const& options) {
  if (document.csv_table.empty()) return {};
  CsvWriter writer(document.csv_table, options.language);
  writer.collect(document.blocks);
  return writer.text();
}

}  // namespace axisc::presentation
