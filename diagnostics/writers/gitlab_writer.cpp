#include "diagnostics/fingerprint.hpp"
#include "diagnostics/location.hpp"
#include "diagnostics/writers/json_stream.hpp"
#include "diagnostics/writers/report_elements.hpp"
#include "diagnostics/writers/writers.hpp"

#include <string>
#include <string_view>
#include <vector>

#include <nlohmann/json.hpp>

namespace axisc {
namespace {

using Json = nlohmann::ordered_json;

/// "critical" and "blocker" are left to human judgement.
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

/// `element` with the hole where the fingerprint `zeroth` ends with its 0.
std::string with_hole_for_occurrence(std::string_view element, std::string_view zeroth) {
  // Quotes inside strings are escaped, so this occurs only at the end of a whole string.
  std::string const end = std::string(zeroth) + '"';
  std::string text;
  while (true) {
    std::size_t const found = element.find(end);
    if (found == std::string_view::npos) return text.append(element);
    text.append(element.substr(0, found)).append(zeroth.substr(0, zeroth.size() - 1));
    text += occurrence_hole;
    element.remove_prefix(found + zeroth.size());
  }
}

Json as_json(Finding const& finding, SourceSet const& sources, ReportContext const& context,
             Language language, std::string const& zeroth) {
  Location const location = finding.place ? locate(*finding.place, sources) : Location{};
  return {
      {"description", code_text(finding.code) + ": " + render(finding.message, language, Values::as_given)},
      {"check_name", code_text(finding.code)},
      {"fingerprint", zeroth},
      {"severity", severity_of(finding.severity)},
      {"location",
       {{"path", shown_path(context.paths, file_of(finding, sources))},
        {"lines", {{"begin", location.begin.line}, {"end", location.end.line}}}}}};
}

}  // namespace

std::string gitlab_element(Finding const& finding, SourceSet const& sources, ReportContext const& context,
                           Language language) {
  std::string const zeroth = fingerprint(identity_of(finding, sources), 0);
  Json const element = as_json(finding, sources, context, language, zeroth);
  return "\n  " + with_hole_for_occurrence(
                      escape_invisible(element.dump(-1, ' ', false, Json::error_handler_t::replace)), zeroth);
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
