#include "diagnostics/fingerprint.hpp"
#include "diagnostics/location.hpp"
#include "diagnostics/report_elements.hpp"
#include "diagnostics/writers.hpp"

#include <string>
#include <string_view>
#include <vector>

#include <nlohmann/json.hpp>

namespace axisc {
namespace {

using Json = nlohmann::ordered_json;

/// "critical" and "blocker" stay for what a person decides.
std::string_view severity_of(Severity severity) {
  switch (severity) {
    case Severity::error:
      return "major";
    case Severity::warning:
      return "minor";
    case Severity::note:
      break;
  }
  return "info";
}

Json as_json(Finding const& finding, SourceSet const& sources, ReportContext const& context,
             Language language) {
  Location const location = finding.place ? locate(*finding.place, sources) : Location{};
  return {{"description", code_text(finding.code) + ": " + render(finding.message, language)},
          {"check_name", code_text(finding.code)},
          {"fingerprint", fingerprint(identity_of(finding, sources), 0)},
          {"severity", severity_of(finding.severity)},
          {"location",
           {{"path", shown_path(context.paths, file_of(finding, sources))},
            {"lines", {{"begin", location.begin.line}, {"end", location.end.line}}}}}};
}

}  // namespace

std::string gitlab_element(Finding const& finding, SourceSet const& sources, ReportContext const& context,
                           Language language) {
  std::string const element =
      as_json(finding, sources, context, language).dump(-1, ' ', false, Json::error_handler_t::replace);
  return "\n  " + with_occurrence_hole(element, fingerprint(identity_of(finding, sources), 0));
}

std::string write_gitlab(std::vector<Finding> const& findings, SourceSet const& sources,
                         ReportContext const& context, WriteOptions const& options) {
  std::string text = "[";
  for (Finding const& finding : findings) {
    if (&finding != &findings.front()) text += ',';
    text += fill_holes(gitlab_element(finding, sources, context, options.language),
                       {.occurrence = finding.occurrence});
  }
  return text + (findings.empty() ? "]\n" : "\n]\n");
}

}  // namespace axisc
