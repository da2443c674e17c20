#include "axisc/answers/explain/explain_answer.hpp"
#include "axisc/answers/labels.hpp"
#include "axisc/answers/report/report_page.hpp"
#include "axisc/asked/filter_symbols.hpp"
#include "validator/engine/rule_title.hpp"

#include <set>

namespace axisc::says {

constexpr Sentence sources_title{"Sources", "Quellen"};
constexpr Sentence fact_sources{"SHA-256 of all sources", "SHA-256 aller Quellen"};
constexpr Sentence delays_title{"Delay budget: every item, by parameter and line",
                                "Verzögerungsbilanz: jeder Posten mit Parameter und Zeile"};
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
    add_row(lists, {shown(labels::list, name), shown(as_given("SHA-256"), hexadecimal(sha256))});
  }
  return part(says::sources_title, {Facts{{shown(labels::compiler, "axisc " + contents.compiler_version),
                                           shown(says::fact_sources, hexadecimal(contents.source_digest))}},
                                    std::move(lists)});
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
    blocks.emplace_back(folded(says::delays_title, subject.delays));
  }
  add_findings(blocks, subject.findings);
  return blocks;
}

}  // namespace axisc
