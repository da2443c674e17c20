#include "diagnostics/terminal.hpp"
#include "presentation/pictures/braille.hpp"
#include "presentation/prose.hpp"
#include "presentation/shown_table.hpp"
#include "presentation/text_layout.hpp"
#include "presentation/writers.hpp"

#include <algorithm>

namespace axisc::presentation {

namespace {

/// A terminal shows `code` as it is, but nothing in **bold**.
std::string without_stars(std::string text) {
  for (auto at = text.find("**"); at != std::string::npos; at = text.find("**", at)) text.erase(at, 2);
  return text;
}

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
      if (!is_for_people(field.audience) || field.value.is_blank()) continue;
      rows.emplace_back(text_of(field.label, options_.language), text_of(field.value, options_.language));
      column = std::max(column, display_width(rows.back().first));
    }
    if (!rows.empty() && ends_indented()) text_ += '\n';
    column += 2;
    for (auto const& [label, value] : rows) {
      text_ += label;
      text_.append(column - display_width(label), ' ').append(hanging(value, options_.width, column)) += '\n';
    }
  }
  void operator()(Table const& table) {
    if (!is_for_people(table.audience) || table.rows.empty()) return;
    auto const shown = shown_table(table, options_.language);
    if (!shown.columns.empty()) {
      if (ends_indented()) text_ += '\n';
      text_ += table_text(shown, options_.width);
    }
    for (auto const& section : table.details) (*this)(section);
  }
  void operator()(Paragraph const& paragraph) {
    if (ends_indented()) text_ += '\n';
    text_ += wrapped(without_stars(text_of(paragraph.words, options_.language)), options_.width);
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
  void operator()(Prose const& prose) {
    for (auto const& block : blocks_of(prose, options_.language)) {
      if (!text_.empty()) text_ += '\n';
      std::visit(*this, block);
    }
  }
  void operator()(Picture const& picture) {
    text_ += pictures::braille(picture.figure, options_.width, options_.language);
  }
  void operator()(Section const& section) {
    if (!is_for_people(section.audience)) return;
    if (!section.title) return blocks(section.blocks);
    if (!text_.empty()) text_ += '\n';
    auto inner = options_;
    if (is_inside_) inner.width -= std::min(indent.size(), inner.width);
    TextWriter writer(inner);
    writer.is_inside_ = true;
    writer.title(*section.title);
    writer.blocks(section.blocks);
    append(writer.text_);
  }
  void operator()(Sections const& sections) {
    for (auto const& section : sections.items) (*this)(section);
  }

 private:
  static constexpr std::string_view indent = "  ";

  /// Sections inside a section are indented.
  void append(std::string_view lines) {
    while (!lines.empty()) {
      auto const line = lines.substr(0, lines.find('\n') + 1);
      if (is_inside_ && line != "\n") text_ += indent;
      text_ += line;
      lines.remove_prefix(line.size());
    }
  }
  void title(Words const& words) {
    auto lines = wrapped(text_of(words, options_.language), options_.width);
    lines.pop_back();
    text_ += paint_(Style::strong, lines) + "\n";
  }
  void blocks(std::vector<Block> const& all) {
    for (auto const& block : all) std::visit(*this, block);
  }
  /// As tables are.
  [[nodiscard]] bool ends_indented() const {
    if (text_.size() < 2) return false;
    return text_[text_.rfind('\n', text_.size() - 2) + 1] == ' ';
  }

  WriterOptions options_;
  Painter paint_;
  std::string text_;
  bool is_inside_ = false;  ///< of a section with a title
};

}  // namespace

std::string write_text(Document const& document, WriterOptions const& options) {
  return TextWriter(options).write(document);
}

}  // namespace axisc::presentation
