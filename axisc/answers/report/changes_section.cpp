#include "axisc/answers/report/report_page.hpp"
#include "presentation/writers.hpp"

namespace axisc {

std::string changes_section(ReportSubject const& subject) {
  if (subject.difference == nullptr) return {};
  auto answer = difference_answer(*subject.difference);
  answer.blocks.insert(answer.blocks.begin(), presentation::Paragraph{answer.title});
  return presentation::html_of(answer.blocks, 3, {.language = subject.language});
}

}  // namespace axisc
