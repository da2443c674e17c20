// Entries by key, in the packs of one folder. Several processes may use the folder at once: packs are never changed,
// new packs have unique names, and a removed pack stays readable for processes that have it open.
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
  /// Failure if the folder cannot be created. `limit`: bytes of all packs together.
  CacheStore(std::string folder, std::uint64_t limit);

  /// Like add(), may be called by several threads. A damaged entry counts as missing.
  [[nodiscard]] std::optional<std::string> find(Digest const& key);
  /// If the folder cannot be written, nothing more is stored, and finish() reports why.
  void add(Digest const& key, std::string_view content);
  /// Writes the added entries, records which entries were used, and removes the least recently used ones if the folder
  /// is larger than its limit. Failure (AX9002) if the folder cannot be written.
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

/// If the packs of `folder` are larger than `limit`, removes the least recently used entries down to three quarters of
/// it, so that this is rare. Many small packs are merged into one. One process does this at a time; others skip it.
/// Incomplete packs and files left by killed processes are removed when they are a day old.
void tidy_cache(std::string const& folder, std::uint64_t limit);

/// The complete packs of a folder, by name.
[[nodiscard]] std::vector<CachePack> open_packs(std::string const& folder);

[[nodiscard]] std::uint32_t seconds_now();

}  // namespace axisc::cli
