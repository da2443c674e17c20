#include "cli/options/report_format.hpp"

#include "diagnostics/writers/report_elements.hpp"

namespace axisc::cli {

void append_element(std::string& text, Finding const& finding, SourceSet const& sources,
                    ReportForm const& form) {
  auto const language = form.write.language;
  switch (form.format) {
    case FindingFormat::text:
      append_text(text, finding, sources, form.write);
      text += '\n';
      break;
    case FindingFormat::json:
      append_json_element(text, finding, sources, language);
      break;
    case FindingFormat::sarif:
      append_sarif_element(text, finding, sources, form.context, language);
      break;
    case FindingFormat::gitlab:
      text += gitlab_element(finding, sources, form.context, language);
      break;
    case FindingFormat::github:
      text += write_github(finding, sources, form.context, form.write);
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
