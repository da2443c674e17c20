#include "diagnostics/markup.hpp"
#include "presentation/pictures/page.hpp"
#include "presentation/pictures/svg_text.hpp"
#include "presentation/prose.hpp"
#include "presentation/shown_table.hpp"
#include "presentation/writers.hpp"

#include <algorithm>

namespace axisc::presentation {

namespace {

std::string element(std::string_view tag, std::string_view content) {
  return (std::string("<").append(tag) += ">").append(content).append("</").append(tag) += ">";
}

/// A sentence's `code` and **bold** as elements. What has no end stays as it is.
std::string inline_html(std::string_view text) {
  std::string html;
  while (!text.empty()) {
    auto const begin = std::min(text.find('`'), text.find("**"));
    if (begin == std::string_view::npos) break;
    std::string_view const mark = text[begin] == '`' ? "`" : "**";
    auto const end = text.find(mark, begin + mark.size());
    if (end == std::string_view::npos) break;
    auto const inner = text.substr(begin + mark.size(), end - begin - mark.size());
    html += escaped(text.substr(0, begin)) +
            (mark == "`" ? element("code", escaped(inner)) : element("strong", inline_html(inner)));
    text.remove_prefix(end + mark.size());
  }
  return html + escaped(text);
}

bool has_picture(std::vector<Block> const& blocks);

bool has_picture(Block const& block) {
  if (auto const* const section = std::get_if<Section>(&block)) return has_picture(section->blocks);
  if (auto const* const sections = std::get_if<Sections>(&block)) {
    return std::any_of(sections->items.begin(), sections->items.end(),
                       [](Section const& section) { return has_picture(section.blocks); });
  }
  return std::holds_alternative<Picture>(block);
}

bool has_picture(std::vector<Block> const& blocks) {
  return std::any_of(blocks.begin(), blocks.end(), [](Block const& block) { return has_picture(block); });
}

class HtmlWriter {
 public:
  HtmlWriter(int level, Language language) : level_(level), language_(language) {}

  std::string write(std::vector<Block> const& all) {
    blocks(all);
    return std::move(html_);
  }

  void operator()(Facts const& facts) {
    std::string rows;
    for (auto const& field : facts.fields) {
      if (!is_for_people(field.audience) || field.value.is_blank()) continue;
      rows += R"(<tr><th scope="row">)" + inline_html(text_of(field.label, language_)) + "</th><td>" +
              inline_html(text_of(field.value, language_)) + "</td></tr>\n";
    }
    if (!rows.empty()) html_ += "<table tabindex=\"0\"><tbody>\n" + rows + "</tbody></table>\n";
  }
  void operator()(Table const& table) {
    if (!is_for_people(table.audience) || table.rows.empty()) return;
    auto const shown = shown_table(table, language_);
    if (!shown.columns.empty()) rows(table, shown);
    for (auto const& section : table.details) (*this)(section);
  }
  void operator()(Paragraph const& paragraph) {
    html_ += "<p>" + inline_html(text_of(paragraph.words, language_)) + "</p>\n";
  }
  void operator()(Verbatim const& verbatim) {
    if (!is_for_people(verbatim.audience) || verbatim.text.empty()) return;
    // On paper what is short stays on one page.
    constexpr auto most_kept_together = 14;
    bool const is_long = std::count(verbatim.text.begin(), verbatim.text.end(), '\n') > most_kept_together;
    html_ += std::string("<pre tabindex=\"0\"") + (is_long ? R"( class="long">)" : ">") +
             escaped(verbatim.text) + "</pre>\n";
  }
  void operator()(Prose const& prose) { blocks(blocks_of(prose, language_)); }
  void operator()(Picture const& picture) { html_ += pictures::figure_element(picture.figure, language_); }
  void operator()(Section const& section) {
    if (!is_for_people(section.audience)) return;
    auto const id = section.id.empty() ? std::string() : pictures::attribute("id", section.id);
    if (section.is_folded && section.title) {
      html_ +=
          "<details" + id + ">" + element("summary", inline_html(text_of(*section.title, language_))) + "\n";
      blocks(section.blocks);
      html_ += "</details>\n";
      return;
    }
    if (section.title) {
      auto const tag = "h" + std::to_string(std::min(level_, 6));
      html_ += "<" + tag + id + ">" + inline_html(text_of(*section.title, language_)) + "</" + tag + ">\n";
      ++level_;
    }
    blocks(section.blocks);
    if (section.title) --level_;
  }
  void operator()(Sections const& sections) {
    for (auto const& section : sections.items) (*this)(section);
  }

 private:
  void rows(Table const& table, ShownTable const& shown) {
    html_ += R"(<table tabindex="0"><thead><tr>)";
    for (auto const& heading : shown.headings) {
      html_ += R"(<th scope="col">)" + inline_html(heading) + "</th>";
    }
    html_ += "</tr></thead><tbody>\n";
    for (std::size_t row = 0; row < shown.rows.size(); ++row) {
      html_ += "<tr>";
      for (std::size_t i = 0; i < shown.columns.size(); ++i) {
        auto const& value = table.rows[row][shown.columns[i]];
        html_ += (shown.is_right[i] ? R"(<td class="number">)" : "<td>") +
                 linked(value, inline_html(shown.rows[row][i])) + "</td>";
      }
      html_ += "</tr>\n";
    }
    html_ += "</tbody></table>\n";
    if (!shown.more.empty()) html_ += "<p>" + escaped(shown.more) + "</p>\n";
  }
  static std::string linked(Value const& value, std::string const& html) {
    auto const* const link = std::get_if<Link>(&value.form());
    return link == nullptr ? html : "<a" + pictures::attribute("href", "#" + link->id) + ">" + html + "</a>";
  }
  void blocks(std::vector<Block> const& all) {
    for (auto const& block : all) std::visit(*this, block);
  }

  int level_;
  Language language_;
  std::string html_;
};

}  // namespace

std::string html_of(std::vector<Block> const& blocks, int level, WriterOptions const& options) {
  return HtmlWriter(level, options.language).write(blocks);
}

std::string write_html(Document const& document, WriterOptions const& options) {
  auto const title = text_of(document.title, options.language);
  std::string html = "<!doctype html>\n<html lang=\"";
  html += options.language == Language::german ? "de" : "en";
  html += "\"><head><meta charset=\"utf-8\">\n";
  html += R"(<meta name="viewport" content="width=device-width,initial-scale=1">)";
  html += "\n<title>" + escaped(title) + "</title>\n<style>\n" + pictures::page_style();
  html += "</style></head>\n<body><main>\n<h1>" + inline_html(title) + "</h1>\n" +
          html_of(document.blocks, 2, options) + "</main>\n";
  if (has_picture(document.blocks)) html += pictures::zoom_part(options.language);
  return html + "</body></html>\n";
}

}  // namespace axisc::presentation
