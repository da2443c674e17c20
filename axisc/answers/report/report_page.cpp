#include "axisc/answers/report/report_page.hpp"

#include "axisc/answers/labels.hpp"
#include "axisc/asked/filter_symbols.hpp"
#include "axisc/checking/report_format.hpp"
#include "presentation/pictures/page.hpp"
#include "presentation/pictures/svg_text.hpp"
#include "presentation/writers.hpp"

namespace axisc::says {

constexpr Sentence report_title{"Filters of {input}", "Filter von {input}"};
constexpr Sentence verdict_errors{"Not ready: {counts}. Nothing is compiled while there are errors.",
                                  "Nicht bereit: {counts}. Solange es Fehler gibt, wird nichts kompiliert."};
constexpr Sentence verdict_warnings{"Can be compiled; look at the warnings: {counts}.",
                                    "Lässt sich kompilieren; vorher die Warnungen ansehen: {counts}."};
constexpr Sentence verdict_good{"Ready: {counts}.", "Bereit: {counts}."};
constexpr Sentence counted{"errors: {errors}, warnings: {warnings}, notes: {notes}",
                           "Fehler: {errors}, Warnungen: {warnings}, Hinweise: {notes}"};
constexpr Sentence fact_sources{"SHA-256 of all sources", "SHA-256 aller Quellen"};
constexpr Sentence content_of{"contents", "Inhalt"};
constexpr Sentence part_findings{"Findings", "Befunde"};
constexpr Sentence part_changes{"Changes", "Änderungen"};
constexpr Sentence part_axes{"Axes", "Achsen"};
constexpr Sentence part_delays{"Delay budget", "Verzögerungsbilanz"};
constexpr Sentence part_channels{"Contours", "Konturen"};
constexpr Sentence part_programs{"Programs", "Programme"};
constexpr Sentence part_explanations{"Explanations", "Erklärungen"};

}  // namespace axisc::says

namespace axisc {

namespace {

std::string_view style() {
  return R"(.verdict{padding:.7rem 1rem;border-left:.4rem solid;background:var(--panel);font-weight:600}
.error{border-color:#c1272d}.warning{border-color:#b36b00}.good{border-color:#1b7f4b}
nav ul{list-style:none;padding:0;display:flex;flex-wrap:wrap;gap:.3rem 1.2rem}summary{cursor:pointer;color:var(--link);margin:.5rem 0}
.finding{margin:1rem 0}.finding h3{margin:.2rem 0}code{background:var(--panel);padding:0 .2rem}

@media print{nav{display:none}details{display:block}}
)";
}

std::string verdict(ReportSubject const& subject) {
  auto const& counts = subject.counts;
  auto const counted = subject.say(says::counted, {{"errors", std::to_string(counts.errors)},
                                                   {"warnings", std::to_string(counts.warnings)},
                                                   {"notes", std::to_string(counts.notes)}});
  auto const [kind, sentence] = counts.errors > 0 ? std::pair("error", SentenceRef(says::verdict_errors))
                                : counts.warnings > 0
                                    ? std::pair("warning", SentenceRef(says::verdict_warnings))
                                    : std::pair("good", SentenceRef(says::verdict_good));
  return "<p class=\"verdict " + std::string(kind) + "\">" +
         pictures::escaped(subject.say(sentence, {{"counts", counted}})) + "</p>\n";
}

std::string facts(ReportSubject const& subject) {
  using namespace presentation;
  if (!subject.plots) return {};
  auto const& contents = subject.plots->contents();
  Table lists{.key = {}};
  for (auto const& [name, sha256] : contents.lists) {
    add_row(lists, {shown(labels::list, name), shown(as_given("SHA-256"), hexadecimal(sha256))});
  }
  return html_of(
      {Facts{{shown(labels::cycle_time, exact(contents.cycle_time.microseconds(), Unit::microsecond)),
              shown(labels::axes, subject.plots->names()),
              shown(labels::compiler, "axisc " + contents.compiler_version),
              shown(says::fact_sources, hexadecimal(contents.source_digest))}},
       std::move(lists)},
      2, {.language = subject.language});
}

struct Part {
  std::string_view id;
  SentenceRef name;
  std::string html;
};

}  // namespace

void add_finding(ReportSubject& subject, Finding const& finding, SourceSet const& sources) {
  subject.counts.add(finding.severity);
  bool const is_shown = subject.findings.size() < most_shown_findings;
  subject.findings.push_back(
      {.severity = finding.severity,
       .code = finding.code,
       .name = finding.name,
       .text = is_shown ? texts_of({finding}, sources, {.language = subject.language, .color = false})
                        : std::string()});
}

std::string report_page(ReportSubject const& subject) {
  auto const html = [&](ReportBlocks const& blocks) {
    return presentation::html_of(blocks, 3, {.language = subject.language});
  };
  std::vector<Part> const parts = {
      {.id = "findings", .name = says::part_findings, .html = findings_section(subject)},
      {.id = "changes", .name = says::part_changes, .html = html(changes_section(subject))},
      {.id = "axes", .name = says::part_axes, .html = html(axes_section(subject))},
      {.id = "delays", .name = says::part_delays, .html = html(subject.delays)},
      {.id = "contours", .name = says::part_channels, .html = html(channels_section(subject))},
      {.id = "programs", .name = says::part_programs, .html = html(programs_section(subject))},
      {.id = "explanations", .name = says::part_explanations, .html = html(explanations_section(subject))}};
  std::string const title = subject.say(says::report_title, {{"input", subject.input}});
  std::string text = "<!doctype html>\n<html lang=\"";
  text += subject.language == Language::german ? "de" : "en";
  text += "\"><head><meta charset=\"utf-8\">\n";
  text += R"(<meta name="viewport" content="width=device-width,initial-scale=1">)";
  text += "\n<title>" + pictures::escaped(title) + "</title>\n<style>\n";
  text.append(pictures::page_style()).append(style());
  text += "</style></head>\n<body><main>\n<h1>" + pictures::escaped(title) + "</h1>\n" + verdict(subject) +
          facts(subject);
  text += "<nav" + pictures::attribute("aria-label", subject.say(says::content_of)) + "><ul>";
  for (auto const& part : parts) {
    if (part.html.empty()) continue;
    text += "<li><a href=\"#" + std::string(part.id) + "\">" + pictures::escaped(subject.say(part.name)) +
            "</a></li>";
  }
  text += "</ul></nav>\n";
  for (auto const& part : parts) {
    if (part.html.empty()) continue;
    text += "<h2" + pictures::attribute("id", part.id) + ">" + subject.say(part.name) + "</h2>\n" + part.html;
  }
  text += "</main>\n";
  if (subject.plots) text += pictures::zoom_part(subject.language);
  return text + "</body></html>\n";
}

}  // namespace axisc
