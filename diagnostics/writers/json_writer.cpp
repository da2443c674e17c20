#include "diagnostics/location.hpp"
#include "diagnostics/writers/json_layout.hpp"
#include "diagnostics/writers/json_stream.hpp"
#include "diagnostics/writers/report_writer.hpp"

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
  JsonElement(JsonStream out, SourceSet const& sources, Language language)
      : sources_(sources), language_(language), out_(out) {}

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

Json summary(RunFacts const& run) {
  Json summary = {{"files", run.files},
                  {"errors", run.counts.errors},
                  {"warnings", run.counts.warnings},
                  {"notes", run.counts.notes}};
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

class JsonReport final : public ReportWriter {
 public:
  explicit JsonReport(Language language) : language_(language) {}

  void begin(std::string& out) override { out += "{\n  \"version\": 1,\n  \"diagnostics\": ["; }

  void add(std::string& out, Finding const& finding, SourceSet const& sources,
           std::string_view /*fingerprint*/) override {
    out += std::exchange(has_elements_, true) ? ",\n    " : "\n    ";
    JsonElement(JsonStream(out, 4), sources, language_).write(finding);
  }

  void end(Print const& print, RunFacts const& run) override {
    std::string out = has_elements_ ? "\n  ],\n  \"summary\": " : "],\n  \"summary\": ";
    append_indented(out, summary(run), "  ");
    if (run.statistics) {
      out += ",\n  \"statistics\": ";
      append_indented(out, statistics(run.codes), "  ");
    }
    print(out + "\n}\n");
  }

 private:
  Language language_;
  bool has_elements_ = false;
};

class JsonLinesReport final : public ReportWriter {
 public:
  explicit JsonLinesReport(Language language) : language_(language) {}

  void add(std::string& out, Finding const& finding, SourceSet const& sources,
           std::string_view /*fingerprint*/) override {
    JsonElement(JsonStream(out), sources, language_).write(finding);
    out += '\n';
  }

 private:
  Language language_;
};

}  // namespace

std::unique_ptr<ReportWriter> json_report(WriteOptions const& options) {
  return std::make_unique<JsonReport>(options.language);
}

std::unique_ptr<ReportWriter> json_lines_report(WriteOptions const& options) {
  return std::make_unique<JsonLinesReport>(options.language);
}

}  // namespace axisc
