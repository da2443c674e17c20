#include "diagnostics/fingerprint.hpp"
#include "diagnostics/json_layout.hpp"
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

Json artifact_location(RepositoryPaths const& paths, std::string_view file) {
  if (auto const path = path_in_repository(paths, file)) {
    return {{"uri", as_uri(*path)}, {"uriBaseId", root_name}};
  }
  bool const is_absolute = file.substr(0, 1) == "/";
  return {{"uri", (is_absolute ? "file://" : "") + as_uri(file)}};
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

  [[nodiscard]] std::string write(Finding const& finding) const {
    std::string const zeroth = fingerprint(identity_of(finding, sources_), 0);
    std::string text = "\n        ";
    append_indented(text, result(finding, zeroth), "        ");
    // The second member: nothing in front of it can look like it.
    constexpr std::string_view index = "\"ruleIndex\": 0";
    text[text.find(index) + index.size() - 1] = rule_index_hole;
    return with_occurrence_hole(text, zeroth);
  }

 private:
  [[nodiscard]] std::string say(Message const& message) const { return render(message, language_); }

  [[nodiscard]] Json artifact_location(std::string_view file) const {
    return axisc::artifact_location(context_.paths, file);
  }

  [[nodiscard]] static Json region(Location const& location) {
    return {{"startLine", location.begin.line},
            {"startColumn", location.begin.column},
            {"endLine", location.end.line},
            {"endColumn", location.end.column}};
  }

  [[nodiscard]] Json physical_location(Place const& place) const {
    Location const location = locate(place, sources_);
    return {{"artifactLocation", artifact_location(location.file)}, {"region", region(location)}};
  }

  [[nodiscard]] Json location(Finding const& finding) const {
    Json location = Json::object();
    if (finding.place) {
      location["physicalLocation"] = physical_location(*finding.place);
    } else if (!finding.file.empty()) {
      location["physicalLocation"] = {{"artifactLocation", artifact_location(finding.file)}};
    }
    if (!finding.parameter.empty()) {
      std::string const axis = finding.axis.empty() ? "" : finding.axis + "/";
      location["logicalLocations"] = Json::array({{{"name", finding.parameter},
                                                   {"fullyQualifiedName", axis + finding.parameter},
                                                   {"kind", "parameter"}}});
    }
    return location;
  }

  [[nodiscard]] Json related(Finding const& finding) const {
    Json locations = Json::array();
    for (Related const& place : finding.related) {
      locations.push_back({{"id", locations.size() + 1},
                           {"physicalLocation", physical_location(place.place)},
                           {"message", {{"text", say(place.message)}}}});
    }
    return locations;
  }

  [[nodiscard]] Json fix(Fix const& fix) const {
    Json changes = Json::array();
    std::vector<SourceId> changed;
    for (Edit const& edit : fix.edits) {
      auto const found = std::find(changed.begin(), changed.end(), edit.place.source);
      auto const index = static_cast<std::size_t>(found - changed.begin());
      if (found == changed.end()) {
        changed.push_back(edit.place.source);
        changes.push_back({{"artifactLocation", artifact_location(sources_[edit.place.source].name())},
                           {"replacements", Json::array()}});
      }
      changes[index]["replacements"].push_back({{"deletedRegion", region(locate(edit.place, sources_))},
                                                {"insertedContent", {{"text", edit.text}}}});
    }
    return {{"description", {{"text", say(fix.title)}}},
            {"artifactChanges", std::move(changes)},
            {"properties", {{"safe", fix.safety == FixSafety::safe}}}};
  }

  [[nodiscard]] Json properties(Finding const& finding) const {
    Json properties = Json::object();
    auto const add = [&properties](std::string_view name, std::string_view value) {
      if (!value.empty()) properties[std::string(name)] = value;
    };
    add("axis", finding.axis);
    add("parameter", finding.parameter);
    add("pAxis", finding.p_axis);
    if (finding.control) {
      add("controlMessage", finding.control->message);
      if (finding.control->reaction) add("controlReaction", say(*finding.control->reaction));
      add("controlValue", finding.control->value);
    }
    return properties;
  }

  [[nodiscard]] Json result(Finding const& finding, std::string const& identity) const {
    Json result = {{"ruleId", code_text(finding.code)},
                   {"ruleIndex", 0},
                   {"level", severity_name(finding.severity)},
                   {"message", {{"text", whole_message(finding, language_)}}}};
    if (Json place = location(finding); !place.empty()) result["locations"] = Json::array({std::move(place)});
    if (!finding.related.empty()) result["relatedLocations"] = related(finding);
    // Code hosts compare the second name only; without it they would hash the line.
    result["partialFingerprints"] = {{"axiscIdentity/v1", identity}, {"primaryLocationLineHash", identity}};
    if (finding.fix) result["fixes"] = Json::array({fix(*finding.fix)});
    if (Json bag = properties(finding); !bag.empty()) result["properties"] = std::move(bag);
    return result;
  }

  SourceSet const& sources_;
  ReportContext const& context_;
  Language language_;
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
