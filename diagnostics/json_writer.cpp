#include "diagnostics/json_layout.hpp"
#include "diagnostics/location.hpp"
#include "diagnostics/report_elements.hpp"
#include "diagnostics/writers.hpp"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <nlohmann/json.hpp>

namespace axisc {
namespace {

using Json = nlohmann::ordered_json;

Json string_or_null(std::string_view text) {
  return text.empty() ? Json() : Json(text);
}

Json as_json(Related const& related, SourceSet const& sources, Language language) {
  Location const location = locate(related.place, sources);
  return {{"file", location.file},
          {"line", location.begin.line},
          {"column", location.begin.column},
          {"message", render(related.message, language)}};
}

Json as_json(Edit const& edit, SourceSet const& sources) {
  Location const location = locate(edit.place, sources);
  return {
      {"file", location.file},         {"line", location.begin.line},       {"column", location.begin.column},
      {"end_line", location.end.line}, {"end_column", location.end.column}, {"text", edit.text}};
}

Json as_json(std::optional<Fix> const& fix, SourceSet const& sources, Language language) {
  if (!fix) return {};
  Json edits = Json::array();
  for (Edit const& edit : fix->edits) edits.push_back(as_json(edit, sources));
  return {{"title", render(fix->title, language)}, {"edits", std::move(edits)}};
}

Json as_json(std::optional<ControlReaction> const& control, Language language) {
  if (!control) return {};
  return {{"message", string_or_null(control->message)},
          {"reaction", control->reaction ? Json(render(*control->reaction, language)) : Json()},
          {"value", string_or_null(control->value)}};
}

// The label is a note whose place is the finding's own; help is a note that advises.
Json notes_of(Finding const& finding, Language language) {
  Json notes = Json::array();
  if (finding.label) notes.push_back(render(*finding.label, language));
  for (Message const& note : finding.notes) notes.push_back(render(note, language));
  for (Message const& help : finding.help) notes.push_back(render(help, language));
  return notes;
}

Json as_json(Finding const& finding, SourceSet const& sources, Language language) {
  std::optional<Location> location;
  if (finding.place) location = locate(*finding.place, sources);
  Json related = Json::array();
  for (Related const& place : finding.related) related.push_back(as_json(place, sources, language));
  return {{"code", code_text(finding.code)},
          {"name", finding.name},
          {"severity", severity_name(finding.severity)},
          {"message", render(finding.message, language)},
          {"file", string_or_null(file_of(finding, sources))},
          {"line", location ? Json(location->begin.line) : Json()},
          {"column", location ? Json(location->begin.column) : Json()},
          {"end_line", location ? Json(location->end.line) : Json()},
          {"end_column", location ? Json(location->end.column) : Json()},
          {"parameter", string_or_null(finding.parameter)},
          {"p_axis", string_or_null(finding.p_axis)},
          {"axis", string_or_null(finding.axis)},
          {"control", as_json(finding.control, language)},
          {"notes", notes_of(finding, language)},
          {"related", std::move(related)},
          {"fix", as_json(finding.fix, sources, language)}};
}

Json as_json(Identity const& identity) {
  return {{"code", code_text(identity.code)}, {"axis", identity.axis}, {"parameter", identity.parameter}};
}

Json summary(FindingCounts const& counts, RunFacts const& run) {
  Json summary = {{"files", run.files},
                  {"errors", counts.errors},
                  {"warnings", counts.warnings},
                  {"notes", counts.notes}};
  if (run.fixes) summary["fixed"] = run.fixes->applied;
  if (run.baseline) {
    Json stale = Json::array();
    for (Identity const& identity : run.baseline->stale) stale.push_back(as_json(identity));
    summary["baseline"] = {{"hidden", run.baseline->hidden}, {"stale", std::move(stale)}};
  }
  return summary;
}

Json statistics(std::vector<CodeCount> const& codes) {
  Json rows = Json::array();
  for (CodeCount const& row : codes) {
    rows.push_back(
        {{"code", code_text(row.code)}, {"name", row.name}, {"count", row.count}, {"fixable", row.fixable}});
  }
  return rows;
}

}  // namespace

std::string json_head() {
  return "{\n  \"version\": 1,\n  \"diagnostics\": [";
}

std::string json_element(Finding const& finding, SourceSet const& sources, Language language) {
  std::string text = "\n    ";
  append_indented(text, as_json(finding, sources, language), "    ");
  return text;
}

std::string json_tail(bool has_elements, RunFacts const& run, FindingCounts const& counts,
                      std::vector<CodeCount> const& codes, std::string_view shard) {
  std::string text = has_elements ? "\n  ],\n  \"summary\": " : "],\n  \"summary\": ";
  append_indented(text, summary(counts, run), "  ");
  if (run.statistics) {
    text += ",\n  \"statistics\": ";
    append_indented(text, statistics(codes), "  ");
  }
  if (!shard.empty()) text += ",\n  \"shard\": " + std::string(shard);
  return text + "\n}\n";
}

std::string write_json(std::vector<Finding> const& findings, SourceSet const& sources, RunFacts const& run,
                       WriteOptions const& options) {
  std::string text = json_head();
  for (Finding const& finding : findings) {
    if (&finding != &findings.front()) text += ',';
    text += json_element(finding, sources, options.language);
  }
  return text + json_tail(!findings.empty(), run, count(findings), count_codes(findings));
}

}  // namespace axisc
