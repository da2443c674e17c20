#include "axisc/answers/explain/explain_answer.hpp"
#include "axisc/answers/report/report_page.hpp"
#include "presentation/pictures/svg_text.hpp"
#include "validator/engine/rule.hpp"

#include <set>

namespace axisc::says {

constexpr Sentence no_findings{"Nothing was found.", "Nichts gefunden."};
constexpr Sentence more_findings{"{count} more findings: `axisc lint` prints all.",
                                 "{count} weitere Befunde: `axisc lint` zeigt alle."};

}  // namespace axisc::says

namespace axisc {

std::string findings_section(ReportSubject const& subject) {
  auto const paragraph = [&](std::string const& words) {
    return "<p>" + pictures::escaped(words) + "</p>\n";
  };
  if (subject.findings.empty()) return paragraph(subject.say(says::no_findings));
  std::string text;
  std::size_t shown = 0;
  for (auto const& finding : subject.findings) {
    if (++shown > most_shown_findings) break;
    std::string const code = code_text(finding.code);
    text += R"(<section class="finding"><h3>)";
    text += pictures::escaped(presentation::text_of(severity_symbol(finding.severity), subject.language));
    text.append(": <a")
        .append(pictures::attribute("href", "#" + code))
        .append(">")
        .append(code)
        .append("</a> ");
    text += pictures::escaped(finding.name);
    text += "</h3>\n<pre tabindex=\"0\">";
    text.append(pictures::escaped(finding.text)).append("</pre></section>\n");
  }
  if (subject.findings.size() <= most_shown_findings) return text;
  return text +
         paragraph(subject.say(says::more_findings,
                               {{"count", std::to_string(subject.findings.size() - most_shown_findings)}}));
}

ReportBlocks explanations_section(ReportSubject const& subject) {
  std::set<Code> codes;
  for (std::size_t i = 0; i < subject.findings.size() && i < most_shown_findings; ++i) {
    codes.insert(subject.findings[i].code);
  }
  ReportBlocks blocks;
  for (auto const code : codes) {
    if (auto const* const rule = validator::find_rule(code)) blocks.emplace_back(rule_section(*rule));
  }
  return blocks;
}

}  // namespace axisc
