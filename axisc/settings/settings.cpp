#include "axisc/settings/settings.hpp"

#include "axisc/asked/finding_codes.hpp"
#include "axisc/environment/codes.hpp"
#include "axisc/environment/failure.hpp"
#include "axisc/files/disk_files.hpp"
#include "axisc/settings/glob.hpp"
#include "axisc/settings/located_file.hpp"
#include "axisc/settings/schema_file.hpp"
#include "axisc/settings/sentences.hpp"
#include "configuration/json_reading.hpp"
#include "configuration/machine/motion_words.hpp"
#include "diagnostics/ascii.hpp"
#include "system/file.hpp"
#include "system/path.hpp"

#include <algorithm>
#include <array>
#include <filesystem>
#include <memory>
#include <string_view>

namespace axisc::says {

constexpr Sentence settings_json{"the settings are not valid JSON here",
                                 "die Einstellungen sind hier kein gültiges JSON"};
constexpr Sentence code{"there is no code \"{value}\"; `axisc explain --all` lists them",
                        "es gibt keinen Code \"{value}\"; `axisc explain --all` nennt alle"};
constexpr Sentence schema_missing{
    "the schema file {file} cannot be read; paths are relative to the settings",
    "die Schemadatei {file} ist nicht lesbar; Pfade gelten relativ zu den Einstellungen"};

}  // namespace axisc::says

