#include "diagnostics/location.hpp"
#include "diagnostics/writers/json_stream.hpp"
#include "diagnostics/writers/report_writer.hpp"

#include <string>
#include <string_view>
#include <utility>

#include <nlohmann/json.hpp>

namespace axisc {
namespace {

using Json = nlohmann::ordered_json;

/// "critical" and "blocker" are left to human judgement.
std::string_view severity_of(Severity severity) {
  switch (severity) {
    case Severity::error: return "major";
    case Severity::warning: return "minor";
    case Severity::note: break;
  }
  return "info";
}

Json as_json(Finding const& finding, SourceSet const& sources, std::string_view fingerprint,
             ReportContext const& context, Language language) {
  Location const location = finding.place ? locate(*finding.place, sources) : Location{};
  return {
      {"description", code_text(finding.code) + ": " + render(finding.message, language, Values::as_given)},
      {"check_name", code_text(finding.code)},
      {"fingerprint", fingerprint},
      {"severity", severity_of(finding.severity)},
      {"location",
       {{"path", shown_path(context.paths, file_of(finding, sources))},
        {"lines", {{"begin", location.begin.line}, {"end", location.end.line}}}}}};
}

class GitlabReport final : public ReportWriter {
 public:
  GitlabReport(Language language, ReportContext context)
      : language_(language), context_(std::move(context)) {}

  void begin(std::string& out) override { out += '['; }

  void add(std::string& out, Finding const& finding, SourceSet const& sources,
           std::string_view fingerprint) override {
    out += std::exchange(has_elements_, true) ? ",\n  " : "\n  ";
    Json const element = as_json(finding, sources, fingerprint, context_, language_);
    out += escape_invisible(element.dump(-1, ' ', false, Json::error_handler_t::replace));
  }

  void end(Print const& print, RunFacts const& /*run*/) override { print(has_elements_ ? "\n]\n" : "]\n"); }

 private:
  Language language_;
  ReportContext context_;
  bool has_elements_ = false;
};

}  // namespace

std::unique_ptr<ReportWriter> gitlab_report(WriteOptions const& options, ReportContext context) {
  return std::make_unique<GitlabReport>(options.language, std::move(context));
}

}  // namespace axisc
