#include "diagnostics/fingerprint.hpp"
#include "diagnostics/json_layout.hpp"
#include "diagnostics/json_stream.hpp"
#include "diagnostics/location.hpp"
#include "diagnostics/pages.hpp"
#include "diagnostics/report_elements.hpp"
#include "diagnostics/writers.hpp"

#include <algorithm>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <nlohmann/json.hpp>

namespace axisc {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::string_view schema =
    "https://docs.oasis-open.org/sarif/sarif/v2.1.0/errata01/os/schemas/sarif-schema-2.1.0.json";
constexpr std::string_view root_name = "SRCROOT";

std::string_view first_paragraph(std::string_view text) {
  return text.substr(0, std::min(text.find('\n'), text.size()));
}

std::string_view first_sentence(std::string_view paragraph) {
  std::size_t const end = std::min(paragraph.find(". "), paragraph.size() - 1) + 1;
  std::string_view const sentence = paragraph.substr(0, end);
  return sentence.ends_with(':') ? sentence.substr(0, end - 1) : sentence;
}

/// A file as SARIF names it.
struct ArtifactName {
  std::string uri;
  bool in_repository = false;  ///< `uri` counts from the root
};

ArtifactName artifact_name(RepositoryPaths const& paths, std::string_view file) {
  if (auto const path = path_in_repository(paths, file)) return {.uri = as_uri(*path), .in_repository = true};
  bool const is_absolute = file.substr(0, 1) == "/";
  return {.uri = (is_absolute ? "file://" : "") + as_uri(file), .in_repository = false};
}

Json artifact_location(RepositoryPaths const& paths, std::string_view file) {
  ArtifactName const name = artifact_name(paths, file);
  Json location = {{"uri", name.uri}};
  if (name.in_repository) location["uriBaseId"] = root_name;
  return location;
}

/// What stands in front of the results.
class SarifHead {
 public:
  SarifHead(std::set<Code> const& codes, std::vector<Artifact> const& artifacts, ReportContext const& context,
            Language language)
      : codes_(codes), artifacts_(artifacts), context_(context), language_(language) {}

  [[nodiscard]] std::string write() const {
    std::string text = "{\n  \"$schema\": \"" + std::string(schema) +
                       "\",\n  \"version\": \"2.1.0\",\n  \"runs\": [\n    {\n      \"tool\": ";
    append_indented(text, tool(), "      ");
    append_member(text, "language", language_ == Language::german ? "de" : "en");
    append_member(text, "columnKind", "unicodeCodePoints");
    append_member(text, "originalUriBaseIds",
                  {{root_name, {{"description", {{"text", "The root of the repository."}}}}}});
    append_member(text, "invocations", Json::array({invocation()}));
    append_member(text, "artifacts", artifacts());
    return text + ",\n      \"results\": [";
  }

 private:
  static void append_member(std::string& text, std::string_view name, Json const& value) {
    text += ",\n      \"" + std::string(name) + "\": ";
    append_indented(text, value, "      ");
  }

  /// Only the rules that the results name: the pages of all of them would outweigh the findings.
  [[nodiscard]] Json tool() const {
    Json rules = Json::array();
    for (RuleFacts const& rule : context_.rules) {
      if (codes_.contains(rule.code)) rules.push_back(descriptor(rule));
    }
    return {{"driver",
             {{"name", "axisc"},
              {"version", context_.version},
              {"semanticVersion", context_.version},
              {"rules", std::move(rules)}}}};
  }

  [[nodiscard]] Json descriptor(RuleFacts const& rule) const {
    std::string_view const text = page(rule.code, language_);
    std::string_view const paragraph = text.empty() ? rule.name : first_paragraph(text);
    Json descriptor = {{"id", code_text(rule.code)},
                       {"name", rule.name},
                       {"shortDescription", {{"text", first_sentence(paragraph)}}},
                       {"fullDescription", {{"text", paragraph}}},
                       {"help", {{"text", text.empty() ? paragraph : text}}},
                       {"defaultConfiguration", {{"level", severity_name(rule.severity)}}}};
    if (!text.empty()) descriptor["help"]["markdown"] = text;
    if (!rule.control.empty()) descriptor["properties"] = {{"controlMessages", rule.control}};
    return descriptor;
  }

  [[nodiscard]] Json invocation() const {
    Json notifications = Json::array();
    for (std::string const& failure : context_.failures) {
      notifications.push_back({{"level", "error"}, {"message", {{"text", failure}}}});
    }
    Json invocation = {{"executionSuccessful", context_.failures.empty()}};
    if (!notifications.empty()) invocation["toolExecutionNotifications"] = std::move(notifications);
    return invocation;
  }

