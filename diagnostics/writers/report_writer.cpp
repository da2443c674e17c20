#include "diagnostics/writers/report_writer.hpp"

#include <utility>

namespace axisc {

std::unique_ptr<ReportWriter> report_writer(FindingFormat format, WriteOptions const& options,
                                            ReportContext context) {
  switch (format) {
    case FindingFormat::json: return json_report(options);
    case FindingFormat::jsonl: return json_lines_report(options);
    case FindingFormat::sarif: return sarif_report(options, std::move(context));
    case FindingFormat::github: return github_report(options, std::move(context));
    case FindingFormat::gitlab: return gitlab_report(options, std::move(context));
    case FindingFormat::junit: return junit_report(options, std::move(context));
    case FindingFormat::text: break;
  }
  return text_report(options);
}

}  // namespace axisc
