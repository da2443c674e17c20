#include "axisc/checking/baseline.hpp"

#include "axisc/environment/codes.hpp"
#include "axisc/environment/failure.hpp"
#include "axisc/files/disk_files.hpp"
#include "diagnostics/writers/json_stream.hpp"

#include <charconv>
#include <limits>
#include <optional>

#include <nlohmann/json.hpp>

namespace axisc::says {

constexpr Sentence no_json{"{file} is not a baseline: it is not the JSON that --write-baseline writes",
                           "{file} ist keine Baseline: es ist nicht das JSON, das --write-baseline schreibt"};
constexpr Sentence version{
    "{file} is not a baseline that this version can use: \"version\" must be 2; --write-baseline writes a "
    "new one",
    "{file} ist keine Baseline, die diese Version verwenden kann: \"version\" muss 2 sein; --write-baseline "
    "schreibt eine neue"};
constexpr Sentence without_files{
    "{file} is a baseline of version 1, which does not say in which file a finding is; write it anew with "
    "--write-baseline",
    "{file} ist eine Baseline der Version 1, die nicht angibt, in welcher Datei ein Befund steht; mit "
    "--write-baseline neu schreiben"};
constexpr Sentence no_findings{
    "{file} is not a baseline: \"findings\" is missing or not a list; --write-baseline writes a new one",
    "{file} ist keine Baseline: \"findings\" fehlt oder ist keine Liste; --write-baseline schreibt eine "
    "neue"};
constexpr Sentence bad_entry{
    "{file} cannot be used: entry {number} of \"findings\" needs file, code, axis, parameter and occurrence "
    "(from 1)",
    "{file} ist nicht verwendbar: Eintrag {number} von \"findings\" braucht file, code, axis, parameter und "
    "occurrence (ab 1)"};

}  // namespace axisc::says

namespace axisc {

namespace {

using json_type = nlohmann::json;

constexpr int format_version = 2;

std::optional<Code> code_of(std::string const& text) {
  std::uint16_t number = 0;
  if (text.size() != 6 || text.substr(0, 2) != "AX") return std::nullopt;
  auto const [end, error] = std::from_chars(text.data() + 2, text.data() + text.size(), number);
  if (error != std::errc{} || end != text.data() + text.size()) return std::nullopt;
  return static_cast<Code>(number);
}

std::optional<std::string> text_member(json_type const& object, char const* key) {
  auto const found = object.find(key);
  if (found == object.end() || !found->is_string()) return std::nullopt;
  return found->get<std::string>();
}

std::optional<BaselineEntry> entry_of(json_type const& object) {
  if (!object.is_object()) return std::nullopt;
  auto const code = text_member(object, "code");
  auto const number = code ? code_of(*code) : std::nullopt;
  auto const file = text_member(object, "file");
  auto const axis = text_member(object, "axis");
  auto const parameter = text_member(object, "parameter");
  auto const occurrence = object.find("occurrence");
  if (!number || !file || !axis || !parameter || occurrence == object.end() ||
      !occurrence->is_number_unsigned()) {
    return std::nullopt;
  }
  auto const which = occurrence->get<std::uint64_t>();
  if (which == 0 || which > std::numeric_limits<std::uint32_t>::max()) return std::nullopt;
  return BaselineEntry{.identity = {.file = *file, .axis = *axis, .parameter = *parameter, .code = *number},
                       .occurrence = static_cast<std::uint32_t>(which)};
}

[[noreturn]] void refuse(std::string const& path, SentenceRef reason, std::vector<Argument> arguments = {}) {
  arguments.push_back({.name = "file", .value = path});
  throw Failure({reason, std::move(arguments)}, cannot_read);
}

}  // namespace

void Baseline::add(Identity const& identity, std::uint32_t occurrence) {
  if (identity.code < cannot_read) entries_.insert({identity, occurrence});
}

void Baseline::remove(Identity const& identity, std::uint32_t occurrence) {
  entries_.erase({identity, occurrence});
}

Baseline Baseline::read(std::string const& path) {
  auto const document = json_type::parse(read_whole(path, Dash::is_a_name), nullptr, false);
  if (document.is_discarded() || !document.is_object()) refuse(path, says::no_json);
  auto const version = document.find("version");
  auto const findings = document.find("findings");
  if (version != document.end() && *version == 1) refuse(path, says::without_files);
  if (version == document.end() || *version != format_version) refuse(path, says::version);
  if (findings == document.end() || !findings->is_array()) refuse(path, says::no_findings);
  Baseline baseline;
  for (std::size_t i = 0; i < findings->size(); ++i) {
    auto const entry = entry_of((*findings)[i]);
    if (!entry) refuse(path, says::bad_entry, {{"number", std::to_string(i + 1)}});
    baseline.entries_.insert(*entry);
  }
  return baseline;
}

std::string Baseline::text() const {
  std::string text = "{\"version\": " + std::to_string(format_version) + ", \"findings\": [";
  bool first = true;
  for (auto const& [identity, occurrence] : entries_) {
    text += first ? "\n" : ",\n";
    first = false;
    text += "  {\"file\": " + json_string(identity.file) +
            ", \"code\": " + json_string(code_text(identity.code)) +
            ", \"axis\": " + json_string(identity.axis) +
            ", \"parameter\": " + json_string(identity.parameter) +
            ", \"occurrence\": " + std::to_string(occurrence) +
            ", \"fingerprint\": " + json_string(fingerprint(identity, occurrence)) + "}";
  }
  return text + (entries_.empty() ? "]}\n" : "\n]}\n");
}

bool Baseline::holds(Identity const& identity, std::uint32_t occurrence) const {
  return entries_.contains({identity, occurrence});
}

bool Baseline::mentions(Identity const& identity) const {
  auto const found = entries_.lower_bound({identity, 0});
  return found != entries_.end() && found->identity == identity;
}

std::vector<Identity> Baseline::identities() const {
  std::vector<Identity> identities;
  identities.reserve(entries_.size());
  for (auto const& entry : entries_) identities.push_back(entry.identity);
  return identities;
}

}  // namespace axisc
