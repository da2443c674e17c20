#include "diagnostics/writers/sarif_result.hpp"

#include "diagnostics/location.hpp"
#include "diagnostics/writers/json_stream.hpp"
#include "diagnostics/writers/sarif_artifact.hpp"

#include <algorithm>
#include <cstddef>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace axisc {
namespace {

class ResultWriter {
 public:
  ResultWriter(SarifResult& result, SourceSet const& sources, ReportContext const& context, Language language)
      : result_(result), sources_(sources), context_(context), language_(language), out_(result.text, 8) {}

  void write(Finding const& finding, std::string_view fingerprint) && {
    out_.begin_object();
    out_.member("ruleId", code_text(finding.code));
    out_.key("ruleIndex");
    out_.raw("");
    result_.rule_index_at = result_.text.size();
    out_.member("level", severity_name(finding.severity));
    write_text("message", whole_message(finding, language_));
    write_location(finding);
    write_related(finding.related);
    write_fingerprints(fingerprint);
    if (finding.fix) write_fix(*finding.fix);
    write_properties(finding);
    out_.end_object();
  }

 private:
  [[nodiscard]] std::string say(Message const& message) const {
    return render(message, language_, Values::as_given);
  }

  void begin_object(std::string_view name) {
    out_.key(name);
    out_.begin_object();
  }
  void begin_array(std::string_view name) {
    out_.key(name);
    out_.begin_array();
  }

  void write_text(std::string_view name, std::string_view text) {
    begin_object(name);
    out_.member("text", text);
    out_.end_object();
  }

  void write_artifact_location(std::string_view file) {
    ArtifactName const name = artifact_name(context_.paths, file);
    begin_object("artifactLocation");
    out_.member("uri", name.uri);
    if (name.in_repository) out_.member("uriBaseId", artifact_root);
    out_.end_object();
  }

  void write_region(std::string_view name, Location const& location) {
    begin_object(name);
    out_.member("startLine", location.begin.line);
    out_.member("startColumn", location.begin.column);
    out_.member("endLine", location.end.line);
    out_.member("endColumn", location.end.column);
    out_.end_object();
  }

  void write_physical_location(Place const& place) {
    Location const location = locate(place, sources_);
    begin_object("physicalLocation");
    write_artifact_location(location.file);
    write_region("region", location);
    out_.end_object();
  }

  void write_location(Finding const& finding) {
    if (!finding.place && finding.file.empty() && finding.parameter.empty()) return;
    begin_array("locations");
    out_.begin_object();
    if (finding.place) {
      write_physical_location(*finding.place);
    } else if (!finding.file.empty()) {
      begin_object("physicalLocation");
      write_artifact_location(finding.file);
      out_.end_object();
    }
    if (!finding.parameter.empty()) {
      begin_array("logicalLocations");
      out_.begin_object();
      out_.member("name", finding.parameter);
      std::string const axis = finding.axis.empty() ? "" : finding.axis + "/";
      out_.member("fullyQualifiedName", axis + finding.parameter);
      out_.member("kind", "parameter");
      out_.end_object();
      out_.end_array();
    }
    out_.end_object();
    out_.end_array();
  }

  void write_related(std::vector<Related> const& related) {
    if (related.empty()) return;
    begin_array("relatedLocations");
    for (std::size_t i = 0; i < related.size(); ++i) {
      out_.begin_object();
      out_.member("id", i + 1);
      write_physical_location(related[i].place);
      write_text("message", say(related[i].message));
      out_.end_object();
    }
    out_.end_array();
  }

  void write_fingerprints(std::string_view fingerprint) {
    begin_object("partialFingerprints");
    // Code hosts compare the second name only; without it they would hash the line.
    for (std::string_view const name : {"axiscIdentity/v2", "primaryLocationLineHash"}) {
      out_.member(name, fingerprint);
    }
    out_.end_object();
  }

  void write_fix(Fix const& fix) {
    begin_array("fixes");
    out_.begin_object();
    write_text("description", say(fix.title));
    begin_array("artifactChanges");
    std::vector<SourceId> changed;
    for (Edit const& edit : fix.edits) {
      SourceId const source = edit.place.source;
      if (std::find(changed.begin(), changed.end(), source) != changed.end()) continue;
      changed.push_back(source);
      write_change(fix, source);
    }
    out_.end_array();
    begin_object("properties");
    out_.key("safe");
    out_.boolean(fix.safety == FixSafety::safe);
    out_.end_object();
    out_.end_object();
    out_.end_array();
  }

  /// The edits of one source.
  void write_change(Fix const& fix, SourceId source) {
    out_.begin_object();
    write_artifact_location(sources_[source].name());
    begin_array("replacements");
    for (Edit const& edit : fix.edits) {
      if (edit.place.source != source) continue;
      out_.begin_object();
      write_region("deletedRegion", locate(edit.place, sources_));
      write_text("insertedContent", edit.text);
      out_.end_object();
    }
    out_.end_array();
    out_.end_object();
  }

  void write_properties(Finding const& finding) {
    bool any = false;
    auto const add = [&](std::string_view name, std::string_view value) {
      if (value.empty()) return;
      if (!std::exchange(any, true)) begin_object("properties");
      out_.member(name, value);
    };
    add("axis", finding.axis);
    add("parameter", finding.parameter);
    add("pAxis", finding.p_axis);
    if (finding.control) {
      add("controlMessage", finding.control->message);
      if (finding.control->reaction) add("controlReaction", say(*finding.control->reaction));
      add("controlValue", finding.control->value);
    }
    if (any) out_.end_object();
  }

  SarifResult& result_;
  SourceSet const& sources_;
  ReportContext const& context_;
  Language language_;
  JsonStream out_;
};

}  // namespace

void write_sarif_result(SarifResult& result, Finding const& finding, SourceSet const& sources,
                        std::string_view fingerprint, ReportContext const& context, Language language) {
  result.code = finding.code;
  result.text.clear();
  ResultWriter(result, sources, context, language).write(finding, fingerprint);
}

}  // namespace axisc