namespace axisc {

namespace {

namespace fs = std::filesystem;
using configuration::by;
using configuration::into;
using configuration::JsonDocument;
using configuration::JsonKey;
using configuration::JsonShape;
using configuration::JsonValue;
using Kind = configuration::JsonShapeKind;
using enum configuration::JsonPresence;

constexpr JsonShape build_shape{
    .accepts = [](std::string_view text) { return validator::parse_build_version(text).has_value(); },
    .pattern = R"(^[Vv]?[0-9]+\.[0-9]+\.[0-9]+(\.[0-9]+)?$)",
    .sentence = says::settings_build};
constexpr std::array<std::string_view, 2> languages = {"en", "de"};
constexpr JsonShape language_shape{.words = languages};
constexpr JsonShape code_shape{.accepts = [](std::string_view text) { return !find_codes(text).empty(); },
                               .pattern = R"(^([Aa][Xx]([0-9]{4}|[0-9]{0,4}\*)|[a-z][a-z0-9-]*\*?)$)",
                               .sentence = says::code};
constexpr JsonShape codes_shape{.kind = Kind::list, .items = &code_shape};
constexpr std::array<std::string_view, 3> severities = {"error", "warning", "note"};
constexpr JsonShape severity_shape{.words = severities};
constexpr JsonShape severities_shape{.kind = Kind::map, .items = &severity_shape, .names = &code_shape};

void store_build(JsonDocument const& /*document*/, JsonValue const& value, Settings& settings) {
  settings.build = validator::parse_build_version(value.string);
}

template <typename Target>
void store_codes(JsonDocument const& document, JsonValue const& value, Target& target) {
  for (auto const item : value.items) {
    auto const codes = find_codes(document[item].string);
    target.disabled.insert(target.disabled.end(), codes.begin(), codes.end());
  }
}

void store_severities(JsonDocument const& document, JsonValue const& value, Settings& settings) {
  // A single code wins over the beginning of many.
  for (bool const is_beginning : {true, false}) {
    for (auto const& member : value.members) {
      if (std::string_view(member.key).ends_with('*') != is_beginning) continue;
      auto const* const word = std::find(severities.begin(), severities.end(), document[member.value].string);
      for (auto const code : find_codes(member.key)) {
        settings.severities[code] = static_cast<Severity>(word - severities.begin());
      }
    }
  }
}

constexpr auto kind_words = [] {
  std::array<std::string_view, schema::list_kinds> words;
  for (std::size_t i = 0; i < words.size(); ++i) words.at(i) = schema::list_kind_rows.at(i).word;
  return words;
}();
constexpr JsonShape kind_shape{.words = kind_words};

constexpr JsonShape filter_reading_shape{.words = design::filter_reading_words};
constexpr JsonShape kernel_reading_shape{
    .words =
        std::span<std::string_view const>(design::kernel_reading_words).first(design::linear_phase_readings)};
constexpr JsonShape guard_reading_shape{.words = design::guard_reading_words};
constexpr JsonShape cycle_reading_shape{.words = design::cycle_reading_words};
constexpr std::array design_keys = {
    JsonKey{"filters", &filter_reading_shape, optional, "Of the standard filters filter[i].",
            into<&design::Readings::filters>},
    JsonKey{"kernels", &kernel_reading_shape, optional, "Of filter_fir and the HSC filters.",
            into<&design::Readings::kernels>},
    JsonKey{"vibration_guard", &guard_reading_shape, optional, "Of Vibration Guard.",
            into<&design::Readings::guard>},
    JsonKey{"cycle_time", &cycle_reading_shape, optional,
            "The cycle time that all are computed for, beside that of the NC.",
            into<&design::Readings::cycle_time>}};
constexpr JsonShape design_shape{
    .kind = Kind::object, .title = "What the control makes of its filters", .keys = design_keys};

constexpr JsonShape projection_shape{.words = machine::projection_words};
constexpr JsonShape border_shape{.words = machine::border_words};
constexpr JsonShape sine_shape{.words = machine::sine_words};
constexpr JsonShape circle_shape{.words = machine::circle_words};
constexpr JsonShape corner_shape{.words = machine::corner_words};
constexpr JsonShape transition_shape{.words = machine::transition_words};
constexpr JsonShape cycle_shape{.words = machine::cycle_words};
constexpr JsonShape hsc_shape{.words = machine::hsc_words};
constexpr std::array motion_keys = {
    JsonKey{"projection", &projection_shape, optional,
            "Ramps along a line between axes: the weakest jerk of all, or the longest ramp time.",
            into<&machine::MotionReadings::projection>},
    JsonKey{"borders", &border_shape, optional,
            "TRAPEZ and SIN2 between blocks: acceleration 0, or continuous.",
            into<&machine::MotionReadings::borders>},
    JsonKey{"sine", &sine_shape, optional,
            "SIN2: each ramp is a sin², the whole change is one, or ramps with the largest jerk of TRAPEZ.",
            into<&machine::MotionReadings::sine>},
    JsonKey{"circle", &circle_shape, optional,
            "Acceleration on circles: shared along and across the path, or all of it across.",
            into<&machine::MotionReadings::circle>},
    JsonKey{"corner", &corner_shape, optional,
            "Acceleration that a corner may take in a cycle: the lower one, up alone, or down alone.",
            into<&machine::MotionReadings::corner>},
    JsonKey{
        "weights", &transition_shape, optional,
        "Where P-CHAN-00117 is 0: the weight of curvature is at least that of acceleration, or the reverse.",
        into<&machine::MotionReadings::weights>},
    JsonKey{"cycles", &cycle_shape, optional, "Ramps of any length, or of whole cycles.",
            into<&machine::MotionReadings::cycles>},
    JsonKey{"hsc", &hsc_shape, optional, "HSC: TRAPEZ on stretches of blocks, or on each block.",
            into<&machine::MotionReadings::hsc>}};
constexpr JsonShape motion_shape{
    .kind = Kind::object, .title = "How the control plans a path", .keys = motion_keys};

constexpr std::array path_keys = {
    JsonKey{"pattern", &configuration::json_text, required,
            "Files it applies to, relative to the settings: old/**.", into<&PathSettings::pattern>},
    JsonKey{"disable", &codes_shape, optional, "Findings that are not reported in these files.",
            by<store_codes<PathSettings>>},
    JsonKey{"kind", &kind_shape, optional, "Kind of these lists, whatever they say themselves.",
            into<&PathSettings::kind>}};
constexpr JsonShape path_shape{.kind = Kind::object, .title = "Settings of some files", .keys = path_keys};
constexpr JsonShape paths_shape{.kind = Kind::list, .items = &path_shape};

constexpr std::array settings_keys = {
    JsonKey{"cycle_time_us", &configuration::json_cycle_time, optional,
            "Cycle time in microseconds for lists alone; a machine file says its own.",
            into<&Settings::cycle_time>},
    JsonKey{"build", &build_shape, optional, "Build of the control that the lists are for, V3.1.3080.00.",
            by<store_build>},
    JsonKey{"language", &language_shape, optional, "Language of messages.", into<&Settings::language>},
    JsonKey{
        "design", &design_shape, optional,
        "What the control makes of its filters where the manuals leave it open, as `axisc compare` finds it.",
        into<&Settings::readings>},
    JsonKey{"motion", &motion_shape, optional,
            "How the control plans a path where the manuals leave it open.", into<&Settings::motion>},
    JsonKey{"disable", &codes_shape, optional,
            "Findings that are not reported, by code, name or beginning (AX1*).", by<store_codes<Settings>>},
    JsonKey{"severity", &severities_shape, optional,
            "Other severities of findings, by code, name or beginning (AX1*).", by<store_severities>},
    JsonKey{"schema", &configuration::json_texts, optional, "Schema files, relative to the settings."},
    JsonKey{"paths", &paths_shape, optional,
            "What holds for some files: findings that are not reported, a kind.", into<&Settings::paths>},
    JsonKey{
        "include", &configuration::json_texts, optional,
        "Patterns of the only files that are looked at where a folder is named, relative to the settings.",
        into<&Settings::included>},
    JsonKey{"exclude", &configuration::json_texts, optional,
            "Patterns of files that are left out where a folder is named, relative to the settings.",
            into<&Settings::excluded>}};

}  // namespace

constexpr JsonShape settings_shape{.kind = Kind::object, .title = "Settings of axisc", .keys = settings_keys};

namespace {

/// Paths are relative to the settings file, wherever the program runs.
void read_schema_files(LocatedFile const& file, JsonValue const& list, Settings& settings) {
  for (auto const item : list.items) {
    auto const& name = file[item].string;
    auto const path = system::name_of(
        (system::path_of(file.path()).parent_path() / system::path_of(name)).lexically_normal());
    if (system::kind_of(path) != system::FileKind::regular) {
      file.refuse(file[item].span, says::schema_missing, {{"file", name}});
    }
    settings.schema_files.push_back(path);
    settings.catalogue = with_schema_file(settings.catalogue, path);
  }
}

/// The path relative to `folder`, with slashes; the whole path if it is elsewhere.
std::string relative_to(std::string const& folder, std::string const& path) {
  std::error_code error;
  auto const absolute = fs::weakly_canonical(fs::absolute(system::path_of(path), error), error);
  auto const relative = absolute.lexically_relative(system::path_of(folder));
  return system::name_of(relative.empty() ? absolute : relative);
}

/// relative_to() of one folder; many patterns ask for the same file, and its links need not be resolved each
/// time.
class RelativeNames {
 public:
  explicit RelativeNames(std::string folder) : folder_(std::move(folder)) {}
  [[nodiscard]] std::string const& of(std::string const& path) {
    auto const [name, is_new] = names_.try_emplace(path);
    if (is_new) name->second = relative_to(folder_, path);
    return name->second;
  }

