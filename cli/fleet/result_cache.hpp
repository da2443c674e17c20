// Cache of results, keyed by everything they depend on.
//
// The key contains everything that is known beforehand (the run, the name of the input, the digest of its content). A
// result is valid only if all other files that were read for it (the lists of a machine, its programs) are unchanged.
// So a machine file that is changed back finds its old result again, whereas only the last state of a list that a
// machine names is kept.
#pragma once

#include "cli/fleet/cache_store.hpp"
#include "cli/fleet/recorded_files.hpp"

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

namespace axisc::cli {

class ResultCache {
 public:
  static constexpr std::uint64_t usual_size = std::uint64_t{1} << 30U;

  /// Failure (AX9002) if the folder cannot be created.
  ResultCache(std::string const& folder, std::uint64_t limit)
      : store_(folder, limit), digests_(folder + "/files") {}

  /// Failure (AX9002) if the folder cannot be written.
  void finish() {
    store_.finish();
    digests_.save();
  }

 private:
  friend class CachedInput;

  CacheStore store_;
  FileDigests digests_;
};

/// One look-up: queries the cache; on a miss, records the files read for the result.
class CachedInput {
 public:
  /// `run` is a digest of everything that the result depends on besides files.
  CachedInput(ResultCache& cache, Digest const& run, std::string path)
      : cache_(cache), run_(run), path_(std::move(path)), files_(&cache.digests_) {}

  [[nodiscard]] std::optional<std::string> find();
  /// Read the files of the result through these, so that they are recorded.
  [[nodiscard]] configuration::Files& files() { return files_; }
  void keep(std::string_view result);

 private:
  [[nodiscard]] Digest key(Digest const& content) const;

  ResultCache& cache_;
  Digest run_;
  std::string path_;
  RecordedFiles files_;
};

/// "500M", "2G", "1048576". Failure, which names `option`, for anything else.
[[nodiscard]] std::uint64_t parse_size(std::string_view option, std::string const& text);

}  // namespace axisc::cli
