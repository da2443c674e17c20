#include "cli/settings.hpp"

#include "cli/codes.hpp"
#include "cli/disk_files.hpp"
#include "cli/failure.hpp"
#include "cli/finding_codes.hpp"
#include "cli/glob.hpp"
#include "cli/located_file.hpp"
#include "cli/machine_outline.hpp"
#include "cli/schema_file.hpp"
#include "cli/surroundings.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <memory>

namespace axisc::cli {

namespace {

namespace fs = std::filesystem;
using validator::JsonKind;
using validator::JsonValue;

constexpr std::string_view file_name = "axisc.json";

/// Reads one settings file; every complaint carries its place.
class Reader {
 public:
  explicit Reader(LocatedFile const& file) : file_(file) {}

  Settings read(std::string folder) {
    settings_.file = file_.path();
    settings_.folder = std::move(folder);
    if (file_.root().kind != JsonKind::object) file_.refuse(file_.root().span, Text::settings_object);
    for (auto const& member : file_.root().members) read_member(member);
    return std::move(settings_);
  }

 private:
  void read_member(validator::JsonMember const& member) {
    auto const& value = file_[member.value];
    if (member.key == "cycle_time_us") {
      settings_.cycle_time = cycle_time(value);
    } else if (member.key == "build") {
      settings_.build = validator::parse_build_version(file_.text(value));
      if (!settings_.build) file_.refuse(value.span, Text::settings_build, {{"value", value.string}});
    } else if (member.key == "language") {
      settings_.language = parse_language(file_.text(value));
      if (!settings_.language) file_.refuse(value.span, Text::settings_language);
    } else if (member.key == "disable") {
      settings_.disabled = codes(value);
    } else if (member.key == "severity") {
      read_severities(value);
    } else if (member.key == "schema") {
      read_schema_files(value);
    } else if (member.key == "paths") {
      read_paths(value);
    } else {
      file_.refuse(member.key_span, Text::settings_unknown_key,
                   {{"key", member.key},
                    {"keys", "cycle_time_us, build, language, disable, severity, schema, paths"}});
    }
  }

  design::CycleTime cycle_time(JsonValue const& value) const {
    double const nanoseconds = value.number * 1000;
    bool const good = value.kind == JsonKind::number && nanoseconds >= 1 && nanoseconds <= 1e9 &&
                      nanoseconds == std::floor(nanoseconds);
    if (!good) file_.refuse(value.span, Text::settings_cycle_time);
    return {static_cast<std::uint32_t>(nanoseconds)};
  }

  Code code(std::string const& word, Span span) const {
    auto const found = find_code(word);
    if (!found) file_.refuse(span, Text::settings_code, {{"code", word}});
    return *found;
  }

  std::vector<Code> codes(JsonValue const& value) const {
    if (value.kind != JsonKind::array) file_.refuse(value.span, Text::settings_list);
    std::vector<Code> codes;
    for (auto const item : value.items) codes.push_back(code(file_.text(file_[item]), file_[item].span));
    return codes;
  }

  void read_severities(JsonValue const& value) {
    if (value.kind != JsonKind::object) file_.refuse(value.span, Text::settings_object);
    for (auto const& member : value.members) {
      auto const& wanted = file_[member.value];
      auto const& word = file_.text(wanted);
      Code const which = code(member.key, member.key_span);
      if (word == "error") {
        settings_.severities[which] = Severity::error;
      } else if (word == "warning") {
        settings_.severities[which] = Severity::warning;
      } else if (word == "note") {
        settings_.severities[which] = Severity::note;
      } else {
        file_.refuse(wanted.span, Text::settings_severity);
      }
    }
  }

  void read_paths(JsonValue const& value) {
    if (value.kind != JsonKind::array) file_.refuse(value.span, Text::settings_list);
    for (auto const item : value.items) {
      auto const& entry = file_[item];
      if (entry.kind != JsonKind::object) file_.refuse(entry.span, Text::settings_object);
      PathSettings path;
      for (auto const& member : entry.members) {
        if (member.key == "pattern") {
          path.pattern = file_.text(file_[member.value]);
        } else if (member.key == "disable") {
          path.disabled = codes(file_[member.value]);
        } else {
          file_.refuse(member.key_span, Text::settings_unknown_key,
                       {{"key", member.key}, {"keys", "pattern, disable"}});
        }
      }
      if (path.pattern.empty()) file_.refuse(entry.span, Text::settings_pattern);
      settings_.paths.push_back(std::move(path));
    }
  }

  /// Paths begin at the settings, wherever the program runs.
  void read_schema_files(JsonValue const& value) {
    if (value.kind != JsonKind::array) file_.refuse(value.span, Text::settings_list);
    for (auto const item : value.items) {
      auto const& name = file_.text(file_[item]);
      auto const path = (fs::path(file_.path()).parent_path() / name).lexically_normal().string();
      std::error_code error;
      if (!fs::is_regular_file(path, error)) {
        file_.refuse(file_[item].span, Text::settings_schema_missing, {{"file", name}});
      }
      settings_.schema_files.push_back(path);
      settings_.catalogue = with_schema_file(settings_.catalogue, path);
    }
  }

