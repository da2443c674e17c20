#include "axisc/answers/report/report_page.hpp"

#include "diagnostics/markup.hpp"
#include "presentation/pictures/page.hpp"
#include "presentation/pictures/svg_text.hpp"
#include "presentation/pictures/text_width.hpp"
#include "presentation/writers.hpp"

#include <algorithm>

namespace axisc::says {

constexpr Sentence report_title{"{machine}: acceptance report", "{machine}: Abnahmebericht"};
constexpr Sentence content_of{"contents", "Inhalt"};
constexpr Sentence part_overview{"Overview", "Übersicht"};
constexpr Sentence part_findings{"Findings", "Befunde"};
constexpr Sentence part_changes{"Changes", "Änderungen"};
constexpr Sentence part_axes{"Axes", "Achsen"};
constexpr Sentence part_channels{"Contours", "Konturen"};
constexpr Sentence part_programs{"Programs", "Programme"};
constexpr Sentence part_appendix{"Appendix", "Anhang"};

}  // namespace axisc::says

namespace axisc {

namespace {

std::string_view style() {
  return R"(.cover{display:flex;flex-direction:column}.cover h1{font-size:2rem;margin:.1rem 0 .4rem}.cover h1.long{font-size:1.2rem}.cover h2{border:0;font-size:1.1rem;margin:1rem 0 .1rem}
.cover .kind{margin:0;color:var(--quiet)}.cover p::first-letter,.cover th::first-letter,.overview th::first-letter{text-transform:uppercase}.cover p{margin:.25rem 0}.small{font-size:.85em;color:var(--quiet)}
.facts{display:grid;grid-template-columns:repeat(auto-fit,minmax(16rem,1fr));gap:0 2rem}.facts table{margin:0}.overview th:nth-child(2){min-width:11rem}
.verdict{padding:.5rem 1rem;border-left:.4rem solid;background:var(--panel);font-size:1.1rem;font-weight:600}
.error{border-color:#c1272d}.warning{border-color:#b36b00}.good{border-color:#1b7f4b}
.sign{display:grid;grid-template-columns:1fr 1fr;gap:0 1.5rem;margin-top:1.2rem;break-inside:avoid}.sign .who{grid-column:span 2;font-weight:600}.sign div{display:grid;grid-template-columns:2fr 3fr;gap:0 .8rem}.cover .sign .line{border-top:1px solid var(--ink);margin-top:2.2rem;font-size:.85em;color:var(--quiet)}
nav ul{list-style:none;padding:0;display:flex;flex-wrap:wrap;gap:.3rem 1.2rem}summary{cursor:pointer;color:var(--link);margin:.5rem 0}
code{background:var(--panel);padding:0 .2rem}
@media print{nav,footer,.screen,details:not([open]){display:none}.cover{min-height:262mm;break-after:page}.sign{margin-top:auto}.tight h2{margin-top:.3rem}.tight p{margin:0;line-height:1.3}.tight table{margin:.1rem 0}a{text-decoration:none}
table{display:table;font-size:8.5pt;line-height:1.35}.overview table{font-size:8pt}thead{display:table-header-group}th,td{padding:.1rem .5rem .1rem 0}h3+p,h4+p{break-after:avoid}figure+table{break-inside:avoid}pre{font-size:7.5pt;border:1px solid var(--line)}figure{margin:.4rem 0}h2{margin-top:1.2rem}h3{margin-top:.9rem}pre.long{break-inside:auto}figure svg{max-height:96mm}
)";
}

/// In the margin of each page on paper.
std::string page_margins(ReportCover const& cover) {
  std::string text;
  constexpr double size = 8;
  constexpr double room = 420;
  auto const shown =
      pictures::fitted(cover.date.empty() ? cover.title : cover.title + " · " + cover.date, size, room);
  for (char const letter : shown) {
    if (letter == '"' || letter == '\\') text += '\\';
    text += letter == '<' ? std::string("\\3C ") : std::string(1, letter);
  }
  return "@page{margin:15mm 15mm 18mm;@bottom-left{content:\"" + text +
         "\";font:8pt sans-serif}@bottom-right{content:counter(page) \" / \" counter(pages);font:8pt "
         "sans-serif}}}\n";
}

struct Part {
  std::string_view id;
  SentenceRef name;
  std::string html;
  bool is_printed = true;
};

}  // namespace

std::string ReportSubject::html(ReportBlocks const& blocks, int level) const {
  return presentation::html_of(blocks, level, {.language = language});
}

double ReportSubject::highest_feed() const {
  return *std::max_element(contour.feeds.begin(), contour.feeds.end());
}

std::string report_page(ReportSubject const& subject) {
  auto const html = [&subject](ReportBlocks const& blocks) { return subject.html(blocks, 3); };
  auto const cover = report_cover(subject);
  bool const has_own_overview = subject.plots && !cover.has_whole_overview;
  std::vector<Part> const parts = {
      {"overview", says::part_overview, has_own_overview ? report_overview(subject) : std::string()},
      {"findings", says::part_findings, html(findings_section(subject))},
      {"changes", says::part_changes, html(changes_section(subject))},
      {"axes", says::part_axes, html(axes_section(subject))},
      {"contours", says::part_channels, html(channels_section(subject))},
      {"programs", says::part_programs, html(programs_section(subject))},
      // After errors it holds nothing but what is folded away.
      {"appendix", says::part_appendix, html(appendix_section(subject)), subject.plots.has_value()}};
  std::string const title = subject.say(says::report_title, {{"machine", subject.cover.title}});
  std::string text = "<!doctype html>\n<html lang=\"";
  text += subject.language == Language::german ? "de" : "en";
  text += "\"><head><meta charset=\"utf-8\">\n";
  text += R"(<meta name="viewport" content="width=device-width,initial-scale=1">)";
  text += "\n<title>" + escaped(title) + "</title>\n<style>\n";
  text.append(pictures::page_style()).append(style()).append(page_margins(subject.cover));
  text += "</style></head>\n<body><main>\n" + cover.html;
  text += "<nav" + pictures::attribute("aria-label", subject.say(says::content_of)) + "><ul>";
  for (auto const& part : parts) {
    if (part.html.empty()) continue;
    text += "<li><a href=\"#" + std::string(part.id) + "\">" + escaped(subject.say(part.name)) + "</a></li>";
  }
  text += "</ul></nav>\n";
  for (auto const& part : parts) {
    if (part.html.empty()) continue;
    text += "<h2" + pictures::attribute("id", part.id) +
            (part.is_printed ? "" : pictures::attribute("class", "screen")) + ">" + subject.say(part.name) +
            "</h2>\n" + part.html;
  }
  text += "</main>\n";
  if (subject.plots) text += pictures::zoom_part(subject.language);
  return text + "</body></html>\n";
}

}  // namespace axisc
