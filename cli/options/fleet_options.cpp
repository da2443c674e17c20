#include "cli/options/fleet_options.hpp"

#include "cli/failure.hpp"
#include "system/path.hpp"

#include <filesystem>
#include <utility>

namespace axisc::cli::says {

constexpr Sentence option_shard{
    "only the inputs of part I of N (from 1/N to N/N); a path is always in the same part",
    "nur die Eingaben von Teil I von N (1/N bis N/N); ein Pfad liegt immer im selben Teil"};
constexpr Sentence option_print_key{
    "print a digest of everything that the result depends on, and do nothing else",
    "einen Fingerabdruck von allem ausgeben, wovon das Ergebnis abhängt, und sonst nichts tun"};
constexpr Sentence option_cache{
    "store results in this folder and reuse those that are still valid; several processes may share it",
    "Ergebnisse in diesem Ordner speichern und noch gültige wiederverwenden; mehrere Prozesse dürfen ihn "
    "teilen"};
constexpr Sentence option_cache_size{
    "how large the cache folder may grow, as in 500M or 2G (default: 1G); the least recently used results "
    "are removed",
    "wie groß der Cache-Ordner werden darf, etwa 500M oder 2G (Standardwert: 1G); die am längsten nicht "
    "gebrauchten Ergebnisse werden gelöscht"};
constexpr Sentence cache_unusable{
    "the cache {folder} cannot be used: {reason}; continuing without it",
    "der Cache {folder} ist nicht verwendbar: {reason}; es geht ohne ihn weiter"};

}  // namespace axisc::cli::says

namespace axisc::cli {

void declare_fleet(CommandLine& command_line, FleetOptions& options) {
  command_line.value("--shard", "I/N", options.shard, says::option_shard);
  command_line.value("--cache", "FOLDER", options.cache, says::option_cache);
  command_line.value("--cache-size", "SIZE", options.cache_size, says::option_cache_size);
  command_line.flag("--print-key", options.print_key, says::option_print_key);
}

std::vector<std::string> Part::paths() const {
  std::vector<std::string> paths;
  paths.reserve(chosen.size());
  for (auto const index : chosen) paths.push_back(all[index]);
  return paths;
}

Part choose_part(FleetOptions const& options, std::vector<std::string> paths) {
  Part part{.shard = {}, .all = std::move(paths), .chosen = {}};
  if (options.shard) part.shard = parse_shard(*options.shard);
  std::error_code error;
  auto const folder = part.shard ? system::name_of(std::filesystem::current_path(error)) : std::string();
  for (std::size_t i = 0; i < part.all.size(); ++i) {
    if (!part.shard || is_in_shard(*part.shard, part.all[i], folder)) part.chosen.push_back(i);
  }
  return part;
}

bool reports_names(Part const& part) {
  return !part.shard || part.shard->index == 1;
}

std::optional<ShardRecord> shard_record(Part const& part, Hasher hasher, Digest const& run,
                                        CheckJob const& job, bool werror) {
  if (!part.shard) return std::nullopt;
  hasher.digest(run);
  hasher.number(part.shard->count);
  for (auto const& path : part.all) {
    hasher.text(path);
    hasher.digest(job.settings->digest(path));
  }
  ShardRecord record;
  record.shard = *part.shard;
  record.version = AXISC_VERSION;
  record.werror = werror;
  record.run = hexadecimal(hasher.finish());
  return record;
}

std::unique_ptr<ResultCache> open_cache(FleetOptions const& options, Console& err, Language language) {
  auto const limit =
      options.cache_size ? parse_size("--cache-size", *options.cache_size) : ResultCache::usual_size;
  if (!options.cache) return nullptr;
  try {
    return std::make_unique<ResultCache>(*options.cache, limit);
  } catch (Failure const& failure) {
    err.write(
        warning_line({.sentence = says::cache_unusable,
                      .arguments = {{"folder", *options.cache}, {"reason", failure.sentence(language)}}},
                     language));
    return nullptr;
  }
}

void finish_cache(std::unique_ptr<ResultCache> cache, FleetOptions const& options, Console& err,
                  Language language) {
  if (!cache) return;
  try {
    cache->finish();
  } catch (Failure const& failure) {
    err.write(
        warning_line({.sentence = says::cache_unusable,
                      .arguments = {{"folder", *options.cache}, {"reason", failure.sentence(language)}}},
                     language));
  }
}

}  // namespace axisc::cli
