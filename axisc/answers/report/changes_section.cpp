#include "axisc/answers/report/report_page.hpp"

namespace axisc {

ReportBlocks changes_section(ReportSubject const& subject) {
  if (subject.difference == nullptr) return {};
  auto answer = difference_answer(*subject.difference);
  answer.blocks.insert(answer.blocks.begin(), presentation::Paragraph{answer.title});
  return std::move(answer.blocks);
}

}  // namespace axisc
