#include "axisc/answers/certify/bound_quantity.hpp"
#include "axisc/answers/explain/explain_answer.hpp"
#include "axisc/answers/labels.hpp"
#include "axisc/answers/report/report_page.hpp"
#include "codegen/source_digest.hpp"
#include "image/proved_bounds.hpp"
#include "validator/engine/rule_title.hpp"

#include <algorithm>
#include <set>

namespace axisc::says {

constexpr Sentence sources_title{"Sources", "Quellen"};
constexpr Sentence fact_sources{"SHA-256 of all sources", "SHA-256 aller Quellen"};
constexpr Sentence delays_title{"Delay budget: every item, by parameter and line",
                                "Verzögerungsbilanz: jeder Posten mit Parameter und Zeile"};
constexpr Sentence proved_title{"What the image proves, whatever the setpoints are (`axisc certify`)",
                                "Was das Abbild beweist, wie auch die Sollwerte sind (`axisc certify`)"};
constexpr Sentence amplified{"amplified at most", "verstärkt höchstens"};
constexpr Sentence overshoots{"overshoot at most", "Überschwingen höchstens"};
constexpr Sentence at_rest{"exactly at rest after", "exakt in Ruhe nach"};
constexpr Sentence not_proved{"not proved", "nicht bewiesen"};
constexpr Sentence all_findings{"{count} findings in full", "{count} Befunde im Wortlaut"};
constexpr Sentence more_findings{"{count} more findings: `axisc lint` prints all.",
                                 "{count} weitere Befunde: `axisc lint` zeigt alle."};
constexpr Sentence explanation_title{"{code}: {title}", "{code}: {title}"};

}  // namespace axisc::says

namespace axisc {

using namespace presentation;

namespace {

Section sources(image::ImageContents const& contents) {
  Table lists{.key = {}};
  for (auto const& [name, sha256] : contents.lists) {
    add_row(lists, {shown(labels::list, name), shown(as_given("SHA-256"), codegen::hexadecimal(sha256))});
  }
  return part(says::sources_title,
              {Facts{{shown(labels::compiler, "axisc " + contents.compiler_version),
                      shown(says::fact_sources, codegen::hexadecimal(contents.source_digest))}},
               std::move(lists)});
}

Section proved(PlotSubject const& plots) {
  Table table{.key = {}};
  constexpr int digits = 4;
  constexpr double least_percent = 1e-3;  // less is rounding
  for (auto const axis : plots.axes) {
    auto const bounds = image::proved_bounds(plots.now.file.bytes.bytes(), static_cast<std::uint32_t>(axis));
    double const cycle_ms = plots.contents().cycle_time.seconds() * 1e3;
    Value const rest = bounds.rest_cycles
                           ? Value(upper_bound(static_cast<double>(*bounds.rest_cycles) * cycle_ms, digits,
                                               Unit::millisecond))
                           : Value(Words(says::not_proved));
    add_row(table, {shown(labels::axis, plots.name(axis)),
                    shown(says::amplified, upper_bound(bounds.gain_high, digits)),
                    shown(says::overshoots, upper_bound(std::max(bounds.overshoot_high * 100, least_percent),
                                                        digits, Unit::percent)),
                    shown(says::at_rest, rest)});
  }
  return part(says::proved_title, {std::move(table)});
}

void add_findings(ReportBlocks& blocks, std::vector<ReportedFinding> const& findings) {
  if (findings.empty()) return;
  std::string text;
  std::set<Code> codes;
  std::size_t count = 0;
  for (auto const& finding : findings) {
    if (count == most_shown_findings) break;
    ++count;
    text += finding.text + "\n";
    codes.insert(finding.code);
  }
  blocks.emplace_back(
      folded(Words(says::all_findings, {{"count", count}}), {Verbatim{.key = {}, .text = std::move(text)}}));
  if (auto const more = findings.size() - count; more > 0) {
    blocks.emplace_back(Paragraph{Words(says::more_findings, {{"count", more}})});
  }
  for (auto const code : codes) {
    auto const* const rule = validator::find_rule(code);
    if (rule == nullptr) continue;
    auto explanation = rule_section(*rule);
    explanation.title = Words(says::explanation_title,
                              {{"code", code_text(code)}, {"title", Wording(validator::title(*rule))}});
    explanation.is_folded = true;
    // It begins with its title.
    explanation.blocks.erase(explanation.blocks.begin());
    blocks.emplace_back(std::move(explanation));
  }
}

}  // namespace

ReportBlocks appendix_section(ReportSubject const& subject) {
  ReportBlocks blocks;
  if (subject.plots) {
    blocks.emplace_back(sources(subject.plots->contents()));
    blocks.emplace_back(proved(*subject.plots));
    blocks.emplace_back(folded(says::delays_title, subject.delays));
  }
  add_findings(blocks, subject.findings);
  return blocks;
}

}  // namespace axisc
