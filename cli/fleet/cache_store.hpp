// Entries by key, in the packs of one folder. Several processes may use the folder at once: packs are never changed, new
// ones appear under names of their own, and one that is removed stays readable for those who have it open.
#pragma once

#include "cli/failure.hpp"
#include "cli/fleet/cache_pack.hpp"

#include <cstdint>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <unordered_map>
#include <vector>

namespace axisc::cli {

class CacheStore {
 public:
  /// Failure where the folder cannot be made. `limit`: bytes of all packs together.
  CacheStore(std::string folder, std::uint64_t limit);

  /// May be called by several threads, as add(). A damaged entry is none.
  [[nodiscard]] std::optional<std::string> find(Digest const& key);
  /// Where the folder cannot be written nothing is kept any more, and finish() says why.
  void add(Digest const& key, std::string_view content);
  /// Failure (AX9002) where the folder cannot be written. Puts what was added in its place, notes what was used, and removes what was used longest ago where the folder is
  /// larger than its limit.
  void finish();

 private:
  struct Place {
    std::uint32_t pack = 0;
    std::uint32_t row = 0;
  };
  struct KeyHash {
    std::size_t operator()(Digest const& key) const { return key.low; }
  };

  std::string folder_;
  std::uint64_t limit_;
  std::vector<CachePack> packs_;
  std::unordered_map<Digest, Place, KeyHash> places_;
  std::mutex mutex_;
  std::vector<std::vector<std::uint32_t>> used_;  ///< rows, by pack
  std::unique_ptr<PackWriter> writer_;
  std::optional<Failure> broken_;
};

/// Brings the packs of `folder` that are larger than `limit` down to three quarters of it, so that this is rare: what was
/// used longest ago is removed. Many small packs become one. One process does this at a time; another one leaves it to that. Packs
/// that are no whole ones are removed, and files that killed processes left, when they are a day old.
void tidy_cache(std::string const& folder, std::uint64_t limit);

/// The whole packs of a folder, by name.
[[nodiscard]] std::vector<CachePack> open_packs(std::string const& folder);

[[nodiscard]] std::uint32_t seconds_now();

}  // namespace axisc::cli
