#include "cli/fleet/shard_document.hpp"

#include "cli/codes.hpp"
#include "cli/files/disk_files.hpp"
#include "cli/fleet/shard_element.hpp"
#include "cli/report/json_slices.hpp"

#include <utility>
#include <variant>

#include <nlohmann/json.hpp>

namespace axisc::cli::says {

constexpr Sentence merge_no_json{
    "{file} is damaged: it is not a complete JSON document; run its shard again",
    "{file} ist beschädigt: es ist kein vollständiges JSON-Dokument; den Teil noch einmal laufen lassen"};
constexpr Sentence merge_no_shard{
    "{file} was not written by `axisc lint --shard I/N --format json` (or sarif)",
    "{file} wurde nicht von `axisc lint --shard I/N --format json` (oder sarif) geschrieben"};

}  // namespace axisc::cli::says

namespace axisc::cli {

namespace {

std::string plain(std::string_view json_string) {
  auto const value = nlohmann::json::parse(json_string);
  return value.is_string() ? value.get<std::string>() : std::string();
}

}  // namespace

ShardDocument::ShardDocument(std::string const& file) : file_(file), bytes_(read_whole(file)) {
  if (!nlohmann::json::accept(bytes_)) refuse(says::merge_no_json);
  if (auto const runs = json_member(bytes_, "runs")) {
    read_sarif(*runs);
  } else {
    read_json();
  }
  std::size_t findings = 0;
  for (auto const& input : record_.inputs) {
    findings += input.findings;
    for (auto const artifact : input.artifacts) {
      if (artifact >= artifacts_.size()) refuse(says::merge_no_shard);
    }
  }
  if (findings != elements_.size()) refuse(says::merge_no_shard);
}

void ShardDocument::refuse(SentenceRef reason) const {
  throw Failure({.sentence = reason, .arguments = {{"file", file_}}}, cannot_read);
}

void ShardDocument::read_record(std::string_view json) {
  auto record = read_shard_record(json);
  if (!record) refuse(says::merge_no_shard);
  record_ = *std::move(record);
}

void ShardDocument::read_json() {
  auto const record = json_member(bytes_, "shard");
  auto const elements = json_items(json_member(bytes_, "diagnostics").value_or(""));
  if (!record || !elements) refuse(says::merge_no_shard);
  read_record(*record);
  elements_ = *elements;
  has_statistics_ = json_member(bytes_, "statistics").has_value();
}

void ShardDocument::read_sarif(std::string_view runs) {
  format_ = FindingFormat::sarif;
  auto const all = json_items(runs);
  if (!all || all->size() != 1) refuse(says::merge_no_shard);
  auto const run = all->front();
  auto const record = json_member(json_member(run, "properties").value_or(""), "axiscShard");
  auto const elements = json_items(json_member(run, "results").value_or(""));
  auto const artifacts = json_items(json_member(run, "artifacts").value_or(""));
  auto const language = json_member(run, "language");
  if (!record || !elements || !artifacts || !language) refuse(says::merge_no_shard);
  read_record(*record);
  elements_ = *elements;
  language_ = plain(*language) == "de" ? Language::german : Language::english;
  for (auto const artifact : *artifacts) {
    auto const uri = json_member(json_member(artifact, "location").value_or(""), "uri");
    auto const encoding = json_member(artifact, "encoding");
    if (!uri || !encoding) refuse(says::merge_no_shard);
    artifacts_.push_back({.name = path_of_uri(plain(*uri)),
                          .encoding = plain(*encoding) == "UTF-8" ? Encoding::utf8 : Encoding::windows_1252});
  }
}

CheckedInput ShardDocument::next_input(std::size_t index) {
  auto const& input = record_.inputs[index];
  CheckedInput checked;
  for (auto const artifact : input.artifacts) checked.artifacts.push_back(artifacts_[artifact]);
  for (std::size_t i = 0; i < input.findings; ++i) {
    auto const element = elements_[next_element_++];
    auto finding = format_ == FindingFormat::json ? read_json_element(element)
                                                  : read_sarif_element(element, checked.artifacts);
    if (!finding) refuse(says::merge_no_shard);
    auto const& paths = record_.identity_paths;
    if (auto const path = paths.find(finding->identity.file); path != paths.end()) {
      finding->identity.file = path->second;
    }
    checked.findings.push_back(*std::move(finding));
  }
  return checked;
}

}  // namespace axisc::cli
