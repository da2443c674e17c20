#include "diagnostics/terminal.hpp"
#include "presentation/pictures/braille.hpp"
#include "presentation/shown_table.hpp"
#include "presentation/text_layout.hpp"
#include "presentation/writers.hpp"

#include <algorithm>

namespace axisc::presentation {

namespace {

class TextWriter {
 public:
  explicit TextWriter(WriterOptions const& options) : options_(options), paint_(options.color) {}

  std::string write(Document const& document) {
    title(document.title);
    blocks(document.blocks);
    return std::move(text_);
  }

  void operator()(Facts const& facts) {
    std::size_t column = 0;
    std::vector<std::pair<std::string, std::string>> rows;
    for (auto const& field : facts.fields) {
      if (!is_for_people(field.audience)) continue;
      rows.emplace_back(text_of(field.label, options_.language), text_of(field.value, options_.language));
      column = std::max(column, display_width(rows.back().first));
    }
    if (!rows.empty()) end_table();
    column += 2;
    for (auto const& [label, value] : rows) {
      std::string lines = wrapped(value, std::max(options_.width, column + narrowest) - column);
      lines.pop_back();
      text_ += label;
      text_.append(column - display_width(label), ' ');
      for (char const byte : lines) {
        text_ += byte;
        if (byte == '\n') text_.append(column, ' ');
      }
      text_ += '\n';
    }
  }
  void operator()(Table const& table) {
    if (!is_for_people(table.audience) || table.rows.empty()) return;
    end_table();
    text_ += table_text(shown_table(table, options_.language), options_.width);
    table_end_ = text_.size();
  }
  void operator()(Paragraph const& paragraph) {
    text_ += wrapped(text_of(paragraph.words, options_.language), options_.width);
  }
  void operator()(Verbatim const& verbatim) {
    if (!is_for_people(verbatim.audience)) return;
    std::string_view rest = verbatim.text;
    while (!rest.empty()) {
      auto const line = rest.substr(0, rest.find('\n'));
      text_.append("  ").append(printable(line)).append("\n");
      rest.remove_prefix(std::min(line.size() + 1, rest.size()));
    }
  }
  void operator()(Picture const& picture) {
    text_ += pictures::braille(picture.figure, options_.width, options_.language);
  }
  void operator()(Section const& section) {
    if (!is_for_people(section.audience)) return;
    if (section.title) {
      if (!text_.empty()) text_ += '\n';
      title(*section.title);
    }
    blocks(section.blocks);
  }
  void operator()(Sections const& sections) {
    for (auto const& section : sections.items) (*this)(section);
  }

 private:
  static constexpr std::size_t narrowest = 20;  ///< of a value next to its label

  /// A line between a table and what else has columns.
  void end_table() {
    if (table_end_ == text_.size()) text_ += '\n';
  }

  void title(Words const& words) {
    auto lines = wrapped(text_of(words, options_.language), options_.width);
    lines.pop_back();
    text_ += paint_(Style::strong, lines) + "\n";
  }
  void blocks(std::vector<Block> const& all) {
    for (auto const& block : all) std::visit(*this, block);
  }

  WriterOptions const& options_;
  Painter paint_;
  std::string text_;
  std::size_t table_end_ = std::string::npos;  ///< of the last table
};

}  // namespace

std::string write_text(Document const& document, WriterOptions const& options) {
  return TextWriter(options).write(document);
}

}  // namespace axisc::presentation