  [[nodiscard]] Json artifacts() const {
    Json artifacts = Json::array();
    for (Artifact const& artifact : artifacts_) {
      artifacts.push_back(
          {{"location", artifact_location(context_.paths, artifact.name)},
           {"encoding", artifact.encoding == Encoding::windows_1252 ? "windows-1252" : "UTF-8"}});
    }
    return artifacts;
  }

  std::set<Code> const& codes_;
  std::vector<Artifact> const& artifacts_;
  ReportContext const& context_;
  Language language_;
};

/// One of the results, with holes.
class SarifResult {
 public:
  SarifResult(SourceSet const& sources, ReportContext const& context, Language language)
      : sources_(sources), context_(context), language_(language) {}

  [[nodiscard]] std::string write(Finding const& finding) && {
    constexpr std::string_view rule_index{&rule_index_hole, 1};
    text_.reserve(usual_size);
    out_.begin_object();
    out_.member("ruleId", code_text(finding.code));
    out_.key("ruleIndex");
    out_.raw(rule_index);
    out_.member("level", severity_name(finding.severity));
    write_text("message", whole_message(finding, language_));
    write_location(finding);
    write_related(finding.related);
    write_fingerprints(finding);
    if (finding.fix) write_fix(*finding.fix);
    write_properties(finding);
    out_.end_object();
    return std::move(text_);
  }

 private:
  [[nodiscard]] std::string say(Message const& message) const { return render(message, language_); }

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
    if (name.in_repository) out_.member("uriBaseId", root_name);
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

  void write_fingerprints(Finding const& finding) {
    std::string identity = fingerprint(identity_of(finding, sources_), 0);
    identity.back() = occurrence_hole;
    std::string const quoted = '"' + identity + '"';
    begin_object("partialFingerprints");
    // Code hosts compare the second name only; without it they would hash the line.
    for (std::string_view const name : {"axiscIdentity/v1", "primaryLocationLineHash"}) {
      out_.key(name);
      out_.raw(quoted);
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

  /// All edits of one source.
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

  static constexpr std::size_t usual_size = 2048;

  SourceSet const& sources_;
  ReportContext const& context_;
  Language language_;
  std::string text_ = "\n        ";
  JsonStream out_{text_, 8};
};

/// Those of all findings; sources that several inputs share are one.
std::vector<Artifact> artifacts_of(std::vector<Finding> const& findings, SourceSet const& sources,
                                   RepositoryPaths const& paths) {
  std::set<SourceId> used;
  for (Finding const& finding : findings) used.merge(sources_of(finding));
  std::set<std::string> named;
  std::vector<Artifact> artifacts;
  for (SourceId const id : used) {
    SourceText const& source = sources[id];
    if (named.insert(shown_path(paths, source.name())).second) {
      artifacts.push_back({source.name(), source.encoding()});
    }
  }
  return artifacts;
}

}  // namespace

std::string sarif_head(std::set<Code> const& codes, std::vector<Artifact> const& artifacts,
                       ReportContext const& context, Language language) {
  return SarifHead(codes, artifacts, context, language).write();
}

std::string sarif_element(Finding const& finding, SourceSet const& sources, ReportContext const& context,
                          Language language) {
  return SarifResult(sources, context, language).write(finding);
}

std::string sarif_tail(bool has_elements, std::string_view shard) {
  std::string text = has_elements ? "\n      ]" : "]";
  if (!shard.empty()) text += ",\n      \"properties\": {\"axiscShard\": " + std::string(shard) + "}";
  return text + "\n    }\n  ]\n}\n";
}

std::size_t rule_index(std::set<Code> const& codes, Code code, ReportContext const& context) {
  std::size_t index = 0;
  for (RuleFacts const& rule : context.rules) {
    if (rule.code == code) break;
    if (codes.contains(rule.code)) ++index;
  }
  return index;
}

std::string write_sarif(std::vector<Finding> const& findings, SourceSet const& sources,
                        ReportContext const& context, WriteOptions const& options) {
  std::set<Code> codes;
  for (Finding const& finding : findings) codes.insert(finding.code);
  std::string text =
      sarif_head(codes, artifacts_of(findings, sources, context.paths), context, options.language);
  for (Finding const& finding : findings) {
    if (&finding != &findings.front()) text += ',';
    text += fill_holes(
        sarif_element(finding, sources, context, options.language),
        {.occurrence = finding.occurrence, .rule_index = rule_index(codes, finding.code, context)});
  }
  return text + sarif_tail(!findings.empty());
}

}  // namespace axisc
