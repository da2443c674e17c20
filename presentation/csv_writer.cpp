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

/// A text or a list without anything in it.
bool is_empty(Value const& value) {
  return std::visit(
      []<class Form>(Form const& form) {
        if constexpr (requires { form.empty(); }) return form.empty();
        return false;
      },
      value.form());
}

/// The rows of all tables of one key.
class CsvWriter {
 public:
  CsvWriter(std::string_view key, Language language) : key_(key), language_(language) {}

  void collect(std::vector<Block> const& blocks) {
    for (auto const& block : blocks) std::visit(*this, block);
  }

  void operator()(Facts const& /*facts*/) {}
  void operator()(Paragraph const& /*paragraph*/) {}
  void operator()(Verbatim const& /*verbatim*/) {}
  void operator()(Picture const& /*picture*/) {}
  void operator()(Section const& section) {
    if (!is_for_programs(section.audience)) return;
    auto const outside = identity_.size();
    identity_.insert(identity_.end(), section.identity.begin(), section.identity.end());
    collect(section.blocks);
    identity_.erase(identity_.begin() + static_cast<std::ptrdiff_t>(outside), identity_.end());
  }
  void operator()(Sections const& sections) {
    for (auto const& section : sections.items) (*this)(section);
  }
  void operator()(Table const& table) {
    if (table.key != key_ || !is_for_programs(table.audience)) return;
    std::vector<std::size_t> places;
    for (auto const& field : identity_) places.push_back(place_of(field.key));
    for (auto const& column : table.columns) {
      places.push_back(is_for_programs(column.audience) ? place_of(name_of(column)) : names_.size());
    }
    for (auto const& row : table.rows) {
      auto& cells = rows_.emplace_back(names_.size());
      std::size_t next = 0;
      for (auto const& field : identity_) cells[places[next++]] = text_of_cell(field.value);
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
  std::size_t place_of(std::string const& name) {
    auto const found = std::find(names_.begin(), names_.end(), name);
    auto const place = static_cast<std::size_t>(found - names_.begin());
    if (found == names_.end()) names_.push_back(name);
    return place;
  }

  [[nodiscard]] std::string text_of_cell(Value const& value) const {
    if (value.is_nothing() || is_empty(value)) return {};
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
  std::vector<Field> identity_;  ///< of the sections around
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
