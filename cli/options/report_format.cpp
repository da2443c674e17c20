#include "cli/options/report_format.hpp"

#include "diagnostics/writers/report_elements.hpp"

namespace axisc::cli {

void append_element(std::string& text, Finding const& finding, SourceSet const& sources,
                    ReportFormat const& report_format) {
  auto const language = report_format.write.language;
  switch (report_format.format) {
    case FindingFormat::text:
      append_text(text, finding, sources, report_format.write);
      text += '\n';
      break;
    case FindingFormat::json:
      append_json_element(text, finding, sources, language);
      break;
    case FindingFormat::sarif:
      append_sarif_element(text, finding, sources, report_format.context, language);
      break;
    case FindingFormat::gitlab:
      text += gitlab_element(finding, sources, report_format.context, language);
      break;
    case FindingFormat::github:
      text += write_github(finding, sources, report_format.context, report_format.write);
      break;
  }
}

std::string texts_of(std::vector<Finding> const& findings, SourceSet const& sources,
                     WriteOptions const& options) {
  std::string text;
  for (auto const& finding : findings) text += write_text(finding, sources, options) + "\n";
  return text;
}

}  // namespace axisc::cli
