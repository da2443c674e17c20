#include "diagnostics/location.hpp"
#include "diagnostics/writers/json_layout.hpp"
#include "diagnostics/writers/json_stream.hpp"
#include "diagnostics/writers/report_elements.hpp"
#include "diagnostics/writers/writers.hpp"

#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <nlohmann/json.hpp>

namespace axisc {
namespace {

using Json = nlohmann::ordered_json;

/// One of the diagnostics.
class JsonElement {
 public:
  JsonElement(std::string& text, SourceSet const& sources, Language language)
      : sources_(sources), language_(language), out_(text, 4) {}

  void write(Finding const& finding) && {
    out_.begin_object();
    out_.member("code", code_text(finding.code));
    out_.member("name", finding.name);
    out_.member("severity", severity_name(finding.severity));
    say("message", finding.message);
    optional_member("file", file_of(finding, sources_));
    std::optional<Location> location;
    if (finding.place) location = locate(*finding.place, sources_);
    optional_member("line", location ? &location->begin.line : nullptr);
    optional_member("column", location ? &location->begin.column : nullptr);
    optional_member("end_line", location ? &location->end.line : nullptr);
    optional_member("end_column", location ? &location->end.column : nullptr);
    optional_member("parameter", finding.parameter);
    optional_member("p_axis", finding.p_axis);
    optional_member("axis", finding.axis);
    write_control(finding.control);
    write_notes(finding);
    write_related(finding.related);
    write_fix(finding.fix);
    out_.end_object();
  }

 private:
  void say(Message const& message) {
    sentence_.clear();
    append_rendered(sentence_, message, language_);
    out_.string(sentence_);
  }
  void say(std::string_view name, Message const& message) {
    out_.key(name);
    say(message);
  }

  void optional_member(std::string_view name, std::string_view text) {
    out_.key(name);
    out_.string_or_null(text);
  }
  void optional_member(std::string_view name, std::uint32_t const* number) {
    out_.key(name);
    if (number == nullptr) return out_.null();
    out_.number(*number);
  }

  void write_control(std::optional<ControlReaction> const& control) {
    out_.key("control");
    if (!control) return out_.null();
    out_.begin_object();
    optional_member("message", control->message);
    if (control->reaction) {
      say("reaction", *control->reaction);
    } else {
      optional_member("reaction", std::string_view());
    }
    optional_member("value", control->value);
    out_.end_object();
  }

  // The label is a note at the finding's own place; help is a note with advice.
  void write_notes(Finding const& finding) {
    out_.key("notes");
    out_.begin_array();
    if (finding.label) say(*finding.label);
    for (Message const& note : finding.notes) say(note);
    for (Message const& help : finding.help) say(help);
    out_.end_array();
  }

  void write_begin(Location const& location) {
    out_.member("file", location.file);
    out_.member("line", location.begin.line);
    out_.member("column", location.begin.column);
  }

  void write_related(std::vector<Related> const& related) {
    out_.key("related");
    out_.begin_array();
    for (Related const& each : related) {
      out_.begin_object();
      write_begin(locate(each.place, sources_));
      say("message", each.message);
      out_.end_object();
    }
    out_.end_array();
  }

  void write_fix(std::optional<Fix> const& fix) {
    out_.key("fix");
    if (!fix) return out_.null();
    out_.begin_object();
    say("title", fix->title);
    out_.key("edits");
    out_.begin_array();
    for (Edit const& edit : fix->edits) {
      Location const location = locate(edit.place, sources_);
      out_.begin_object();
      write_begin(location);
      out_.member("end_line", location.end.line);
      out_.member("end_column", location.end.column);
      out_.member("text", edit.text);
      out_.end_object();
    }
    out_.end_array();
    out_.end_object();
  }

  SourceSet const& sources_;
  Language language_;
  JsonStream out_;
  std::string sentence_;
};

Json as_json(Identity const& identity) {
  return {{"code", code_text(identity.code)},
          {"file", identity.file},
          {"axis", identity.axis},
          {"parameter", identity.parameter}};
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

void append_json_element(std::string& text, Finding const& finding, SourceSet const& sources,
                         Language language) {
  text += "\n    ";
  JsonElement(text, sources, language).write(finding);
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
    append_json_element(text, finding, sources, options.language);
  }
  return text + json_tail(!findings.empty(), run, count(findings), count_codes(findings));
}

}  // namespace axisc
