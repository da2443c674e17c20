#include "cli/finding_report.hpp"

namespace axisc::cli {

std::string texts_of(std::vector<Finding> const& findings, SourceSet const& sources,
                     WriteOptions const& options) {
  std::string text;
  for (auto const& finding : findings) text += write_text(finding, sources, options) + "\n";
  return text;
}

std::string document_of(FindingFormat format, std::vector<Finding> const& findings, SourceSet const& sources,
                        RunFacts const& run, ReportContext const& context, WriteOptions const& options) {
  switch (format) {
    case FindingFormat::text:
      return texts_of(findings, sources, options);
    case FindingFormat::json:
      return write_json(findings, sources, run, options);
    case FindingFormat::sarif:
      return write_sarif(findings, sources, context, options);
    case FindingFormat::gitlab:
      return write_gitlab(findings, sources, context, options);
    case FindingFormat::github:
      break;
  }
  std::string text;
  for (auto const& finding : findings) text += write_github(finding, sources, context, options);
  return text;
}

}  // namespace axisc::cli
