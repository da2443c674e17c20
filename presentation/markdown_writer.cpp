#include "presentation/shown_table.hpp"
#include "presentation/writers.hpp"

#include <algorithm>

namespace axisc::presentation {

namespace {

/// Text in which nothing is markup.
std::string plain(std::string_view text) {
  std::string shown;
  for (char const character : text) {
    if (std::string_view("\\`*_[]<>|#").find(character) != std::string_view::npos) shown += '\\';
    shown += character;
  }
  return shown;
}

/// Sentences of the program keep their `code`; only what would end a cell is escaped.
std::string in_cell(std::string_view text) {
  std::string shown;
  for (char const character : text) {
    if (character == '|') shown += '\\';
    shown += character;
  }
  return shown;
}

bool is_sentence(Value const& value) {
  return std::holds_alternative<Words>(value.form()) || std::holds_alternative<Symbol>(value.form());
}

class MarkdownWriter {
 public:
  explicit MarkdownWriter(Language language) : language_(language) {}

  std::string write(Document const& document) {
    heading(document.title);
    blocks(document.blocks);
    return std::move(text_);
  }

  void operator()(Facts const& facts) {
    bool any = false;
    for (auto const& field : facts.fields) {
      if (!is_for_people(field.audience)) continue;
      if (!any) text_ += "\n";
      any = true;
      text_ += "- " + text_of(field.label, language_) + ": " + shown(field.value) + "\n";
    }
  }
  void operator()(Table const& table) {
    if (!is_for_people(table.audience) || table.rows.empty()) return;
    auto const shown_cells = shown_table(table, language_);
    text_ += "\n|";
    for (auto const& heading : shown_cells.headings) text_ += " " + in_cell(heading) + " |";
    text_ += "\n|";
    for (bool const is_right : shown_cells.is_right) text_ += is_right ? "--:|" : "---|";
    text_ += "\n";
    for (std::size_t row = 0; row < shown_cells.rows.size(); ++row) {
      text_ += '|';
      std::size_t next = 0;
      for (std::size_t i = 0; i < table.columns.size(); ++i) {
        if (!is_for_people(table.columns[i].audience)) continue;
        auto const& cell = shown_cells.rows[row][next++];
        text_ += " " + (is_sentence(table.rows[row][i]) ? in_cell(cell) : plain(cell)) + " |";
      }
      text_ += '\n';
    }
    if (!shown_cells.more.empty()) text_ += "\n" + shown_cells.more + "\n";
  }
  void operator()(Paragraph const& paragraph) { text_ += "\n" + text_of(paragraph.words, language_) + "\n"; }
  void operator()(Verbatim const& verbatim) {
    if (!is_for_people(verbatim.audience) || verbatim.text.empty()) return;
    // The fence is longer than any in the text.
    std::string fence = "```";
    while (verbatim.text.find(fence) != std::string::npos) fence += '`';
    text_ += "\n" + fence + "\n" + verbatim.text;
    if (!verbatim.text.ends_with('\n')) text_ += '\n';
    text_ += fence + "\n";
  }
  void operator()(Picture const& picture) { text_ += "\n*" + plain(picture.figure.description) + "*\n"; }
  void operator()(Section const& section) {
    if (!is_for_people(section.audience)) return;
    if (section.title) {
      ++level_;
      text_ += '\n';
      heading(*section.title);
    }
    blocks(section.blocks);
    if (section.title) --level_;
  }
  void operator()(Sections const& sections) {
    for (auto const& section : sections.items) (*this)(section);
  }

 private:
  static constexpr std::size_t deepest = 6;

  void heading(Words const& words) {
    text_.append(std::min(level_, deepest), '#').append(" ").append(text_of(words, language_)).append("\n");
  }
  void blocks(std::vector<Block> const& all) {
    for (auto const& block : all) std::visit(*this, block);
  }
  [[nodiscard]] std::string shown(Value const& value) const {
    auto const text = text_of(value, language_);
    return is_sentence(value) || value.is_number() ? text : plain(text);
  }

  Language language_;
  std::size_t level_ = 1;
  std::string text_;
};

}  // namespace

std::string write_markdown(Document const& document, WriterOptions const& options) {
  return MarkdownWriter(options.language).write(document);
}

}  // namespace axisc::presentation
