// Results of earlier runs, by what they depend on.
//
// A result is looked for by everything that is known beforehand (the run, the name of the input, the digest of its
// content), and is right only where all other files that were read for it (the lists of a machine, its programs) are
// what they were. So a changed machine file finds an old result again when it is changed back, whereas of several states
// of a list that a machine names the last one is kept.
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

  /// Failure (AX9002) where the folder cannot be made.
  ResultCache(std::string const& folder, std::uint64_t limit)
      : store_(folder, limit), digests_(folder + "/files") {}

  /// Failure (AX9002) where the folder cannot be written.
  void finish() {
    store_.finish();
    digests_.save();
  }

 private:
  friend class CachedInput;

  CacheStore store_;
  FileDigests digests_;
};

/// One look-up: asks the cache, and otherwise watches how the result is made.
class CachedInput {
 public:
  /// `run` names everything that the result depends on beside files.
  CachedInput(ResultCache& cache, Digest const& run, std::string path)
      : cache_(cache), run_(run), path_(std::move(path)), files_(&cache.digests_) {}

  [[nodiscard]] std::optional<std::string> find();
  /// To make the result with.
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
