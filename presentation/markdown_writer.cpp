#include "diagnostics/ascii.hpp"
#include "presentation/shown_table.hpp"
#include "presentation/writers.hpp"

#include <algorithm>

namespace axisc::presentation {

namespace {

/// Text in which nothing is markup, a link or a user's name, with as few escapes as that takes: names of
/// parameters, `filter[0].fg_f0`, stay as they are.
std::string plain(std::string_view text) {
  auto const is_word = [&](std::size_t at) {
    return at < text.size() && (ascii::is_letter(text[at]) || ascii::is_digit(text[at]));
  };
  std::string shown;
  for (std::size_t i = 0; i < text.size(); ++i) {
    char const character = text[i];
    bool const ends_link = text.substr(0, i).ends_with("www") || text.substr(0, i).ends_with(":/");
    bool const is_markup = character == '_'   ? i == 0 || !is_word(i - 1) || !is_word(i + 1)
                           : character == ']' ? text.substr(i + 1).starts_with('(')
                           : character == '#'
                               ? i == 0 && (text.size() == 1 || text[1] == '#' || text[1] == ' ')
                               : std::string_view("\\`*<>").find(character) != std::string_view::npos;
    bool const is_link = ends_link && (character == '.' || character == '/');
    if (is_markup || is_link) shown += '\\';
    shown += character;
    if (character == '@') shown += "<!-- -->";
  }
  return shown;
}

/// Without what would end a cell.
std::string in_cell(std::string_view text) {
  std::string shown;
  for (char const character : text) {
    if (character == '|') shown += '\\';
    shown += character;
  }
  return shown;
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
      if (!is_for_people(field.audience) || field.value.is_blank()) continue;
      if (!any) text_ += "\n";
      any = true;
      text_ += "- " + said(field.label) + ": " + text_of(field.value, language_, Units::shown, plain) + "\n";
    }
  }
  void operator()(Table const& table) {
    if (!is_for_people(table.audience) || table.rows.empty()) return;
    auto const shown_cells = shown_table(table, language_, plain);
    if (!shown_cells.columns.empty()) rows(table, shown_cells);
    for (auto const& section : table.details) (*this)(section);
  }
  void operator()(Paragraph const& paragraph) { text_ += "\n" + said(paragraph.words) + "\n"; }
  void operator()(Verbatim const& verbatim) {
    if (!is_for_people(verbatim.audience) || verbatim.text.empty()) return;
    // The fence is longer than any in the text.
    std::string fence = "```";
    while (verbatim.text.find(fence) != std::string::npos) fence += '`';
    text_ += "\n" + fence + "\n" + verbatim.text;
    if (!verbatim.text.ends_with('\n')) text_ += '\n';
    text_ += fence + "\n";
  }
  void operator()(Prose const& prose) {
    auto const& text = prose.markdown.in(language_);
    if (text.empty()) return;
    text_ += "\n" + text;
    if (!text.ends_with('\n')) text_ += '\n';
  }
  void operator()(Picture const& picture) { text_ += "\n*" + plain(picture.figure.description) + "*\n"; }
  void operator()(Section const& section) {
    if (!is_for_people(section.audience)) return;
    if (section.title) {
      ++level_;
      text_ += '\n';
      if (!section.id.empty()) text_ += "<a id=\"" + section.id + "\"></a>\n\n";
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
    text_.append(std::min(level_, deepest), '#').append(" ").append(said(words)).append("\n");
  }
  void rows(Table const& table, ShownTable const& cells) {
    text_ += "\n|";
    for (auto const& heading : cells.headings) text_ += " " + in_cell(heading) + " |";
    text_ += "\n|";
    for (bool const is_right : cells.is_right) text_ += is_right ? "--:|" : "---|";
    text_ += "\n";
    for (std::size_t row = 0; row < cells.rows.size(); ++row) {
      text_ += '|';
      for (std::size_t i = 0; i < cells.columns.size(); ++i) {
        text_ += " " + marked(table.rows[row][cells.columns[i]], cells.rows[row][i]) + " |";
      }
      text_ += '\n';
    }
    if (!cells.more.empty()) text_ += "\n" + cells.more + "\n";
  }
  void blocks(std::vector<Block> const& all) {
    for (auto const& block : all) std::visit(*this, block);
  }
  /// What people see of a value, as a cell.
  static std::string marked(Value const& value, std::string_view text) {
    auto const* const link = std::get_if<Link>(&value.form());
    return link != nullptr ? "[" + in_cell(text) + "](#" + link->id + ")" : in_cell(text);
  }
  [[nodiscard]] std::string said(Words const& words) const { return text_of(words, language_, plain); }

  Language language_;
  std::size_t level_ = 1;
  std::string text_;
};

}  // namespace

std::string write_markdown(Document const& document, WriterOptions const& options) {
  return MarkdownWriter(options.language).write(document);
}

}  // namespace axisc::presentation
