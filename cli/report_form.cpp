#include "cli/report_form.hpp"

#include "diagnostics/report_elements.hpp"

namespace axisc::cli {

std::string element_of(Finding const& finding, SourceSet const& sources, ReportForm const& form) {
  switch (form.format) {
    case FindingFormat::text:
      return write_text(finding, sources, form.write) + "\n";
    case FindingFormat::json:
      return json_element(finding, sources, form.write.language);
    case FindingFormat::sarif:
      return sarif_element(finding, sources, form.context, form.write.language);
    case FindingFormat::gitlab:
      return gitlab_element(finding, sources, form.context, form.write.language);
    case FindingFormat::github:
      break;
  }
  return write_github(finding, sources, form.context, form.write);
}

std::string texts_of(std::vector<Finding> const& findings, SourceSet const& sources,
                     WriteOptions const& options) {
  std::string text;
  for (auto const& finding : findings) text += write_text(finding, sources, options) + "\n";
  return text;
}

}  // namespace axisc::cli
