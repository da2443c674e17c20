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

Json as_json(Finding const& finding, SourceSet const& sources, ReportContext const& context,
             Language language) {
  Location const location = finding.place ? locate(*finding.place, sources) : Location{};
  return {
      {"description", code_text(finding.code) + ": " + render(finding.message, language, Values::as_given)},
      {"check_name", code_text(finding.code)},
      {"fingerprint", ""},
      {"severity", severity_of(finding.severity)},
      {"location",
       {{"path", shown_path(context.paths, file_of(finding, sources))},
        {"lines", {{"begin", location.begin.line}, {"end", location.end.line}}}}}};
}

}  // namespace

std::string gitlab_element(Finding const& finding, SourceSet const& sources, ReportContext const& context,
                           Language language) {
  // Quotes inside strings are escaped, so this occurs only once.
  constexpr std::string_view empty = R"("fingerprint":"")";
  Json const element = as_json(finding, sources, context, language);
  std::string text = escape_invisible(element.dump(-1, ' ', false, Json::error_handler_t::replace));
  return "\n  " + text.insert(text.find(empty) + empty.size() - 1, 1, fingerprint_hole);
}

std::string write_gitlab(std::vector<Finding> const& findings, SourceSet const& sources,
                         ReportContext const& context, WriteOptions const& options) {
  std::string text = "[";
  for (Finding const& finding : findings) {
    if (&finding != &findings.front()) text += ',';
    text += fill_holes(gitlab_element(finding, sources, context, options.language),
                       {.fingerprint = fingerprint(finding, sources)});
  }
  return text + (findings.empty() ? "]\n" : "\n]\n");
}

}  // namespace axisc
