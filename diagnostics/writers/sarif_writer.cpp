#include "diagnostics/location.hpp"
#include "diagnostics/writers/json_layout.hpp"
#include "diagnostics/writers/report_elements.hpp"
#include "diagnostics/writers/sarif_artifact.hpp"
#include "diagnostics/writers/writers.hpp"

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

std::string_view first_paragraph(std::string_view text) {
  return text.substr(0, std::min(text.find('\n'), text.size()));
}

std::string_view first_sentence(std::string_view paragraph) {
  std::size_t const end = std::min(paragraph.find(". "), paragraph.size() - 1) + 1;
  std::string_view const sentence = paragraph.substr(0, end);
  return sentence.ends_with(':') ? sentence.substr(0, end - 1) : sentence;
}

Json artifact_location(RepositoryPaths const& paths, std::string_view file) {
  ArtifactName const name = artifact_name(paths, file);
  Json location = {{"uri", name.uri}};
  if (name.in_repository) location["uriBaseId"] = artifact_root;
  return location;
}

/// The text before the results.
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
                  {{artifact_root, {{"description", {{"text", "The root of the repository."}}}}}});
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
    std::string_view const text = rule.page.in(language_);
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
    for (RunNotice const& notice : context_.notices) {
      notifications.push_back({{"level", severity_name(notice.severity)},
                               {"message", {{"text", notice.sentence}}},
                               {"associatedRule", {{"id", code_text(notice.code)}}}});
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

/// The artifacts of all findings; a source that several inputs share is listed once.
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
  std::string element;
  for (Finding const& finding : findings) {
    if (&finding != &findings.front()) text += ',';
    element.clear();
    append_sarif_element(element, finding, sources, context, options.language);
    text += fill_holes(element, {.fingerprint = fingerprint(finding, sources),
                                 .rule_index = rule_index(codes, finding.code, context)});
  }
  return text + sarif_tail(!findings.empty());
}

}  // namespace axisc
