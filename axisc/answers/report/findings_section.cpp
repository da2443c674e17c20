#include "axisc/answers/explain/explain_answer.hpp"
#include "axisc/answers/labels.hpp"
#include "axisc/answers/report/report_page.hpp"
#include "diagnostics/location.hpp"
#include "diagnostics/writers/writers.hpp"
#include "validator/engine/rule.hpp"
#include "validator/engine/rule_title.hpp"

#include <algorithm>

namespace axisc::says {

constexpr Sentence no_findings{"Nothing was found.", "Nichts gefunden."};
constexpr Sentence finding_title{"{title} ({severity} {code})", "{title} ({severity} {code})"};
constexpr Sentence findings_title{"{title} ({severity} {code}, {count} places)",
                                  "{title} ({severity} {code}, {count} Stellen)"};
constexpr Sentence further_places{"elsewhere", "anderswo"};
constexpr Sentence severity_column{"severity", "Schwere"};
constexpr Sentence finding_column{"finding", "Befund"};
constexpr Sentence count_column{"places", "Stellen"};
constexpr Sentence first_column{"first at", "zuerst in"};
constexpr Sentence remedy_column{"what to do", "was zu tun ist"};
constexpr Sentence code_column{"code", "Code"};

}  // namespace axisc::says

namespace axisc {

using namespace presentation;

namespace {

/// Columns of a page on A4.
constexpr std::size_t widest_line = 100;
constexpr std::size_t most_places = 6;

/// In words, else the name that settings know it by.
Wording title_of(Code code) {
  auto const* const rule = validator::find_rule(code);
  return rule == nullptr ? Wording(code_text(code)) : Wording(validator::title(*rule));
}

Words title_of(FindingGroup const& group) {
  bool const is_one = group.findings.size() == 1;
  return {is_one ? says::finding_title : says::findings_title,
          {{"title", title_of(group.code)},
           {"severity", severity_symbol(group.severity)},
           {"code", code_text(group.code)},
           {"count", group.findings.size()}}};
}

/// The cover has no room for folders; the finding itself says them.
std::string without_folders(std::string_view place) {
  auto const slash = place.rfind('/');
  return std::string(slash == std::string_view::npos ? place : place.substr(slash + 1));
}

/// The first in full, and where the others are.
Section section_of(FindingGroup const& group) {
  Section section{.key = {},
                  .title = title_of(group),
                  .blocks = {Verbatim{.key = {}, .text = group.findings.front()->text}}};
  Table places{.key = {}, .most_shown = most_places};
  for (auto const* const finding : group.findings) {
    if (finding == group.findings.front()) continue;
    add_row(places, {shown(says::further_places, finding->place),
                     shown(says::finding_column, Words(finding->message))});
  }
  section.blocks.emplace_back(std::move(places));
  return section;
}

}  // namespace

void add_finding(ReportSubject& subject, Finding const& finding, SourceSet const& sources) {
  subject.counts.add(finding.severity);
  bool const is_first = std::none_of(
      subject.findings.begin(), subject.findings.end(), [&finding](ReportedFinding const& other) {
        return other.code == finding.code && other.severity == finding.severity;
      });
  ReportedFinding& reported = subject.findings.emplace_back();
  reported = {.severity = finding.severity,
              .code = finding.code,
              .axis = finding.axis,
              .place = std::string(file_of(finding, sources)),
              .message = finding.message,
              .help = {},
              .text = {}};
  if (!finding.help.empty()) reported.help = finding.help.front();
  if (!reported.help && finding.fix) reported.help = finding.fix->title;
  if (finding.place) {
    reported.place += ":" + std::to_string(locate(*finding.place, sources).begin.line);
  }
  // The first of a group is always shown.
  if (subject.findings.size() > most_shown_findings && !is_first) return;
  reported.text =
      write_text(finding, sources, {.language = subject.language, .color = false, .width = widest_line});
}

std::vector<FindingGroup> groups_of(std::vector<ReportedFinding> const& findings) {
  std::vector<FindingGroup> groups;
  for (auto const& finding : findings) {
    auto const known = std::find_if(groups.begin(), groups.end(), [&finding](FindingGroup const& group) {
      return group.code == finding.code && group.severity == finding.severity;
    });
    auto& group = known != groups.end() ? *known : groups.emplace_back();
    group.severity = finding.severity;
    group.code = finding.code;
    group.findings.push_back(&finding);
  }
  std::stable_sort(groups.begin(), groups.end(), [](FindingGroup const& one, FindingGroup const& other) {
    if (one.severity != other.severity) return one.severity < other.severity;
    return one.findings.size() > other.findings.size();
  });
  return groups;
}

Table to_do_table(ReportSubject const& subject) {
  Table table{.key = "findings"};
  for (auto const& group : groups_of(subject.findings)) {
    auto const& first = *group.findings.front();
    auto const code = code_text(group.code);
    add_row(table, {{"severity", says::severity_column, severity_symbol(group.severity)},
                    {"title", says::finding_column, title_of(group.code)},
                    {"count", says::count_column, group.findings.size()},
                    {"place", says::first_column, without_folders(first.place)},
                    {"help", says::remedy_column, first.help ? Value(Words(*first.help)) : Value()},
                    {"code", says::code_column, Link{.text = code, .id = code}}});
  }
  return table;
}

ReportBlocks findings_section(ReportSubject const& subject) {
  if (subject.findings.empty()) return {Paragraph{says::no_findings}};
  ReportBlocks blocks;
  for (auto const& group : groups_of(subject.findings)) blocks.emplace_back(section_of(group));
  return blocks;
}

}  // namespace axisc
