#include "cli/fleet/shard_element.hpp"

#include "cli/options/finding_codes.hpp"

#include <algorithm>
#include <set>

#include <nlohmann/json.hpp>

namespace axisc::cli {

namespace {

using Json = nlohmann::ordered_json;

Severity severity_of(std::string const& word) {
  if (word == "error") return Severity::error;
  return word == "warning" ? Severity::warning : Severity::note;
}

std::string text_or_nothing(Json const& object, char const* key) {
  auto const member = object.find(key);
  return member != object.end() && member->is_string() ? member->get<std::string>() : std::string();
}

/// Places that a result names, as paths.
void add_paths(std::set<std::string>& paths, Json const& result, char const* key) {
  if (!result.contains(key)) return;
  for (auto const& location : result.at(key)) {
    if (!location.contains("physicalLocation")) continue;
    auto const& physical = location.at("physicalLocation");
    // A finding without a region names a file that is not an artifact of its input.
    if (!physical.contains("region")) continue;
    paths.insert(path_of_uri(physical.at("artifactLocation").at("uri").get<std::string>()));
  }
}

std::string first_uri(Json const& result) {
  if (!result.contains("locations")) return {};
  auto const& location = result.at("locations").at(0);
  if (!location.contains("physicalLocation")) return {};
  return location.at("physicalLocation").at("artifactLocation").at("uri").get<std::string>();
}

std::string with_rule_hole(std::string text) {
  constexpr std::string_view index = "\"ruleIndex\": ";
  auto const begin = text.find(index) + index.size();
  auto const end = text.find_first_not_of("0123456789", begin);
  return text.replace(begin, end - begin, 1, rule_index_hole);
}

std::string with_fingerprint_hole(std::string text, std::string const& fingerprint) {
  auto const quoted = '"' + fingerprint + '"';
  for (auto at = text.find(quoted); at != std::string::npos; at = text.find(quoted)) {
    text.replace(at + 1, fingerprint.size(), 1, fingerprint_hole);
  }
  return text;
}

std::optional<WrittenFinding> read_identified(Json const& json, char const* code_key, Json const& facts) {
  auto const code = find_code(json.at(code_key).get<std::string>());
  if (!code) return std::nullopt;
  WrittenFinding finding;
  finding.identity.code = *code;
  finding.identity.axis = text_or_nothing(facts, "axis");
  finding.identity.parameter = text_or_nothing(facts, "parameter");
  return finding;
}

std::optional<WrittenFinding> json_finding(std::string_view element) {
  auto const json = Json::parse(element);
  auto finding = read_identified(json, "code", json);
  if (!finding) return std::nullopt;
  finding->identity.file = text_or_nothing(json, "file");
  finding->severity = severity_of(json.at("severity").get<std::string>());
  finding->fixable = !json.at("fix").is_null();
  finding->text = "\n    " + std::string(element);
  return finding;
}

std::optional<WrittenFinding> sarif_finding(std::string_view element,
                                            std::vector<Artifact> const& artifacts) {
  auto const json = Json::parse(element);
  auto finding = read_identified(json, "ruleId", json.value("properties", Json::object()));
  if (!finding || !json.contains("ruleIndex")) return std::nullopt;
  finding->identity.file = path_of_uri(first_uri(json));
  auto const fingerprint = json.at("partialFingerprints").at("axiscIdentity/v2").get<std::string>();
  finding->severity = severity_of(json.at("level").get<std::string>());
  finding->fixable = json.contains("fixes");
  std::set<std::string> paths;
  add_paths(paths, json, "locations");
  add_paths(paths, json, "relatedLocations");
  for (std::uint32_t i = 0; i < artifacts.size(); ++i) {
    if (paths.contains(artifacts[i].name)) finding->artifacts.push_back(i);
  }
  finding->text = "\n        " + with_fingerprint_hole(with_rule_hole(std::string(element)), fingerprint);
  return finding;
}

int digit(char character) {
  constexpr std::string_view digits = "0123456789ABCDEF";
  auto const found = digits.find(character);
  return found == std::string_view::npos ? -1 : static_cast<int>(found);
}

}  // namespace

std::string path_of_uri(std::string_view uri) {
  constexpr std::string_view scheme = "file://";
  if (uri.starts_with(scheme)) uri.remove_prefix(scheme.size());
  std::string path;
  for (std::size_t i = 0; i < uri.size(); ++i) {
    bool const is_escape =
        uri[i] == '%' && i + 2 < uri.size() && digit(uri[i + 1]) >= 0 && digit(uri[i + 2]) >= 0;
    path += is_escape ? static_cast<char>(digit(uri[i + 1]) * 16 + digit(uri[i + 2])) : uri[i];
    if (is_escape) i += 2;
  }
  return path;
}

std::optional<WrittenFinding> read_json_element(std::string_view element) {
  try {
    return json_finding(element);
  } catch (Json::exception const&) {
    return std::nullopt;
  }
}

std::optional<WrittenFinding> read_sarif_element(std::string_view element,
                                                 std::vector<Artifact> const& artifacts) {
  try {
    return sarif_finding(element, artifacts);
  } catch (Json::exception const&) {
    return std::nullopt;
  }
}

}  // namespace axisc::cli
