#include "diagnostics/location.hpp"
#include "diagnostics/writers/json_layout.hpp"
#include "diagnostics/writers/report_writer.hpp"
#include "diagnostics/writers/sarif_artifact.hpp"
#include "diagnostics/writers/sarif_result.hpp"

#include <algorithm>
#include <deque>
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

/// A finding about the run as a whole.
struct Notice {
  Code code{};
  Severity severity = Severity::note;
  std::string sentence;
};

/// A source that findings point into.
struct Artifact {
  std::string name;
  Encoding encoding = Encoding::utf8;
};

class SarifReport final : public ReportWriter {
 public:
  SarifReport(Language language, ReportContext context) : language_(language), context_(std::move(context)) {}

  void add(std::string& /*out*/, Finding const& finding, SourceSet const& sources,
           std::string_view fingerprint) override {
    codes_.insert(finding.code);
    keep_sources(finding);
    write_sarif_result(written_, finding, sources, fingerprint, context_, language_);
    results_.push_back(written_);
  }

  void add_notice(std::string& /*out*/, Finding const& finding, SourceSet const& /*sources*/,
                  std::string_view /*fingerprint*/) override {
    codes_.insert(finding.code);
    keep_sources(finding);
    notices_.push_back(
        {.code = finding.code, .severity = finding.severity, .sentence = whole_message(finding, language_)});
  }

  void add_failure(std::string const& sentence) override { failures_.push_back(sentence); }

  /// Inputs may share a list, and name it by different paths.
  void end_input(SourceSet const& sources) override {
    for (SourceId const id : std::exchange(used_, {})) {
      SourceText const& source = sources[id];
      if (!shown_.insert(shown_path(context_.paths, source.name())).second) continue;
      artifacts_.push_back({.name = source.name(), .encoding = source.encoding()});
    }
  }

  void end(Print const& print, RunFacts const& /*run*/) override {
    print(head());
    bool const is_empty = results_.empty();
    for (std::string_view separator = "\n        "; !results_.empty(); results_.pop_front()) {
      SarifResult const& result = results_.front();
      std::string_view const text = result.text;
      print(std::exchange(separator, ",\n        "));
      print(text.substr(0, result.rule_index_at));
      print(std::to_string(rule_index(result.code)));
      print(text.substr(result.rule_index_at));
    }
    print(is_empty ? "]" : "\n      ]");
    print("\n    }\n  ]\n}\n");
  }

 private:
  void keep_sources(Finding const& finding) {
    if (finding.place) used_.insert(finding.place->source);
    for (Related const& related : finding.related) used_.insert(related.place.source);
  }

  /// Among the rules that the head names.
  [[nodiscard]] std::size_t rule_index(Code code) const {
    std::size_t index = 0;
    for (RuleFacts const& rule : context_.rules) {
      if (rule.code == code) break;
      if (codes_.contains(rule.code)) ++index;
    }
    return index;
  }

  [[nodiscard]] std::string head() const {
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
    for (std::string const& failure : failures_) {
      notifications.push_back({{"level", "error"}, {"message", {{"text", failure}}}});
    }
    for (Notice const& notice : notices_) {
      notifications.push_back({{"level", severity_name(notice.severity)},
                               {"message", {{"text", notice.sentence}}},
                               {"associatedRule", {{"id", code_text(notice.code)}}}});
    }
    Json invocation = {{"executionSuccessful", failures_.empty()}};
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

  Language language_;
  ReportContext context_;
  SarifResult written_;  ///< the last one
  std::deque<SarifResult> results_;
  std::set<Code> codes_;     ///< of all findings
  std::set<SourceId> used_;  ///< by findings of the current input
  std::set<std::string> shown_;
  std::vector<Artifact> artifacts_;
  std::vector<Notice> notices_;
  std::vector<std::string> failures_;
};

}  // namespace

std::unique_ptr<ReportWriter> sarif_report(WriteOptions const& options, ReportContext context) {
  return std::make_unique<SarifReport>(options.language, std::move(context));
}

}  // namespace axisc
