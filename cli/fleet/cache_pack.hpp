// One file of a cache: many entries, written once and never changed, except for the times of last use.
//
//   "axpack01"  content of the entries, one behind the other
//   table       one row per entry, by key
//   last uses   seconds since 1970, 4 bytes per row; the only part that is written again, and not covered by a checksum
//   footer      number of rows, where the table begins, checksum of the table, "axpkend1"
//
// Entries have a checksum each, so a truncated or damaged pack never gives a wrong entry.
#pragma once

#include "cli/files/output_file.hpp"
#include "cli/fleet/digest.hpp"
#include "system/file.hpp"

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace axisc::cli {

inline constexpr std::string_view pack_extension = ".axpack";
/// A pack of this size, or with this many entries, is complete.
inline constexpr std::uint64_t full_pack = std::uint64_t{64} << 20U;
inline constexpr std::size_t full_table = std::size_t{1} << 20U;

struct PackRow {
  Digest key;
  std::uint64_t offset = 0;
  std::uint64_t size = 0;
  std::uint64_t checksum = 0;
};

class CachePack {
 public:
  /// None for a file that cannot be read or is not a complete pack, and for a link, a pipe or a device.
  [[nodiscard]] static std::optional<CachePack> open(std::string const& path);

  [[nodiscard]] std::string const& path() const { return path_; }
  [[nodiscard]] std::uint64_t file_size() const { return file_size_; }
  [[nodiscard]] std::vector<PackRow> const& rows() const { return rows_; }
  [[nodiscard]] std::uint32_t last_use(std::size_t row) const { return last_uses_[row]; }

  /// None if the content does not match its checksum.
  [[nodiscard]] std::optional<std::string> read(std::size_t row) const;
  /// Records that these rows were used now. Best effort: does nothing in a read-only cache.
  void mark_used(std::vector<std::uint32_t> const& rows, std::uint32_t now);

 private:
  CachePack() = default;

  std::string path_;
  system::File file_;
  std::uint64_t file_size_ = 0;
  std::uint64_t uses_begin_ = 0;
  std::vector<PackRow> rows_;
  std::vector<std::uint32_t> last_uses_;
};

/// Writes a new pack into `folder`. Not thread-safe.
class PackWriter {
 public:
  /// This and the functions below: Failure (AX9002) if the folder cannot be written.
  explicit PackWriter(std::string const& folder);

  void add(Digest const& key, std::string_view content, std::uint32_t last_use);
  [[nodiscard]] bool is_full() const { return offset_ >= full_pack || entries_.size() >= full_table; }
  void commit();

 private:
  struct Entry {
    PackRow row;
    std::uint32_t last_use = 0;
  };

  OutputFile file_;
  std::uint64_t offset_ = 0;
  std::string buffer_;
  std::vector<Entry> entries_;
};

}  // namespace axisc::cli