  LocatedFile const& file_;
  Settings settings_;
};

/// Below `folder`, with slashes; the whole path where it lies elsewhere.
std::string relative_to(std::string const& folder, std::string const& path) {
  std::error_code error;
  auto const absolute = fs::weakly_canonical(fs::absolute(path, error), error);
  auto const relative = absolute.lexically_relative(folder);
  return relative.empty() ? absolute.generic_string() : relative.generic_string();
}

bool covers(std::string const& folder, std::string const& pattern, std::string const& path) {
  return matches_glob(pattern, relative_to(folder, path));
}

Digest digest_of_files(std::vector<std::string> const& paths) {
  Hasher hasher;
  DiskFiles files;
  for (auto const& path : paths) {
    auto const bytes = files.read(path);
    auto const* const text = std::get_if<std::string>(&bytes);
    hasher.text(path);
    hasher.text(text == nullptr ? std::string_view{} : *text);
  }
  return hasher.finish();
}

void require_unchanged(std::vector<std::string> const& paths, Digest const& before) {
  if (digest_of_files(paths) != before) throw validator::SourceChanged(paths.front());
}

/// Behind all links; as far as it exists where it does not.
fs::path canonical_folder(std::string const& folder) {
  std::unique_ptr<char, decltype(&std::free)> const found(::realpath(folder.c_str(), nullptr), std::free);
  if (found) return found.get();
  std::error_code error;
  return fs::weakly_canonical(fs::absolute(folder, error), error);
}

}  // namespace

Settings read_settings(std::string const& path, std::string const& folder) {
  LocatedFile const file(path, Text::settings_json);
  return Reader(file).read(folder);
}

schema::Catalogue SettingsFinder::catalogue(std::string const& input) {
  if (auto const* const settings = find(input)) return settings->catalogue;
  std::lock_guard const lock(mutex_);
  read_schema_files();
  return *without_settings_;
}

Digest SettingsFinder::digest(std::string const& input) {
  if (auto const* const settings = find(input)) return settings->digest;
  std::lock_guard const lock(mutex_);
  read_schema_files();
  return schema_digest_;
}

void SettingsFinder::read_schema_files() {
  if (without_settings_) return;
  schema_digest_ = digest_of_files(schema_files_);
  without_settings_ = with_schema_files({}, schema_files_);
  require_unchanged(schema_files_, schema_digest_);
}

Settings const* SettingsFinder::find(std::string const& input) {
  auto const slash = input.rfind('/');
  std::string asked = slash == std::string::npos ? "." : input.substr(0, std::max(slash, std::size_t{1}));
  std::lock_guard const lock(mutex_);
  if (auto const known = asked_.find(asked); known != asked_.end()) return known->second;
  auto const* const settings = look_for(asked);
  asked_.emplace(std::move(asked), settings);
  return settings;
}

Settings const* SettingsFinder::look_for(std::string const& asked) {
  std::error_code error;
  auto const folder = canonical_folder(asked);
  auto known = known_.find(folder.string());
  if (known == known_.end()) {
    std::optional<Settings> found;
    for (auto candidate = folder; !found; candidate = candidate.parent_path()) {
      auto const file = candidate / file_name;
      if (fs::is_regular_file(file, error)) {
        auto const shown = fs::proximate(file, fs::current_path(error), error);
        found = read_digested(shown.empty() ? file.string() : shown.string(), candidate.string());
      }
      if (candidate == candidate.parent_path()) break;
    }
    known = known_.emplace(folder.string(), std::move(found)).first;
  }
  return known->second ? &*known->second : nullptr;
}

Settings SettingsFinder::read_digested(std::string const& file, std::string const& folder) const {
  auto const own = digest_of_files({file});
  auto settings = read_settings(file, folder);
  settings.catalogue = with_schema_files(settings.catalogue, schema_files_);
  auto files = settings.schema_files;
  files.insert(files.end(), schema_files_.begin(), schema_files_.end());
  Hasher hasher;
  hasher.digest(own);
  hasher.digest(digest_of_files(files));
  if (!settings.paths.empty()) {
    // Patterns are compared with names below the folder, which depend on where the program runs.
    std::error_code error;
    hasher.text(folder);
    hasher.text(fs::current_path(error).string());
  }
  settings.digest = hasher.finish();
  require_unchanged({file}, own);
  return settings;
}

validator::CheckOptions with_settings(validator::CheckOptions options, Settings const& settings,
                                      std::string const& input) {
  // A machine file says its own cycle time, and only the command line knows better.
  if (!options.cycle_time && !has_extension(input, ".json")) options.cycle_time = settings.cycle_time;
  if (!options.build) options.build = settings.build;
  options.catalogue = settings.catalogue;
  options.disabled.insert(options.disabled.end(), settings.disabled.begin(), settings.disabled.end());
  options.severities = settings.severities;
  for (auto const& rule : settings.paths) {
    options.paths.push_back({.covers = [folder = settings.folder, pattern = rule.pattern](
                                           auto const& file) { return covers(folder, pattern, file); },
                             .disabled = rule.disabled});
  }
  return options;
}

}  // namespace axisc::cli