 private:
  std::string folder_;
  std::unordered_map<std::string, std::string> names_;
};

/// The path with all links resolved; if it does not exist, as far as it does.
fs::path canonical_folder(std::string const& folder) {
  if (auto const found = system::real_name(folder)) return system::path_of(*found);
  std::error_code error;
  return fs::weakly_canonical(fs::absolute(system::path_of(folder), error), error);
}

}  // namespace

Settings read_settings(std::string const& path, std::string const& folder) {
  LocatedFile const file(path, settings_shape, says::settings_json);
  Settings settings;
  settings.file = path;
  settings.folder = folder;
  file.fill(&settings);
  if (auto const* const list = file.find(file.root(), "schema")) read_schema_files(file, *list, settings);
  return settings;
}

schema::Catalogue SettingsFinder::catalogue(std::string const& input) {
  if (auto const* const settings = find(input)) return settings->catalogue;
  std::lock_guard const lock(mutex_);
  read_schema_files();
  return *without_settings_;
}

bool SettingsFinder::wants(std::string const& path) {
  auto const* const settings = find(path);
  if (settings == nullptr || (settings->included.empty() && settings->excluded.empty())) return true;
  auto const name = relative_to(settings->folder, path);
  auto const is_among = [&name](std::vector<std::string> const& patterns) {
    return std::any_of(patterns.begin(), patterns.end(),
                       [&name](std::string const& pattern) { return matches_glob(pattern, name); });
  };
  return !is_among(settings->excluded) && (settings->included.empty() || is_among(settings->included));
}

void SettingsFinder::read_schema_files() {
  if (!without_settings_) without_settings_ = with_schema_files({}, schema_files_);
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
  auto known = known_.find(system::name_of(folder));
  if (known == known_.end()) {
    std::optional<Settings> found;
    for (auto candidate = folder; !found; candidate = candidate.parent_path()) {
      auto const file = candidate / system::path_of(settings_file_name);
      if (system::kind_of(system::name_of(file)) == system::FileKind::regular) {
        auto const shown = fs::proximate(file, fs::current_path(error), error);
        found = read_settings(system::name_of(shown.empty() ? file : shown), system::name_of(candidate));
        found->catalogue = with_schema_files(found->catalogue, schema_files_);
      }
      if (candidate == candidate.parent_path()) break;
    }
    known = known_.emplace(system::name_of(folder), std::move(found)).first;
  }
  return known->second ? &*known->second : nullptr;
}

void add_settings_files(SettingsFinder& finder, std::string const& input, std::vector<std::string>& files) {
  if (auto const* const settings = finder.find(input)) {
    files.push_back(settings->file);
    files.insert(files.end(), settings->schema_files.begin(), settings->schema_files.end());
  }
  files.insert(files.end(), finder.schema_files().begin(), finder.schema_files().end());
}

validator::CheckOptions with_settings(validator::CheckOptions options, Settings const& settings,
                                      std::string const& input) {
  // A machine file has its own cycle time, which only the command line overrides.
  if (!options.cycle_time && !ascii::has_extension(input, ".json")) options.cycle_time = settings.cycle_time;
  if (!options.build) options.build = settings.build;
  options.readings = settings.readings;
  options.motion = settings.motion;
  options.catalogue = settings.catalogue;
  options.disabled.insert(options.disabled.end(), settings.disabled.begin(), settings.disabled.end());
  options.severities.insert(settings.severities.begin(), settings.severities.end());
  auto const names = std::make_shared<RelativeNames>(settings.folder);
  for (auto const& rule : settings.paths) {
    bool const tells_kind = !options.kind && rule.kind && !ascii::has_extension(input, ".json");
    if (tells_kind && matches_glob(rule.pattern, names->of(input))) options.kind = rule.kind;
    options.paths.push_back(
        {.covers = [names, pattern = rule.pattern](
                       auto const& file) { return matches_glob(pattern, names->of(file)); },
         .disabled = rule.disabled});
  }
  return options;
}

}  // namespace axisc
