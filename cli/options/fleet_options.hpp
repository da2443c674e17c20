// Options of commands that work on many inputs: shards, keys, caches.
#pragma once

#include "cli/fleet/result_cache.hpp"
#include "cli/fleet/run_key.hpp"
#include "cli/fleet/shard.hpp"
#include "cli/fleet/shard_record.hpp"
#include "cli/options/command_line.hpp"
#include "cli/options/inputs.hpp"
#include "cli/report/console.hpp"
#include "cli/report/progress.hpp"

#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace axisc::cli {

struct FleetOptions {
  std::optional<std::string> shard;
  std::optional<std::string> cache;
  std::optional<std::string> cache_size;
  bool print_key = false;

  [[nodiscard]] bool asks_for_digests() const { return shard || cache || print_key; }
};

void declare_fleet(CommandLine& command_line, FleetOptions& options);

/// The inputs of this run, with their indices among all inputs.
struct Part {
  std::optional<Shard> shard;
  std::vector<std::string> all;
  std::vector<std::size_t> chosen;  ///< into `all`

  [[nodiscard]] std::string const& path(std::size_t index) const { return all[chosen[index]]; }
  [[nodiscard]] std::vector<std::string> paths() const;
};

/// Failure for an invalid shard.
[[nodiscard]] Part choose_part(FleetOptions const& options, std::vector<std::string> paths);
/// Failures that came before any input was read belong to the first shard, so that they are reported once.
[[nodiscard]] bool reports_names(Part const& part);

/// What `axisc merge` compares: equal for all shards of one run, whose options other than `run` are in `hasher`.
[[nodiscard]] std::optional<ShardRecord> shard_record(Part const& part, Hasher hasher, Digest const& run,
                                                      CheckJob const& job, bool werror);

/// The requested cache; null, with a warning, if it cannot be used.
[[nodiscard]] std::unique_ptr<ResultCache> open_cache(FleetOptions const& options, Console& err,
                                                      Language language);
void finish_cache(std::unique_ptr<ResultCache> cache, FleetOptions const& options, Console& err,
                  Language language);

}  // namespace axisc::cli
