#include "presentation/pictures/page.hpp"

#include "diagnostics/markup.hpp"
#include "diagnostics/message.hpp"
#include "embedded.hpp"
#include "presentation/pictures/svg.hpp"
#include "presentation/pictures/svg_text.hpp"

#include <cctype>

namespace axisc::pictures::says {

constexpr Sentence zoomed_by{"Pictures zoom with uPlot, under the MIT licence",
                             "Bilder zoomen mit uPlot, unter der MIT-Lizenz"};
constexpr Sentence zoom{"Zoom", "Zoomen"};
constexpr Sentence zoom_closer{"closer", "näher"};
constexpr Sentence zoom_farther{"farther", "weiter"};
constexpr Sentence zoom_left{"to the left", "nach links"};
constexpr Sentence zoom_right{"to the right", "nach rechts"};
constexpr Sentence zoom_all{"everything", "alles"};
constexpr Sentence zoom_keys{"plus, minus, arrow keys and 0 change the range",
                             "Plus, Minus, Pfeiltasten und 0 ändern den Bereich"};

}  // namespace axisc::pictures::says

namespace axisc::pictures {
namespace {

/// A number as our tables write it, or the dash for none.
bool is_number(std::string_view cell) {
  if (cell == "-") return true;
  if (cell.starts_with('-') || cell.starts_with('+')) cell.remove_prefix(1);
  return !cell.empty() && cell.find_first_not_of("0123456789.,e+-") == std::string_view::npos &&
         std::isdigit(static_cast<unsigned char>(cell.front())) != 0;
}

std::string cell_element(std::string const& cell, std::string_view tag) {
  std::string text = "<";
  text.append(tag);
  if (tag == "th") text += R"( scope="col")";
  if (tag == "td" && is_number(cell)) text += R"( class="number")";
  return text.append(">").append(escaped(cell)).append("</").append(tag).append(">");
}

}  // namespace

std::string page_style() {
  return std::string(plotting_style()) +
         R"(:root{color-scheme:light dark;--paper:#fff;--ink:#1d1f23;--quiet:#55595f;--line:#c9ccd1;--panel:#f5f6f8;--link:#0a58a6}
@media (prefers-color-scheme:dark){:root{--paper:#17191d;--ink:#ececec;--quiet:#b0b4ba;--line:#43474e;--panel:#202328;--link:#7db7f0}}
body{margin:0 auto;max-width:62rem;padding:1rem 1.2rem 3rem;background:var(--paper);color:var(--ink);font:15px/1.5 system-ui,sans-serif}
a{color:var(--link)}h1{font-size:1.5rem}h2{font-size:1.25rem;margin-top:2.2rem;border-bottom:1px solid var(--line)}h3{font-size:1.05rem;margin-top:1.6rem}
table{border-collapse:collapse;margin:.6rem 0;display:block;overflow-x:auto}th,td{padding:.2rem .7rem;text-align:left;border-bottom:1px solid var(--line);vertical-align:top}
th{color:var(--quiet);font-weight:600}td.number{text-align:right;font-variant-numeric:tabular-nums}
figure{margin:1rem 0}.zooms>svg,.zoom{display:none}.zooms>.zoom{display:block}.zoom-bar{display:flex;gap:.3rem;margin:.3rem 0}.zoom-bar button{min-width:2.2rem;font:inherit}
.uplot,.uplot *{font-family:inherit}.u-legend{text-align:left!important;display:block;overflow:visible}.u-legend th,.u-legend td{border:0}
figure svg{width:100%;height:auto;max-width:800px;display:block}
pre{background:var(--panel);padding:.6rem .8rem;overflow-x:auto;font-size:13px}
@media print{.zooms>.zoom,.zoom-button{display:none}.zooms>svg{display:block}:root{color-scheme:light;--paper:#fff;--ink:#000;--quiet:#333;--line:#999;--panel:#fff;--link:#000}body{max-width:none;padding:0;font-size:10pt}pre{white-space:pre-wrap;overflow:visible}table{overflow:visible}figure,tr,pre{break-inside:avoid}figure svg{max-height:235mm}h2,h3{break-after:avoid}@page{size:A4;margin:15mm}}
)";
}

std::string zoom_part(Language language) {
  std::string text = "<footer><details><summary>" + escaped(render({says::zoomed_by}, language)) +
                     "</summary><pre tabindex=\"0\">";
  text.append(escaped(plotting_licence())).append("</pre></details></footer>\n<script>");
  return text.append(page_script(language)).append("</script>\n");
}

std::string page_script(Language language) {
  auto const say = [language](SentenceRef text) { return render({text}, language); };
  std::string text = "\n";
  text.append(plotting_script()).append("\n").append(zoom_script());
  text += "zoomAll({";
  for (auto const& [key, sentence] : {std::pair("zoom", SentenceRef(says::zoom)),
                                      {"closer", says::zoom_closer},
                                      {"farther", says::zoom_farther},
                                      {"left", says::zoom_left},
                                      {"right", says::zoom_right},
                                      {"all", says::zoom_all},
                                      {"keys", says::zoom_keys}}) {
    text.append(key).append(": \"").append(say(sentence)).append("\", ");
  }
  return text + "});\n";
}

std::string table_element(Table const& table) {
  if (table.rows.empty()) return {};
  std::string text = R"(<table tabindex="0"><thead><tr>)";
  for (auto const& cell : table.header) text += cell_element(cell, "th");
  text += "</tr></thead><tbody>\n";
  for (auto const& row : table.rows) {
    text += "<tr>";
    for (auto const& cell : row) text += cell_element(cell, "td");
    text += "</tr>\n";
  }
  return text + "</tbody></table>\n";
}

std::string figure_element(Figure const& figure, Language language) {
  Figure alone = figure;
  alone.shows_table = false;
  return "<figure>" + svg(alone, language) + "</figure>\n" + table_element(figure.table);
}

std::string page(Figure const& figure, Language language) {
  std::string_view const code = language == Language::german ? "de" : "en";
  std::string text = "<!doctype html>\n<html lang=\"";
  text.append(code).append("\"><head><meta charset=\"utf-8\">\n");
  text += R"(<meta name="viewport" content="width=device-width,initial-scale=1">)";
  text += "\n<title>" + escaped(figure.title) + "</title>\n<style>\n";
  text.append(page_style());
  return text + "</style></head>\n<body><main>\n<h1>" + escaped(figure.title) + "</h1>\n" +
         figure_element(figure, language) + "</main>\n" + zoom_part(language) + "</body></html>\n";
}

}  // namespace axisc::pictures
