#include "axisc/answers/difference/diff_words.hpp"
#include "axisc/answers/report/html.hpp"
#include "axisc/answers/report/report_page.hpp"
#include "presentation/pictures/page.hpp"

namespace axisc::says {

constexpr Sentence change_what{"what", "was"};
constexpr Sentence change_before{"before", "vorher"};
constexpr Sentence change_now{"now", "jetzt"};
constexpr Sentence change_parameter{"parameter", "Parameter"};
constexpr Sentence change_meaning{"meaning", "Bedeutung"};
constexpr Sentence change_restart{"restart", "Neustart"};

}  // namespace axisc::says

namespace axisc {

namespace {

std::string lines_table(ReportSubject const& subject, std::vector<DiffLine> const& lines) {
  pictures::Table table;
  table.header = {subject.say(says::change_what), subject.say(says::change_before),
                  subject.say(says::change_now)};
  for (auto const& line : lines) table.rows.push_back({line.what, line.before, line.after});
  return pictures::table_element(table);
}

std::string parameters_table(ReportSubject const& subject, std::vector<DiffParameter> const& parameters) {
  pictures::Table table;
  table.header = {subject.say(says::change_parameter), subject.say(says::change_before),
                  subject.say(says::change_now), subject.say(says::change_meaning),
                  subject.say(says::change_restart)};
  for (auto const& parameter : parameters) {
    table.rows.push_back({parameter.line.what, parameter.line.before, parameter.line.after, parameter.meaning,
                          parameter.restart});
  }
  return pictures::table_element(table);
}

}  // namespace

std::string changes_section(ReportSubject const& subject) {
  if (subject.difference == nullptr) return {};
  auto const& shown = *subject.difference;
  DiffWords const words(shown, subject.language);
  if (shown.difference.empty()) return text_of("p", words.nothing(shown.before, shown.after)) + "\n";
  std::string text = text_of("p", shown.heading()) + "\n" + lines_table(subject, words.machine());
  auto sections = words.channels();
  for (auto& section : words.axes()) sections.push_back(std::move(section));
  for (auto const& section : sections) {
    text += text_of("h3", section.title) + "\n" + lines_table(subject, section.facts) +
            parameters_table(subject, section.parameters) + lines_table(subject, section.effects);
  }
  for (auto const& remark : words.remarks()) text += text_of("p", remark) + "\n";
  return text;
}

}  // namespace axisc
